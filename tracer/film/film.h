#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "tracer/camera.h"
#include "tracer/filter/filter.h"
#include "tracer/image.h"

/// The image under construction: from the radiances of camera samples to filtered pixels.
namespace rayshoot {

/// What becomes of samples, and what their `weight` is.
/// importance: a pixel has samples of its own, at Filter::importance offsets; it is their mean.
/// weighted: likewise at Filter::uniform offsets; it is their sum over the sum of weights.
/// splat: samples are uniform in their cell and are added to every pixel within reach with the
/// filter's weight (Smits); a pixel is their sum over the sum of weights. splat_undivided: the
/// weights are divided by the filter's integral instead, which keeps the energy of each sample but
/// for the ripple of sample_sum.h, and is not flat on a flat field.
enum class Reconstruction : std::uint8_t { importance, weighted, splat, splat_undivided };
inline constexpr std::array<std::string_view, 4> reconstruction_names{"importance", "weighted",
                                                                      "splat", "splat_undivided"};
/// By its name; throws std::invalid_argument, listing the names, for another one.
Reconstruction reconstruction(std::string_view name);
std::string_view name(Reconstruction reconstruction);

/// One traced camera sample.
struct FilmSample {
    Pixel pixel;         ///< importance, weighted: that it is for; splat: the cell it is in
    float x = 0, y = 0;  ///< splat: where in the cell, from its top left corner, in [0, 1)
    vec3 radiance{0};
    float weight = 1;  ///< importance, weighted: its Filter::Offset's; splat: 1 / samples in cell
};

/// Any number of lanes may add to it; the image's bits do not depend on which, or when.
class Film {
public:
    /// Throws std::invalid_argument for a size out of 1 to largest_image, and for splats of a disc
    /// of a radius below 0.75, which may fall between all middles of pixels.
    Film(int width, int height, const Filter& filter, Reconstruction reconstruction);
    ~Film();
    Film(Film&&) noexcept;
    Film& operator=(Film&&) noexcept;

    /// How far beyond the image, on each side, camera rays pass: View::border.
    int border() const;
    /// How many cells beyond the image, on each side, have samples of their own: border() when
    /// splatting, else 0.
    int traced_border() const;

    /// Hands in the samples of a whole tile, in the order in which they are to be summed. Tiles are
    /// numbered from 0 and each is handed in once; but for splatting they share no pixel. Sums are
    /// formed in the order of numbers: what comes too early waits, at most about as much memory as
    /// the film itself times (1 + 2 border / edge of a tile)^2. Samples that reach no pixel are
    /// ignored.
    void add(std::size_t tile, std::span<const FilmSample> samples);
    /// Of the tiles handed in so far, while others may be adding. Pixels that no sample has reached
    /// are black.
    Image image() const;
    /// Tiles that wait for one of a lower number.
    std::size_t waiting() const;

private:
    class Sums;
    std::unique_ptr<Sums> sums_;
};

}  // namespace rayshoot
