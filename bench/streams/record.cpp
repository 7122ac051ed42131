#include "bench/streams/record.h"

#include "bench/gate/gate.h"
#include "tracer/recorder.h"

#include <stdexcept>

namespace rayshoot {
namespace {

const RecordedRays& rays_of(const RecordedStreams& streams, StreamKind kind) {
    switch (kind) {
        case StreamKind::camera:
            return streams.camera;
        case StreamKind::shadow:
            return streams.shadow;
        case StreamKind::diffuse:
            return streams.diffuse;
        case StreamKind::random:
            return streams.random;
        case StreamKind::mirror:
            return streams.secondary;
    }
    throw std::logic_error("a ray kind without rays");
}

RayKind batch_kind_of(StreamKind kind) {
    if (kind == StreamKind::camera) return RayKind::camera;
    return kind == StreamKind::shadow ? RayKind::shadow : RayKind::secondary;
}

void require_affordable(const ImageFormat& format) {
    require_valid(format);
    const auto rays = static_cast<std::size_t>(format.width) *
                      static_cast<std::size_t>(format.height) *
                      static_cast<std::size_t>(format.spp);
    if (rays <= most_recorded_rays) return;
    throw std::invalid_argument(std::to_string(rays) + " camera rays are too many to record; " +
                                std::to_string(most_recorded_rays) +
                                " is the limit: take a smaller --size or --spp");
}

}  // namespace

std::vector<RayStream> record_streams(const Catalogue& catalogue, const Scene& scene,
                                      std::span<const StreamKind> kinds,
                                      const ImageFormat& format) {
    require_affordable(format);
    const auto accel = build(catalogue, reference_spec, build_input(scene, format));
    const RecordedStreams recorded = record_streams(scene, *accel, format);
    std::vector<RayStream> streams;
    for (const StreamKind kind : kinds) {
        RayStream& stream = streams.emplace_back();
        stream.scene = scene.name;
        stream.kind = kind;
        stream.batch_kind = batch_kind_of(kind);
        stream.question = kind == StreamKind::shadow ? Query::occluded : Query::closest;
        stream.depth = kind == StreamKind::diffuse || kind == StreamKind::mirror ? 2 : 1;
        stream.width = format.width;
        stream.height = format.height;
        stream.samples = format.spp;
        stream.rays = rays_of(recorded, kind).rays;
        stream.sources = rays_of(recorded, kind).sources;
    }
    return streams;
}

ImageFormat format_of(const RayStream& stream, const ImageFormat& otherwise) {
    if (stream.width == 0 || stream.height == 0 || stream.samples == 0) return otherwise;
    return {stream.width, stream.height, stream.samples, Raster::centres, 0};
}

}  // namespace rayshoot
