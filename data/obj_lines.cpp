#include "data/obj_lines.h"

#include "data/tokens.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rayshoot {

namespace {

std::string_view next_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\v\f";
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

}  // namespace

/// Lines end with LF, CR LF or CR.
std::string_view ObjLines::take_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end);
    text_.remove_prefix(text_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text_.size()));
    ++taken_;
    return line;
}

ObjLines::int_type ObjLines::underflow() {
    if (text_.empty()) return traits_type::eof();
    buffer_ = take_line();
    line_ = taken_;
    while (buffer_.ends_with('\\') && !text_.empty()) {
        buffer_.back() = ' ';
        buffer_ += take_line();
    }
    std::ranges::replace(buffer_, '\0', '?');  // tinyobjloader would end the line there
    std::string_view line = buffer_;
    const std::string_view keyword = next_word(line);
    if (keyword == "v" || keyword == "vn") check_numbers(keyword, line);
    if (keyword == "f") buffer_ = checked_face(line);
    buffer_ += '\n';
    setg(buffer_.data(), buffer_.data(), buffer_.data() + buffer_.size());
    return traits_type::to_int_type(buffer_[0]);
}

void ObjLines::check_numbers(std::string_view keyword, std::string_view line) const {
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = next_word(line);
        if (word.empty()) refuse(std::string(keyword) + " wants three numbers: x y z");
        if (!parse_number(word))
            refuse(quoted(word) + " is not a finite number; repair this " +
                   (keyword == "v" ? "vertex" : "normal") + " or remove it with its faces");
    }
}

std::string ObjLines::checked_face(std::string_view line) const {
    std::string face = "f";
    int corners = 0;
    for (std::string_view word = next_word(line); !word.empty() && !word.starts_with('#');
         word = next_word(line), ++corners) {
        face += ' ';
        face += checked_corner(word);
    }
    if (corners < 3) refuse("a face with fewer than three corners; remove it");
    return face;
}

/// v, v/vt, v//vn or v/vt/vn. Slashes at the end, which occur too, are left out: tinyobjloader
/// would take the next corner's vertex for the index that is not there.
std::string_view ObjLines::checked_corner(std::string_view corner) const {
    int fields = 0;
    for (std::string_view rest = corner; fields == 0 || !rest.empty(); ++fields) {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        const std::string_view field = rest.substr(0, slash);
        rest.remove_prefix(std::min(slash + 1, rest.size()));
        if (field.empty() && fields > 0) continue;
        const auto index = parse_integer(field);
        if (!index || *index > std::numeric_limits<int>::max() ||
            *index < -std::numeric_limits<int>::max())
            refuse(quoted(corner) + " is not a corner of a face; write v, v/vt, v//vn or v/vt/vn");
    }
    if (fields > 3) refuse(quoted(corner) + " has more than three indices");
    return corner.substr(0, corner.find_last_not_of('/') + 1);
}

void ObjLines::refuse(const std::string& message) const {
    throw std::invalid_argument(name_ + ":" + std::to_string(std::max<std::size_t>(1, line_)) +
                                ": " + message);
}

}  // namespace rayshoot
