#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tracer/film/film.h"
#include "tracer/filter/splat_footprint.h"

/// What the samples of a tile give to the pixels within their reach, before it goes into the film.
namespace rayshoot {

/// Of weighted red, green and blue, and of the weights. In double: the product of two floats is
/// exact, so that what is lost in a quotient of sums is far below a float's last bit.
struct alignas(32) Sum {
    std::array<double, 4> of{};

    void add(const std::array<double, 4>& light, double weight) {
        for (std::size_t i = 0; i < 4; ++i) of[i] += weight * light[i];
    }
    Sum& operator+=(const Sum& other) {
        for (std::size_t i = 0; i < 4; ++i) of[i] += other.of[i];
        return *this;
    }
};

/// Pixels with left <= x < right and top <= y < bottom.
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
    int width() const { return right - left; }
    std::size_t area() const {
        return static_cast<std::size_t>(width()) * static_cast<std::size_t>(bottom - top);
    }
    Rectangle widened(int border) const {
        return {left - border, top - border, right + border, bottom + border};
    }
};
Rectangle intersection(const Rectangle& a, const Rectangle& b);

/// A rectangle of sums.
class Patch {
public:
    Patch() = default;
    explicit Patch(const Rectangle& pixels) : pixels_(pixels), sums_(pixels.area()) {}

    const Rectangle& pixels() const { return pixels_; }
    /// From (x, y) on, to the right.
    const Sum* row(int x, int y) const { return sums_.data() + index(x, y); }
    Sum* row(int x, int y) { return sums_.data() + index(x, y); }
    /// Null for a pixel that is not in here.
    Sum* find(int x, int y) {
        const Rectangle& p = pixels_;
        const bool inside = x >= p.left && x < p.right && y >= p.top && y < p.bottom;
        return inside ? row(x, y) : nullptr;
    }
    /// `other` lies within this one.
    void add(const Patch& other);

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - pixels_.top) *
                   static_cast<std::size_t>(pixels_.width()) +
               static_cast<std::size_t>(x - pixels_.left);
    }
    Rectangle pixels_;
    std::vector<Sum> sums_;
};

/// Splats samples, in their order, on patches within `image`. Several, because a tile that goes
/// along a Morton curve may have its two ends far apart.
std::vector<Patch> splat(std::span<const FilmSample> samples, const SplatFootprint& footprint,
                         const Rectangle& image);

}  // namespace rayshoot
