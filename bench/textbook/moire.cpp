#include "bench/textbook/figures.h"
#include "bench/textbook/filtered.h"
#include "bench/textbook/pictures.h"

#include <cmath>
#include <numbers>

/// A zone plate (1 + cos(pi r^2 / R)) / 2 reaches r / R cycles a pixel at the distance r: where
/// that is more than 1/2, all that an image shows is alias, and its rings are a Moire pattern.
namespace rayshoot::textbook {
namespace {

constexpr int points_per_pixel = 8;  // along an axis: eight or more a cycle
constexpr int least_edge = 64;       // below, too few rings are left to measure

struct NamedFilter {
    std::string name;
    FilterSettings settings;
};
const std::vector<NamedFilter> compared{
    {"box, 1 pixel", {FilterKind::box, 0.5}},
    {"cone, 1.5", {FilterKind::cone, 1.5}},
    {"cone, 1.7", {FilterKind::cone, 1.7}},
    {"raised cosine, 1.5", {FilterKind::raised_cosine, 1.5}},
    {"raised cosine, 1.7", {FilterKind::raised_cosine, 1.7}},
    {"Gaussian, 1.5", {FilterKind::gaussian, 1.5}},
    {"Mitchell, 2", {FilterKind::mitchell, 2}},
    {"Blackman-Harris, 2", {FilterKind::blackman_harris, 2}},
};

/// Frequencies, cycles a pixel, of a ring of the plate.
struct Band {
    double low, high;
};
constexpr Band beyond_nyquist{0.5, 1}, well_below{0, 0.25};

Signal zone_plate(int edge) {
    const double middle = edge / 2.0, turns = std::numbers::pi / middle;
    return [=](double x, double y) {
        const double dx = x - middle, dy = y - middle;
        return (1 + std::cos(turns * (dx * dx + dy * dy))) / 2;
    };
}

/// Mean square deviation from grey in a band, over that of the plate itself, 1/8.
double energy(const ScalarImage& image, const Band& band) {
    const double middle = image.width() / 2.0;
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double frequency = std::hypot(x + 0.5 - middle, y + 0.5 - middle) / middle;
            if (frequency < band.low || frequency >= band.high) continue;
            sum += (image.at(x, y) - 0.5) * (image.at(x, y) - 0.5);
            ++count;
        }
    }
    return 8 * sum / count;
}

/// What the filter's Fourier transform says of it: the mean of its square over the ring, on a polar
/// lattice. Exact for a wave; a plate's frequency changes a little within a pixel.
double predicted_energy(const Filter& filter, const Band& band) {
    constexpr int rings = 32, directions = 16;  // the filters are alike in all eight octants
    double sum = 0, whole = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const double frequency = std::lerp(band.low, band.high, (ring + 0.5) / rings);
        for (int i = 0; i < directions; ++i) {
            const double angle = (i + 0.5) / directions * (std::numbers::pi / 4);
            const double share =
                response(filter, frequency * std::cos(angle), frequency * std::sin(angle));
            sum += frequency * share * share;
            whole += frequency;
        }
    }
    return sum / whole;
}

std::string percent(double share) { return number_cell(100 * share, 3) + " %"; }

struct Measured {
    double alias, predicted, kept;
};

Measured measure_filter(const Signal& plate, const NamedFilter& named, int edge,
                        std::vector<Image>& images) {
    const Filter filter(named.settings);
    const ScalarImage image = filtered(plate, filter, edge, edge, points_per_pixel);
    images.push_back(greys(image, 1));
    return {energy(image, beyond_nyquist), predicted_energy(filter, beyond_nyquist),
            energy(image, well_below)};
}

/// The plate is a chirp, its middle and edge are cut: a tenth, and a floor of 10^-4, on 256 pixels;
/// on fewer the frequency changes faster.
bool as_predicted(const Measured& measured, int edge) {
    const double coarseness = 256.0 / edge;
    return std::abs(measured.alias - measured.predicted) <=
           coarseness * (0.1 * measured.predicted + 1e-4);
}

}  // namespace

void moire(const Studio& studio, Sheet& sheet) {
    const int edge = std::max(studio.edge, least_edge);
    const Signal plate = zone_plate(edge);
    const ScalarImage sampled = point_sampled(plate, edge, edge);
    std::vector<Image> images{greys(sampled, 1)};
    Table table{{"filter", "alias", "by its Fourier transform", "kept below 1/4 cycle"}, {}};
    table.rows.push_back({"none: point samples", percent(energy(sampled, beyond_nyquist)),
                          percent(1), percent(energy(sampled, well_below))});
    double of_box = 0, of_hann = 0;
    std::string caption = "A zone plate: point samples";
    for (const NamedFilter& named : compared) {
        const Measured measured = measure_filter(plate, named, edge, images);
        table.rows.push_back({named.name, percent(measured.alias), percent(measured.predicted),
                              percent(measured.kept)});
        sheet.add(Check{named.name + ": energy of the alias, by its Fourier transform " +
                            percent(measured.predicted),
                        "", percent(measured.alias), agrees_if(as_predicted(measured, edge))});
        if (named.settings.kind == FilterKind::box) of_box = measured.alias;
        if (named.name == "raised cosine, 1.7") of_hann = measured.alias;
        caption += "; " + named.name;
    }
    sheet.add(Picture{"moire", caption}, tiled(images, 3));
    sheet.add(
        CaptionedTable{"Energy, relative to the plate's own, beyond 1/2 cycle a pixel (alias) "
                       "and below 1/4 (picture)",
                       table});
    constexpr double much = 10;
    sheet.add(
        Check{"box over raised cosine 1.7, energy of the alias: at least " + short_number(much),
              "weighted filters much better", number_cell(of_box / of_hann, 3),
              agrees_if(of_box > much * of_hann)});
}

}  // namespace rayshoot::textbook
