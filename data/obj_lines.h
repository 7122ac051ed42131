#pragma once

#include <streambuf>
#include <string>
#include <string_view>

/// An OBJ file handed over line by line, each checked first: tinyobjloader takes what is not a
/// number for 0, and does not say on which line it is.
namespace rayshoot {

class ObjLines final : public std::streambuf {
public:
    ObjLines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    /// Throws std::invalid_argument: "name:line: message", line being the last one handed over.
    [[noreturn]] void refuse(const std::string& message) const;

protected:
    int_type underflow() override;

private:
    std::string_view take_line();
    void check_numbers(std::string_view keyword, std::string_view line) const;
    std::string checked_face(std::string_view line) const;
    std::string_view checked_corner(std::string_view corner) const;

    std::string_view text_;
    std::string name_;
    std::string buffer_;     ///< the line handed over, with those that continue it
    std::size_t line_ = 0;   ///< its first one's number, from 1
    std::size_t taken_ = 0;  ///< lines taken so far
};

}  // namespace rayshoot
