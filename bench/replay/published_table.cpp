#include "bench/replay/published_table.h"

#include <boost/tokenizer.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <set>
#include <stdexcept>

namespace rayshoot {
namespace {

constexpr std::array<std::string_view, 9> columns{"structure", "setting",   "scene",
                                                  "metric",    "value",     "measure",
                                                  "tolerance", "our_value", "spec"};

std::string header() {
    std::string line;
    for (const std::string_view column : columns)
        line += (line.empty() ? "" : ",") + std::string(column);
    return line;
}

/// Commas between them; those with commas in quotes.
std::vector<std::string> fields(const std::string& line) {
    if (std::count(line.begin(), line.end(), '"') % 2 != 0)
        throw std::invalid_argument("a quote is not closed");
    using Separator = boost::escaped_list_separator<char>;
    const boost::tokenizer<Separator> parts(line, Separator("", ",", "\""));
    return {parts.begin(), parts.end()};
}

double parsed_number(const std::string& text, const char* column) {
    double value = 0;
    const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (wrong != std::errc{} || end != text.data() + text.size() || !(value >= 0))
        throw std::invalid_argument(std::string("the ") + column +
                                    " should be a number, 12.5 say, not \"" + text + "\"");
    return value;
}

/// "exact", "2%", "none"
std::optional<double> tolerance(const std::string& text) {
    if (text == "exact") return 0;
    if (text == "none") return std::nullopt;
    if (!text.ends_with('%'))
        throw std::invalid_argument(
            "the tolerance should be exact, none or a percentage, 2% say, "
            "not \"" +
            text + "\"");
    return parsed_number(text.substr(0, text.size() - 1), "tolerance") / 100;
}

PublishedNumber parsed(const std::string& line) {
    const std::vector<std::string> given = fields(line);
    if (given.size() != columns.size())
        throw std::invalid_argument("there should be " + std::to_string(columns.size()) +
                                    " fields, not " + std::to_string(given.size()) + ": " +
                                    header() + "; quote a field that has commas");
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (given[i].empty() && columns[i] != "our_value")
            throw std::invalid_argument("the " + std::string(columns[i]) + " is missing");
    PublishedNumber result;
    result.structure = given[0];
    result.setting = given[1];
    result.scene = given[2];
    result.metric = given[3];
    result.value = parsed_number(given[4], "value");
    result.measure = given[5];
    result.tolerance = tolerance(given[6]);
    result.spec = given[8];
    if (!given[7].empty()) result.ours = parsed_number(given[7], "our_value");
    return result;
}

}  // namespace

void refuse_line(const std::filesystem::path& path, std::size_t line, const std::string& what) {
    throw std::invalid_argument(path.string() + ":" + std::to_string(line) + ": " + what);
}

PublishedTable read_published(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in)
        throw std::invalid_argument(path.string() + ": cannot be read; run in the project's " +
                                    "folder, or name a table by --published");
    PublishedTable table{path, {}};
    std::set<std::array<std::string, 4>> seen;
    std::string text;
    bool begun = false;
    for (std::size_t line = 1; std::getline(in, text); ++line) {
        if (text.ends_with('\r')) text.pop_back();
        if (text.empty() || text.starts_with('#')) continue;
        if (!begun) {
            if (text != header()) refuse_line(path, line, "the first line should be " + header());
            begun = true;
            continue;
        }
        try {
            table.numbers.push_back(parsed(text));
        } catch (const std::invalid_argument& wrong) {
            refuse_line(path, line, wrong.what());
        }
        PublishedNumber& last = table.numbers.back();
        last.line = line;
        if (!seen.insert({last.structure, last.setting, last.scene, last.metric}).second)
            refuse_line(path, line, "this number is given twice; keep one");
    }
    if (table.numbers.empty())
        refuse_line(path, 1, "no numbers are in it; the first line should be " + header());
    return table;
}

}  // namespace rayshoot
