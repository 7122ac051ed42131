#pragma once

#include "bench/output/table.h"
#include "tracer/image.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// What a figure of the textbook consists of: pictures, curves, tables, and what was checked.
namespace rayshoot::textbook {

enum class Verdict : std::uint8_t {
    agrees,    ///< as published, or, where the book leaves it to the reader, as derived elsewhere
    misprint,  ///< not as published, but as the known correction has it
    off        ///< neither: the check failed
};
std::string_view name_of(Verdict verdict);
inline Verdict agrees_if(bool claim) { return claim ? Verdict::agrees : Verdict::off; }

/// One claim, and what came out here.
struct Check {
    std::string claim;
    std::string published;  ///< as the book has it; empty: it says nothing, the claim is ours
    std::string ours;
    Verdict verdict = Verdict::off;
};

/// Points of one curve, in order.
struct Series {
    enum class Mark : std::uint8_t { line, points };
    std::string name;
    Mark mark = Mark::line;
    std::vector<std::array<double, 2>> values;  ///< x, y
};

/// Curves in one frame: a CSV of all points, from which curves.py draws the SVG of the same name.
struct Chart {
    std::string name, caption;
    std::string x, y;  ///< titles of the axes
    std::vector<Series> series;
};

/// Pixels as a file, `name`.png.
struct Picture {
    std::string name, caption;
};

struct CaptionedTable {
    std::string caption;
    Table table;
};

/// One figure's page. Pictures and curves are written as they come.
class Sheet {
public:
    explicit Sheet(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void add(Picture picture, const Image& image);
    void add(Chart chart);
    void add(CaptionedTable table) { tables_.push_back(std::move(table)); }
    void add(Check check) { checks_.push_back(std::move(check)); }

    const std::vector<Picture>& pictures() const { return pictures_; }
    /// Without their series, which are in the files.
    const std::vector<Chart>& charts() const { return charts_; }
    const std::vector<CaptionedTable>& tables() const { return tables_; }
    const std::vector<Check>& checks() const { return checks_; }
    bool holds() const;

private:
    std::filesystem::path folder_;
    std::vector<Picture> pictures_;
    std::vector<Chart> charts_;
    std::vector<CaptionedTable> tables_;
    std::vector<Check> checks_;
};

}  // namespace rayshoot::textbook
