#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The header of a PLY file, and the walk over one element after the other in its body.
namespace rayshoot {

struct PlyType {
    std::string_view name;
    std::size_t bytes;
    bool whole;     ///< an integer
    bool negative;  ///< may be
};

struct PlyProperty {
    std::string name;
    const PlyType* type = nullptr;
    const PlyType* count = nullptr;  ///< of a list; null: a single value
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, binary_little_endian, binary_big_endian };

    Format format = Format::ascii;
    std::string format_name;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< of the header: where the body begins
    std::size_t lines = 0;
};

/// Throws std::invalid_argument with name:line and what the header should say.
PlyHeader read_ply_header(std::string_view text, const std::string& name);

}  // namespace rayshoot
