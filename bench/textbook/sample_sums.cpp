#include "tracer/filter/sample_sum.h"

#include "bench/textbook/figures.h"

#include <cmath>
#include <cstdio>

/// The table "variation of sample sum with sample centre": each entry, the book's and ours.
namespace rayshoot::textbook {
namespace {

/// "Hamming" in the book, whose formula is the window of von Hann.
std::string name_in_table(const PrintedSampleSums& row) {
    return (row.kind == FilterKind::cone ? "cone, " : "raised cosine, ") +
           number_cell(row.radius, 2);
}

std::string two_decimals(double value) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

/// Agreement is of the digits that are printed. A known misprint that does agree is as wrong as a
/// number that does not.
Verdict verdict(const PrintedValue& printed, double ours) {
    const bool same = two_decimals(ours) == two_decimals(printed.value);
    if (same != printed.misprint) return same ? Verdict::agrees : Verdict::misprint;
    return Verdict::off;
}

Check entry(const PrintedSampleSums& row, const std::string& what, const PrintedValue& printed,
            double ours) {
    return {name_in_table(row) + ": " + what, two_decimals(printed.value), number_cell(ours, 5),
            verdict(printed, ours)};
}

}  // namespace

void sample_sums(const Studio&, Sheet& sheet) {
    Table table{{"filter", "integral", "least sum", "at", "greatest sum", "at", "rms from 1"}, {}};
    const auto place = [](const SampleSumAt& at) {
        return "(" + number_cell(at.x, 2) + ", " + number_cell(at.y, 2) + ")";
    };
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Filter filter({row.kind, row.radius});
        const SampleSums sums = rayshoot::sample_sums(filter);
        sheet.add(entry(row, "integral", row.integral, filter.integral()));
        sheet.add(entry(row, "least sum", row.least, sums.least.sum));
        sheet.add(entry(row, "greatest sum", row.greatest, sums.greatest.sum));
        table.rows.push_back({name_in_table(row), number_cell(filter.integral(), 5),
                              number_cell(sums.least.sum, 5), place(sums.least),
                              number_cell(sums.greatest.sum, 5), place(sums.greatest),
                              number_cell(sums.ripple, 3)});
    }
    sheet.add(
        CaptionedTable{"Ours in full; places from the corner of the cell, by symmetry in "
                       "0 <= x <= y <= 1/2",
                       table});
}

}  // namespace rayshoot::textbook
