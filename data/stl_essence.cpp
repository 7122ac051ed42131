#include "data/mesh_essence.h"
#include "data/tokens.h"

#include <bit>
#include <cstring>
#include <stdexcept>

namespace rayshoot {

namespace {

constexpr std::size_t header_bytes = 84;  // 80 of text, then the number of facets
constexpr std::size_t facet_bytes = 50;   // normal, three corners, attribute

using Corners = std::array<vec3, 3>;

bool collapsed(const Corners& corners) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

std::uint32_t little_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
    return value;
}

Corners corners_of(std::string_view facet, std::uint64_t number, const std::string& name) {
    Corners corners;
    std::string_view bytes = facet.substr(12);  // after the normal
    for (vec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis, bytes.remove_prefix(4))
            corner[axis] = std::bit_cast<float>(little_endian(bytes));
    for (const vec3& corner : corners)
        if (!finite(corner))
            throw std::invalid_argument(name + ": facet " + std::to_string(number) +
                                        " (counted from 0) has a coordinate that is not finite; "
                                        "repair the mesh");
    return corners;
}

std::string little_endian(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i, value >>= 8) bytes += static_cast<char>(value & 0xff);
    return bytes;
}

MeshEssence binary_essence(std::string_view text, std::uint32_t facets, const std::string& name) {
    MeshEssence essence;
    essence.binary = true;
    std::string kept;
    for (std::uint32_t i = 0; i < facets; ++i) {
        const std::string_view facet = text.substr(header_bytes + i * facet_bytes, facet_bytes);
        const Corners corners = corners_of(facet, i, name);
        if (collapsed(corners)) essence.collapsed.push_back({i, corners});
        else kept += facet;
    }
    essence.faces = facets - essence.collapsed.size();
    essence.text = std::string(80, ' ') + little_endian(static_cast<std::uint32_t>(essence.faces));
    essence.text += kept;
    return essence;
}

class TextStl {
public:
    TextStl(std::string_view text, const std::string& name) : tokens_(text, name) {}

    MeshEssence reduce() {
        essence_.text = "solid\n";
        expect("solid");
        tokens_.skip_line();  // a name
        for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) {
            if (word == "endsolid" || word == "solid") tokens_.skip_line();
            else if (word == "facet") facet();
            else tokens_.refuse(quoted(word) + " where a facet or endsolid is expected");
            closed_ = word == "endsolid";
        }
        if (!closed_) tokens_.refuse("the file ends without endsolid; it is cut short");
        essence_.text += "endsolid\n";
        return std::move(essence_);
    }

private:
    void expect(std::string_view word) {
        const std::string_view found = tokens_.next();
        if (found != word)
            tokens_.refuse(quoted(found) + " where " + quoted(word) + " is expected");
    }

    void facet() {
        expect("normal");
        for (int axis = 0; axis < 3; ++axis) tokens_.next();  // ours is made from the corners
        expect("outer");
        expect("loop");
        Corners corners;
        std::string lines;
        for (vec3& corner : corners) {
            expect("vertex");
            lines += "vertex";
            for (int axis = 0; axis < 3; ++axis) {
                lines += ' ';
                lines += tokens_.peek();
                corner[axis] = tokens_.number("coordinate of a corner");
            }
            lines += "\n";
        }
        expect("endloop");
        expect("endfacet");
        if (collapsed(corners))
            essence_.collapsed.push_back({essence_.faces + essence_.collapsed.size(), corners});
        else {
            essence_.text += "facet normal 0 0 0\nouter loop\n" + lines + "endloop\nendfacet\n";
            ++essence_.faces;
        }
    }

    Tokens tokens_;
    MeshEssence essence_;
    bool closed_ = false;
};

}  // namespace

MeshEssence stl_essence(std::string_view text, const std::string& name) {
    const bool has_header = text.size() >= header_bytes;
    const std::uint32_t facets = has_header ? little_endian(text.substr(80, 4)) : 0;
    const std::uint64_t size = header_bytes + std::uint64_t{facets} * facet_bytes;
    MeshEssence essence;
    if (has_header && text.size() == size) essence = binary_essence(text, facets, name);
    else if (text.starts_with("solid")) essence = TextStl(text, name).reduce();
    else
        throw std::invalid_argument(
            name +
            ": neither a text STL, which begins with 'solid', nor a binary one: its header "
            "declares " +
            std::to_string(facets) + " facets, which makes " + std::to_string(size) +
            " bytes, but the file has " + std::to_string(text.size()) + "; fetch it again");
    essence.corners = 3 * essence.faces;
    return essence;
}

}  // namespace rayshoot
