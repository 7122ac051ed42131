#pragma once

#include <cstddef>
#include <vector>

namespace rayshoot {

/// A number per pixel, row by row from the top left: costs, weights, differences.
class ScalarImage {
public:
    ScalarImage() = default;
    ScalarImage(int width, int height, double value = 0)
        : width_(width),
          height_(height),
          values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

    int width() const { return width_; }
    int height() const { return height_; }
    double at(int x, int y) const { return values_[index(x, y)]; }
    double& at(int x, int y) { return values_[index(x, y)]; }
    const std::vector<double>& values() const { return values_; }
    bool operator==(const ScalarImage&) const = default;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<double> values_;
};

}  // namespace rayshoot
