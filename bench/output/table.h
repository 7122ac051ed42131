#pragma once

#include <optional>
#include <string>
#include <vector>

/// A table of text cells, written for a terminal, for a paper and for a spreadsheet.
namespace rayshoot {

struct Table {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;  ///< each as long as headings
};

/// What stands where nothing was measured; never 0.
inline constexpr const char* not_measured = "n/a";

/// `value` with `digits` significant digits and no exponent below 1e15, or n/a.
std::string number_cell(std::optional<double> value, int digits = 4);

/// `value` as short as `digits` significant digits allow, with an exponent where that is shorter:
/// for files, whole numbers and rounding errors. Or n/a.
std::string short_number(double value, int digits = 4);

/// Columns padded to equal width, numbers to the right.
std::string to_text(const Table& table);
/// GitHub's pipes; pipes in cells are escaped.
std::string to_markdown(const Table& table);
/// RFC 4180, a header line first.
std::string to_csv(const Table& table);

}  // namespace rayshoot
