#pragma once

#include "accel/core/intersector.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tracer/camera.h"
#include "tracer/image.h"
#include "tracer/shading.h"

/// Whitted ray tracing of one tile, in waves: all rays of one depth are traced in batches, shaded,
/// and spawn the shadow rays and the next wave. Every structure sees the same batches.
namespace rayshoot {

enum class Cause : std::uint8_t { camera, shadow, reflection, refraction };
inline constexpr std::array<std::string_view, 4> cause_names{"camera", "shadow", "reflection",
                                                             "refraction"};

struct RayCount {
    std::uint64_t rays = 0, hits = 0;
    bool operator==(const RayCount&) const = default;
};

/// Rays and hits by what caused the ray; secondary rays are the reflected and the refracted ones.
struct RayCounts {
    std::array<RayCount, 4> by_cause{};
    /// Refractions that were not traced. Published tables count them as rays without a hit.
    std::uint64_t totally_reflected = 0;

    RayCount& operator[](Cause cause) { return by_cause[static_cast<std::size_t>(cause)]; }
    const RayCount& operator[](Cause cause) const {
        return by_cause[static_cast<std::size_t>(cause)];
    }
    RayCount of(RayKind kind) const;
    RayCounts& operator+=(const RayCounts& other);
    bool operator==(const RayCounts&) const = default;
};

inline constexpr int largest_depth = 255;  ///< RayBatch::depth is a byte

/// The rules of a whole image.
struct WavefrontSettings {
    Rules rules = Rules::spd_readme;
    int depth = 5;                      ///< levels of the ray tree; the camera ray's is 1
    std::size_t batch = default_batch;  ///< most rays in one call, 1 to max_batch
};

/// Traces one tile after the other with one session. The sum of a pixel is formed in an order that
/// depends on its tile alone, and tiles share no pixel: images depend on neither structure nor
/// lanes.
class Wavefront {
public:
    Wavefront(const Scene& scene, const CameraRays& camera, const WavefrontSettings& settings,
              Session& session, Image& image);

    /// Adds the tile's radiance, averaged over the samples, to the image.
    void trace(std::span<const Pixel> tile);
    const RayCounts& counts() const { return counts_; }

private:
    /// What is left to know of a ray when its hit comes back.
    struct Path {
        Pixel pixel;
        Cause cause;
        float weight;
    };
    struct Wave {
        std::vector<Ray> rays;
        std::vector<Path> paths;
        std::vector<Source> sources;  ///< of camera rays only

        void clear();
        void append(const Wave& other);
    };
    struct Shadows {
        std::vector<Ray> rays;
        std::vector<Source> sources;
        std::vector<Pixel> pixels;
        std::vector<vec3> radiances;  ///< weighted

        void clear();
    };

    void start(std::span<const Pixel> tile);
    void trace_batch(std::size_t first, std::size_t count, int depth);
    void shade(const Path& path, const Ray& ray, const Hit& hit, int depth);
    void spawn(const Shade& shade, const Path& path);
    void trace_shadows(Shadows& shadows, int depth);

    const Scene& scene_;
    const CameraRays& camera_;
    WavefrontSettings settings_;
    Session& session_;
    Image& image_;
    RayCounts counts_;
    Wave wave_, reflections_, refractions_;
    std::vector<Shadows> shadows_;  ///< one per light
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> occluded_;
};

}  // namespace rayshoot
