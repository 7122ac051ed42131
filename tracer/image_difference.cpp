#include "tracer/image_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

void require_same_size(const Image& a, const Image& b) {
    if (a.width() == b.width() && a.height() == b.height()) return;
    const auto size = [](const Image& image) {
        return std::to_string(image.width()) + " x " + std::to_string(image.height());
    };
    throw std::invalid_argument("images of " + size(a) + " and of " + size(b) +
                                " pixels cannot be compared; render both at one size");
}

/// |a - b|; NaN where one of them alone is a number, or they are different infinities.
double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double apart = std::abs(double{a} - double{b});
    return std::isfinite(apart) ? apart : std::numeric_limits<double>::quiet_NaN();
}

/// Adds the channels of pixels up.
class Summary {
public:
    explicit Summary(double tolerance) : tolerance_(tolerance) {}

    void add(Pixel at, const vec3& a, const vec3& b) {
        bool differs = false, comparable = true;
        for (int channel = 0; channel < 3; ++channel) {
            const double apart = distance(a[channel], b[channel]);
            if (std::isnan(apart)) {
                comparable = false;
                continue;
            }
            differs |= apart > tolerance_;
            squares_ += apart * apart;
            ++channels_;
            if (apart > result_.largest) {
                result_.largest = apart;
                result_.largest_at = at;
            }
        }
        ++result_.pixels;
        result_.differing += differs || !comparable;
        result_.incomparable += !comparable;
    }

    ImageDifference result() const {
        ImageDifference result = result_;
        if (channels_ > 0) result.rms = std::sqrt(squares_ / static_cast<double>(channels_));
        return result;
    }

private:
    double tolerance_, squares_ = 0;
    std::size_t channels_ = 0;
    ImageDifference result_;
};

}  // namespace

ImageDifference compare_images(const Image& a, const Image& b, double tolerance) {
    require_same_size(a, b);
    Summary summary(tolerance);
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const Pixel at{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
            summary.add(at, a.at(x, y), b.at(x, y));
        }
    }
    return summary.result();
}

ScalarImage difference_map(const Image& a, const Image& b) {
    require_same_size(a, b);
    ScalarImage map(a.width(), a.height());
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            double& largest = map.at(x, y);
            for (int channel = 0; channel < 3; ++channel) {
                const double apart = distance(a.at(x, y)[channel], b.at(x, y)[channel]);
                if (std::isnan(apart) || std::isnan(largest)) largest = apart + largest;
                else largest = std::max(largest, apart);
            }
        }
    }
    return map;
}

Image signed_difference(const Image& a, const Image& b) {
    require_same_size(a, b);
    Image result(a.width(), a.height());
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) result.at(x, y) = a.at(x, y) - b.at(x, y);
    }
    return result;
}

}  // namespace rayshoot
