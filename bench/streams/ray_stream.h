#pragma once

#include "accel/core/ray.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Rays recorded once, in the order in which every structure then traces them.
namespace rayshoot {

/// camera: through the image, tiles in Morton order; shadow: from the camera's hits to the lights;
/// diffuse: one cosine-weighted bounce off them; random: chords of the scene's bounding sphere;
/// mirror: reflected and refracted rays of the camera's hits, where the materials make any.
enum class StreamKind : std::uint8_t { camera, shadow, diffuse, random, mirror };
inline constexpr std::array<std::string_view, 5> stream_kind_names{"camera", "shadow", "diffuse",
                                                                   "random", "mirror"};
/// What is measured unless other kinds are asked for.
inline constexpr std::array<StreamKind, 4> usual_stream_kinds{
    StreamKind::camera, StreamKind::shadow, StreamKind::diffuse, StreamKind::random};

std::string_view name_of(StreamKind kind);
/// Throws std::invalid_argument, listing the kinds there are.
StreamKind stream_kind(std::string_view name);

struct RayStream {
    std::string scene;  ///< the scene string it was recorded on
    StreamKind kind = StreamKind::random;
    RayKind batch_kind = RayKind::secondary;
    Query question = Query::closest;
    std::uint8_t depth = 1;                  ///< level in the ray tree
    int width = 0, height = 0, samples = 0;  ///< of the image it was recorded from
    std::vector<Ray> rays;
    std::vector<Source> sources;  ///< empty, or one per ray

    std::size_t size() const { return rays.size(); }
    /// `count` rays from `first` on as one batch, as many as there are.
    RayBatch batch(std::size_t first, std::size_t count) const;
};

/// Every ray whose number is in `chosen`, in that order.
RayStream selection(const RayStream& stream, const std::vector<std::size_t>& chosen);

/// `count` ray numbers, ascending, one seeded draw from each of `count` equal parts of the stream;
/// all of them when count >= size.
std::vector<std::size_t> spread_sample(std::size_t size, std::size_t count, std::uint64_t seed);

}  // namespace rayshoot
