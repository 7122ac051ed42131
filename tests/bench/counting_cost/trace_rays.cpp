#include "accel/bvh/bvh.h"
#include "bench/statistics/random.h"

#include <cstdio>
#include <cstdlib>

/// Traces the same rays through the same bvh, as often as the argument says.
namespace rayshoot {
namespace {

vec3 point(Sequence& random) {
    const float x = random.unit(), y = random.unit(), z = random.unit();
    return {x, y, z};
}

Geometry soup(Sequence& random) {
    GeometryBuilder builder;
    for (int i = 0; i < 2000; ++i) {
        const vec3 corner = point(random);
        builder.add_triangle(corner, corner + 0.05f * point(random),
                             corner + 0.05f * point(random));
    }
    return std::move(builder).build();
}

std::vector<Ray> chords(Sequence& random) {
    std::vector<Ray> rays(8 * default_batch);
    for (Ray& ray : rays) {
        ray.origin = point(random);
        ray.direction = point(random) - ray.origin;
    }
    return rays;
}

std::size_t trace(Session& session, std::span<const Ray> rays) {
    std::vector<Hit> hits(default_batch);
    std::vector<std::uint8_t> occluded(default_batch);
    std::size_t found = 0;
    for (std::size_t first = 0; first < rays.size(); first += default_batch) {
        const RayBatch batch{RayKind::secondary, 1, rays.subspan(first, default_batch), {}};
        session.closest(batch, hits);
        session.occluded(batch, occluded);
        for (const Hit& hit : hits) found += hit.primitive != no_primitive;
        for (const std::uint8_t bit : occluded) found += bit;
    }
    return found;
}

}  // namespace
}  // namespace rayshoot

int main(int argc, char** argv) {
    using namespace rayshoot;
    const int passes = argc > 1 ? std::atoi(argv[1]) : 1;
    Sequence random(1);
    const Geometry geometry = soup(random);
    const std::vector<Ray> rays = chords(random);
    const StructureAccel<Bvh> accel({geometry}, Options("bvh", Bvh::options, ""), "bvh");
    const auto session = accel.open(Mode::timing);
    std::size_t found = 0;
    for (int pass = 0; pass < passes; ++pass) found += trace(*session, rays);
    std::printf("%zu\n", found);
}
