#pragma once

#include "accel/core/build_input.h"
#include "accel/core/ray.h"
#include "data/scene.h"
#include "tracer/sampling/pair.h"

#include <cstdint>

/// From a scene's camera and an image size to a View, and from a View to camera rays.
namespace rayshoot {

/// Where the rays of an image go through.
/// corners: the SPD testing rules. The outermost rays are `Camera::angle` apart, so 513 x 513 rays
/// are the corners of 512 x 512 pixels: slope (2i / 512 - 1) tan(angle / 2). Cells of the raster
/// are then centred on the corners. centres: the image is `Camera::angle` high and rays go through
/// the middle of its pixels.
enum class Raster : std::uint8_t { corners, centres };

/// What an image is made of; one cell of the raster, with `spp` camera rays, becomes one pixel.
struct ImageFormat {
    int width = 513, height = 513;  ///< cells, 1 to largest_image each
    int spp = 1;                    ///< camera rays per cell (Sampler)
    Raster raster = Raster::corners;
    std::uint32_t seed = 0;  ///< of all random numbers
};
inline constexpr int largest_image = 32767;  ///< cells along an axis: Source::cell holds int16
inline constexpr int largest_spp = 1 << 16;

/// 513 x 513 corner rays, as the SPD testing rules ask for.
inline constexpr ImageFormat spd_format{};
/// 512 x 512 pixel centres: the format for meshes.
inline constexpr ImageFormat mesh_format{512, 512, 1, Raster::centres, 0};

/// Throws std::invalid_argument, saying what is accepted, for a size or sample count out of range.
void require_valid(const ImageFormat& format);

/// `border`: cells outside the image, on each side, that rays may go through (Film::border()).
/// `hither` is not applied: the SPD tables are of unclipped scenes. Throws std::invalid_argument
/// for a camera that looks nowhere (from = at), along its up vector, or at an angle outside (0,
/// 180), for a lens or a motion that is none (require_valid, require_rigid), and for a border that
/// is negative or reaches beyond largest_image.
View make_view(const Camera& camera, const ImageFormat& format, int border = 0);

/// What a structure for rendering `scene` in this format is built from; refers to `scene`.
BuildInput build_input(const Scene& scene, const ImageFormat& format, int border = 0);

struct Pixel {
    std::int16_t x = 0, y = 0;
    bool operator==(const Pixel&) const = default;
};

/// The camera rays of an image.
class CameraRays {
public:
    /// Throws as make_view does.
    CameraRays(const Camera& camera, const ImageFormat& format, int border = 0);

    /// Through raster point (x, y), in cells from the image's upper left corner, border included.
    /// `lens` is mapped to the aperture (without a lens it is not used): the ray leaves there and
    /// meets the pinhole's ray through (x, y) on the plane in focus, at t = focus distance. `time`:
    /// shutter time in [0, 1]; a moving camera is taken where it is then. Its Source is
    /// source(x, y).
    Ray ray(double raster_x, double raster_y, Pair lens, float time) const {
        // In double, so that the only rounding is the last one.
        const dvec3 direction = to_corner_ + across_ * raster_x + down_ * raster_y;
        return placed(lens_ ? on_lens(lens) : dvec3(0), direction, time);
    }

    /// The cell that a raster point lies in.
    static Pixel cell(double raster_x, double raster_y) {
        return {static_cast<std::int16_t>(std::floor(raster_x)),
                static_cast<std::int16_t>(std::floor(raster_y))};
    }
    static Source source(double raster_x, double raster_y) {
        return source(cell(raster_x, raster_y));
    }

    /// Through the middle of a cell and of the lens, at time 0.
    Ray ray(Pixel pixel) const;
    static Source source(Pixel pixel) { return Source::cell(pixel.x, pixel.y); }

    const View& view() const { return view_; }
    const ImageFormat& format() const { return format_; }

private:
    void open_lens(const Camera& camera);
    /// Relative to the eye, before the camera moves.
    dvec3 on_lens(Pair lens) const;
    /// From `on_lens`; `direction`: of the pinhole's ray.
    Ray placed(const dvec3& on_lens, const dvec3& direction, float time) const {
        vec3 origin = view_.eye, aim(direction);
        if (lens_ || view_.motion) {
            origin = vec3(moved(dvec3(view_.eye) + on_lens, time));
            aim = focused(origin, direction, time);
        }
        return {.origin = origin, .direction = aim, .time = time};
    }
    dvec3 moved(dvec3 at_rest, float time) const;
    vec3 focused(vec3 origin, dvec3 direction, float time) const;

    ImageFormat format_;
    View view_;
    std::optional<Lens> lens_;
    dvec3 right_, up_;                 ///< orthonormal
    dvec3 to_corner_, across_, down_;  ///< the view's, before they were rounded
};

}  // namespace rayshoot
