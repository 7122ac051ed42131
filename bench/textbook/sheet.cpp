#include "bench/textbook/sheet.h"

#include "bench/output/whole_file.h"

#include <algorithm>

namespace rayshoot::textbook {
namespace {

constexpr int digits = 9;  // more than a drawing shows

/// A line a point: curve, how it is drawn, x, y.
std::string to_csv(const std::vector<Series>& all) {
    Table table{{"series", "mark", "x", "y"}, {}};
    for (const Series& series : all) {
        const char* mark = series.mark == Series::Mark::line ? "line" : "points";
        for (const auto& [x, y] : series.values) {
            table.rows.push_back(
                {series.name, mark, short_number(x, digits), short_number(y, digits)});
        }
    }
    return rayshoot::to_csv(table);
}

}  // namespace

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::agrees:
            return "agrees";
        case Verdict::misprint:
            return "misprint";
        case Verdict::off:
            break;
    }
    return "OFF";
}

void Sheet::add(Picture picture, const Image& image) {
    write_image(image, folder_ / (picture.name + ".png"));
    pictures_.push_back(std::move(picture));
}

void Sheet::add(Chart chart) {
    write_whole_file(folder_ / (chart.name + ".csv"), to_csv(chart.series));
    chart.series.clear();
    charts_.push_back(std::move(chart));
}

bool Sheet::holds() const {
    return std::ranges::none_of(checks_, [](const Check& c) { return c.verdict == Verdict::off; });
}

}  // namespace rayshoot::textbook
