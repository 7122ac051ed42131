#include "bench/output/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rayshoot {
namespace {

bool looks_numeric(const std::string& cell) {
    if (cell == not_measured || cell == "error") return true;
    return !cell.empty() && cell.find_first_not_of("0123456789.+-*e") == std::string::npos;
}

std::vector<std::size_t> column_widths(const Table& table) {
    std::vector<std::size_t> widths;
    for (const std::string& heading : table.headings) widths.push_back(heading.size());
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    return widths;
}

std::string padded(const std::string& cell, std::size_t width, bool to_the_right) {
    const std::string space(width - cell.size(), ' ');
    return to_the_right ? space + cell : cell + space;
}

std::string text_line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                      const std::vector<bool>& right) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        line += (c == 0 ? "" : "  ") + padded(cells[c], widths[c], right[c]);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string markdown_line(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) {
        line += ' ';
        for (const char c : cell) line += c == '|' ? std::string("\\|") : std::string(1, c);
        line += " |";
    }
    return line + "\n";
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (c > 0) line += ',';
        if (cells[c].find_first_of(",\"\n") == std::string::npos) {
            line += cells[c];
            continue;
        }
        line += '"';
        for (const char character : cells[c]) {
            line += character == '"' ? std::string("\"\"") : std::string(1, character);
        }
        line += '"';
    }
    return line + "\r\n";
}

/// A column is set to the right when every cell of it is a number.
std::vector<bool> numeric_columns(const Table& table) {
    std::vector<bool> numeric(table.headings.size(), !table.rows.empty());
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (!looks_numeric(row[c])) numeric[c] = false;
        }
    }
    return numeric;
}

}  // namespace

std::string number_cell(std::optional<double> value, int digits) {
    if (!value || !std::isfinite(*value)) return not_measured;
    if (*value == 0) return "0";
    const double magnitude = std::floor(std::log10(std::abs(*value)));
    const int decimals = std::clamp(digits - 1 - static_cast<int>(magnitude), 0, 12);
    char text[64];
    if (magnitude >= 15) {
        std::snprintf(text, sizeof text, "%.*e", digits - 1, *value);
    } else {
        std::snprintf(text, sizeof text, "%.*f", decimals, *value);
    }
    return text;
}

std::string short_number(double value, int digits) {
    if (!std::isfinite(value)) return not_measured;
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string to_text(const Table& table) {
    const auto widths = column_widths(table);
    const auto right = numeric_columns(table);
    std::string text = text_line(table.headings, widths, right);
    std::vector<std::string> rule;
    for (const std::size_t width : widths) rule.emplace_back(width, '-');
    text += text_line(rule, widths, right);
    for (const auto& row : table.rows) text += text_line(row, widths, right);
    return text;
}

std::string to_markdown(const Table& table) {
    std::string text = markdown_line(table.headings) + "|";
    for (const bool right : numeric_columns(table)) text += right ? "---:|" : "---|";
    text += "\n";
    for (const auto& row : table.rows) text += markdown_line(row);
    return text;
}

std::string to_csv(const Table& table) {
    std::string text = csv_line(table.headings);
    for (const auto& row : table.rows) text += csv_line(row);
    return text;
}

}  // namespace rayshoot
