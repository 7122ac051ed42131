#include "bench/textbook/figures.h"
#include "bench/textbook/filtered.h"
#include "bench/textbook/pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// f(x, y) = (1 + sin x) |sinc(x / 20)| on [-150, 150], with sinc t = sin t / t. The book does not
/// say how coarsely it samples; here a pixel is 5 wide, so that sin x has 0.8 cycles a pixel.
namespace rayshoot::textbook {
namespace {

constexpr double half_range = 150, pixel_width = 5;
constexpr int pixels = static_cast<int>(2 * half_range / pixel_width) + 1;  // the ends are samples
constexpr double cycles_per_pixel = pixel_width / (2 * std::numbers::pi);
constexpr int subdivisions_of_pixel = 16;
constexpr double textbook_radius = 1.7;  // "radius typically 1.5-1.7 pixel intervals"

double envelope(double x) {
    const double t = x / 20;
    return t == 0 ? 1 : std::abs(std::sin(t) / t);
}

double test_value(double x) { return (1 + std::sin(x)) * envelope(x); }

/// The signal of low frequency that has the same samples: 5 - 2 pi radians a pixel are left of 5.
double alias_value(double x) {
    return (1 + std::sin((1 - 2 * std::numbers::pi / pixel_width) * x)) * envelope(x);
}

double middle_of(int pixel) { return -half_range + pixel * pixel_width; }

/// As a raster of pixels whose middles are the samples.
Signal as_raster(double (*value)(double)) {
    return [value](double x, double) { return value(middle_of(0) + (x - 0.5) * pixel_width); };
}

Series row_of(const ScalarImage& image, std::string name, Series::Mark mark) {
    Series series{std::move(name), mark, {}};
    for (int x = 0; x < image.width(); ++x) {
        series.values.push_back({static_cast<double>(x), image.at(x, 0)});
    }
    return series;
}

Series fine_curve(std::string name, double (*value)(double), double per_unit, bool by_pixel) {
    Series series{std::move(name), Series::Mark::line, {}};
    const int points = static_cast<int>(2 * half_range * per_unit);
    for (int i = 0; i <= points; ++i) {
        const double x = -half_range + i / per_unit;
        series.values.push_back({by_pixel ? (x + half_range) / pixel_width : x, value(x)});
    }
    return series;
}

/// Root mean square distance from the envelope, which is what filtering is to leave.
double ripple(const ScalarImage& image) {
    double squares = 0;
    for (int x = 0; x < image.width(); ++x) {
        const double apart = image.at(x, 0) - envelope(middle_of(x));
        squares += apart * apart;
    }
    return std::sqrt(squares / image.width());
}

void check_shape(Sheet& sheet) {
    const double zero = 20 * std::numbers::pi;
    const double at_zeros = std::max(
        {test_value(zero), test_value(-zero), test_value(2 * zero), test_value(-2 * zero)});
    sheet.add(Check{"f(0), and f at 20 pi and 40 pi on either side", "",
                    short_number(test_value(0)) + ", " + short_number(at_zeros, 2),
                    agrees_if(test_value(0) == 1 && at_zeros < 1e-15)});
}

void check_alias(Sheet& sheet) {
    double largest = 0;
    for (int i = 0; i < pixels; ++i) {
        const double x = middle_of(i);
        largest = std::max(largest, std::abs(test_value(x) - alias_value(x)));
    }
    // Arguments to 150 and roundings as in `aliases`.
    constexpr double rounding_of_samples = 8 * 0x1p-53 * half_range;
    sheet.add(
        Check{"samples differ from those of a wave of " +
                  short_number(2 * std::numbers::pi / (2 * std::numbers::pi - pixel_width), 3) +
                  " pixels by rounding alone, " + short_number(rounding_of_samples, 2),
              "the same", short_number(largest, 2), agrees_if(largest <= rounding_of_samples)});
}

/// 1 + sin x without its envelope comes through a filter with its amplitude times the response.
void check_response(const Filter& filter, const std::string& name, Sheet& sheet) {
    const auto wave = [](double x) { return 1 + std::sin(x); };
    const ScalarImage image = filtered(as_raster(wave), filter, pixels, 1, subdivisions_of_pixel);
    const double factor = response(filter, cycles_per_pixel, 0);
    double largest = 0;
    for (int i = 0; i < pixels; ++i) {
        const double expected = 1 + factor * std::sin(middle_of(i));
        largest = std::max(largest, std::abs(image.at(i, 0) - expected));
    }
    // The lattice's own error: (pi cycles / subdivisions)^2 / 6 of the amplitude for the box.
    constexpr double allowed = 0.005;
    sheet.add(Check{name + ": 1 + sin x keeps its Fourier transform's share of its amplitude, " +
                        short_number(factor, 3) + ", within " + short_number(allowed, 1),
                    "", "off by " + short_number(largest, 2), agrees_if(largest <= allowed)});
}

/// One row of pixels as a strip of squares.
Image strip(const ScalarImage& row, int pixel_edge, int height) {
    constexpr double white = 0.5;  // f goes up to 2
    ScalarImage tall(row.width(), std::max(1, height / pixel_edge));
    for (int y = 0; y < tall.height(); ++y) {
        for (int x = 0; x < tall.width(); ++x) tall.at(x, y) = row.at(x, 0);
    }
    return magnified(greys(tall, white), pixel_edge);
}

void draw(std::span<const ScalarImage> rows, int edge, Sheet& sheet) {
    constexpr int share_of_edge = 25;  // makes a picture 2.4 edges wide
    const int pixel_edge = std::max(1, edge / share_of_edge), height = edge / 4;
    const Signal raster = as_raster(test_value);
    const Signal magnified_raster = [&](double x, double y) {
        return raster(x / pixel_edge, y / pixel_edge);
    };
    sheet.add(Picture{"test_function_fine", "The test function as an image, finely sampled"},
              strip(point_sampled(magnified_raster, pixels * pixel_edge, 1), 1, height));
    std::vector<Image> strips;
    for (const ScalarImage& row : rows) strips.push_back(strip(row, pixel_edge, height));
    sheet.add(Picture{"test_function_pixels",
                      "61 pixels: point-sampled, box filter, raised cosine of radius 1.7"},
              tiled(strips, 1));
}

}  // namespace

void test_function(const Studio& studio, Sheet& sheet) {
    const Filter box, hann({FilterKind::raised_cosine, textbook_radius});
    const Signal raster = as_raster(test_value);
    const ScalarImage sampled = point_sampled(raster, pixels, 1);
    const ScalarImage boxed = filtered(raster, box, pixels, 1, subdivisions_of_pixel);
    const ScalarImage weighted = filtered(raster, hann, pixels, 1, subdivisions_of_pixel);

    sheet.add(Chart{"test_function",
                    "The test function",
                    "x",
                    "f(x)",
                    {fine_curve("f", test_value, 10, false)}});
    sheet.add(Chart{"test_function_sampled",
                    "The point-sampled test function, and the slow wave that it shows",
                    "pixel",
                    "f",
                    {fine_curve("alias", alias_value, 2, true),
                     row_of(sampled, "samples", Series::Mark::points)}});
    sheet.add(Chart{"test_function_filtered",
                    "The filtered test function",
                    "pixel",
                    "f",
                    {row_of(sampled, "point-sampled", Series::Mark::line),
                     row_of(boxed, "box", Series::Mark::line),
                     row_of(weighted, "raised cosine, 1.7", Series::Mark::line)}});
    draw(std::array{sampled, boxed, weighted}, studio.edge, sheet);

    check_shape(sheet);
    check_alias(sheet);
    check_response(box, "box", sheet);
    check_response(hann, "raised cosine, 1.7", sheet);
    const double of_box = ripple(boxed), of_hann = ripple(weighted);
    sheet.add(Check{"rms distance from the envelope: raised cosine against box",
                    "weighted filters much better",
                    short_number(of_hann, 3) + " against " + short_number(of_box, 3),
                    agrees_if(of_hann < of_box / 2)});
}

}  // namespace rayshoot::textbook
