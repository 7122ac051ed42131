#include "data/ply_header.h"

#include "data/tokens.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rayshoot {

namespace {

constexpr std::array<PlyType, 16> types{{{"char", 1, true, true},
                                         {"int8", 1, true, true},
                                         {"uchar", 1, true, false},
                                         {"uint8", 1, true, false},
                                         {"short", 2, true, true},
                                         {"int16", 2, true, true},
                                         {"ushort", 2, true, false},
                                         {"uint16", 2, true, false},
                                         {"int", 4, true, true},
                                         {"int32", 4, true, true},
                                         {"uint", 4, true, false},
                                         {"uint32", 4, true, false},
                                         {"float", 4, false, true},
                                         {"float32", 4, false, true},
                                         {"double", 8, false, true},
                                         {"float64", 8, false, true}}};

class HeaderReader {
public:
    HeaderReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    PlyHeader read() {
        if (next_line() != "ply") refuse("a PLY file begins with the line 'ply'");
        for (;;) {
            Words words(next_line());
            const std::string_view keyword = words.next();
            if (keyword == "end_header") break;
            if (keyword == "format") format(words);
            else if (keyword == "element") element(words);
            else if (keyword == "property") property(words);
            else if (keyword != "comment" && keyword != "obj_info")
                refuse(quoted(keyword) +
                       " in the header, which has format, comment, element, property and "
                       "end_header");
        }
        if (header_.format_name.empty()) refuse("the header has no line 'format'");
        return std::move(header_);
    }

private:
    /// The words of one line.
    class Words {
    public:
        explicit Words(std::string_view line) : line_(line) {}
        std::string_view next() {
            const std::size_t begin = std::min(line_.find_first_not_of(" \t"), line_.size());
            const std::size_t end = std::min(line_.find_first_of(" \t", begin), line_.size());
            const std::string_view word = line_.substr(begin, end - begin);
            line_.remove_prefix(end);
            return word;
        }

    private:
        std::string_view line_;
    };

    std::string_view next_line() {
        const std::size_t end = text_.find('\n', header_.bytes);
        if (end == text_.npos) refuse("the file ends within its header; fetch it again");
        std::string_view line = text_.substr(header_.bytes, end - header_.bytes);
        header_.bytes = end + 1;
        ++header_.lines;
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    void format(Words& words) {
        constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian",
                                                        "binary_big_endian"};
        const std::string_view word = words.next();
        const auto found = std::ranges::find(names, word);
        if (found == names.end())
            refuse(quoted(word) +
                   " is no format; PLY has ascii, binary_little_endian and binary_big_endian");
        header_.format = static_cast<PlyHeader::Format>(found - names.begin());
        header_.format_name = word;
    }

    void element(Words& words) {
        PlyElement element;
        element.name = words.next();
        const auto count = parse_integer(words.next());
        if (!count || *count < 0) refuse("no number of elements here; write: element vertex 8");
        element.count = static_cast<std::uint64_t>(*count);
        header_.elements.push_back(element);
    }

    void property(Words& words) {
        if (header_.elements.empty()) refuse("a property before the first element");
        PlyProperty property;
        std::string_view word = words.next();
        if (word == "list") {
            property.count = type(words.next());
            if (!property.count->whole) refuse("the count of a list must be an integer type");
            word = words.next();
        }
        property.type = type(word);
        property.name = words.next();
        header_.elements.back().properties.push_back(property);
    }

    const PlyType* type(std::string_view word) const {
        const auto found = std::ranges::find(types, word, &PlyType::name);
        if (found == types.end())
            refuse(quoted(word) +
                   " is no type; PLY has char, uchar, short, ushort, int, uint, float, double");
        return &*found;
    }

    [[noreturn]] void refuse(const std::string& message) const {
        throw std::invalid_argument(
            name_ + ":" + std::to_string(std::max<std::size_t>(1, header_.lines)) + ": " + message);
    }

    std::string_view text_;
    std::string name_;
    PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(std::string_view text, const std::string& name) {
    return HeaderReader(text, name).read();
}

}  // namespace rayshoot
