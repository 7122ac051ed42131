#include "data/mesh_essence.h"
#include "data/ply_header.h"
#include "data/tokens.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace rayshoot {

namespace {

/// The body, value by value.
class PlyBody {
public:
    PlyBody(std::string_view text, const PlyHeader& header, const std::string& name)
        : body_(text.substr(header.bytes)),
          tokens_(body_, name),
          name_(name),
          format_(header.format) {}

    bool ascii() const { return format_ == PlyHeader::Format::ascii; }
    std::size_t remaining() const {
        return ascii() ? tokens_.remaining() : body_.size() - position_;
    }

    /// One value as it stands in the file; a text value is checked to be a number.
    std::string_view value(const PlyType& type) {
        if (ascii()) return word(type);
        require(type.bytes);
        position_ += type.bytes;
        return body_.substr(position_ - type.bytes, type.bytes);
    }

    /// The count of a list whose items follow.
    std::uint64_t count(std::string_view raw, const PlyType& type, const PlyType& item) {
        const std::int64_t count = ascii() ? parse_integer(raw).value_or(-1) : whole(raw, type);
        const std::size_t smallest = ascii() ? 2 : item.bytes;  // a digit and a blank
        if (count < 0 || static_cast<std::uint64_t>(count) > (remaining() + 1) / smallest)
            refuse(
                "a list of " + std::to_string(count) +
                " values does not fit into the file; it is cut short or damaged: fetch it again");
        return static_cast<std::uint64_t>(count);
    }

    /// A count as the body would have it in a list of int.
    std::string written(std::uint64_t count) const {
        if (ascii()) return std::to_string(count) + " ";
        std::string raw(4, '\0');
        const bool little = format_ == PlyHeader::Format::binary_little_endian;
        for (std::size_t i = 0; i < 4; ++i)
            raw[little ? i : 3 - i] = static_cast<char>(count >> (8 * i) & 0xff);
        return raw;
    }

    void at(const std::string& element, std::uint64_t number) {
        element_ = &element;
        number_ = number;
    }
    [[noreturn]] void refuse(const std::string& message) const {
        throw std::invalid_argument(name_ + ": " + *element_ + " " + std::to_string(number_) +
                                    " (counted from 0): " + message);
    }

private:
    std::string_view word(const PlyType& type) {
        const std::string_view word = tokens_.next();
        if (word.empty()) require(1);
        if (type.whole ? !parse_integer(word) : !parse_number(word))
            refuse(quoted(word) + " is not " +
                   (type.whole ? "a whole number" : "a number that a float can hold"));
        return word;
    }

    void require(std::size_t bytes) const {
        if (remaining() < bytes || (ascii() && remaining() == 0))
            refuse("the file ends before it; it is cut short: fetch it again");
    }

    std::int64_t whole(std::string_view raw, const PlyType& type) const {
        std::uint64_t bits = 0;
        const bool little = format_ == PlyHeader::Format::binary_little_endian;
        for (std::size_t i = 0; i < raw.size(); ++i)
            bits = bits << 8 | static_cast<unsigned char>(raw[little ? raw.size() - 1 - i : i]);
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        return static_cast<std::int64_t>(bits) -
               (type.negative && bits & sign ? static_cast<std::int64_t>(sign << 1) : 0);
    }

    std::string_view body_;
    Tokens tokens_;
    std::string name_;
    PlyHeader::Format format_;
    std::size_t position_ = 0;
    const std::string* element_ = nullptr;
    std::uint64_t number_ = 0;
};

/// What is kept of an element, in the order of the file.
using Keep = bool (*)(const PlyProperty&);

bool position_or_normal(const PlyProperty& p) {
    return !p.count && !p.type->whole &&
           (p.name == "x" || p.name == "y" || p.name == "z" || p.name == "nx" || p.name == "ny" ||
            p.name == "nz");
}
bool corner_list(const PlyProperty& p) {
    return p.count && p.type->whole && (p.name == "vertex_indices" || p.name == "vertex_index");
}

class PlyReducer {
public:
    PlyReducer(std::string_view text, const std::string& name)
        : header_(read_ply_header(text, name)), body_(text, header_, name), name_(name) {}

    MeshEssence reduce() {
        const PlyElement& vertex = only("vertex");
        const PlyElement& face = only("face");
        for (const PlyElement& element : header_.elements) check_room(element);
        check_properties(vertex, face);
        for (const PlyElement& element : header_.elements) {
            if (&element == &vertex) walk(element, position_or_normal, vertices_);
            else if (&element == &face) walk(element, corner_list, faces_);
            else
                walk(
                    element, [](const PlyProperty&) { return false; }, nothing_);
        }
        essence_.binary = !body_.ascii();
        essence_.vertices = vertex.count;
        essence_.faces = face.count;
        essence_.text = "ply\nformat " + header_.format_name + " 1.0\n" +
                        declaration(vertex, position_or_normal) + declaration(face, corner_list) +
                        "end_header\n" + vertices_ + faces_;
        return std::move(essence_);
    }

private:
    const PlyElement& only(std::string_view name) const {
        const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
        if (found == header_.elements.end())
            refuse("there is no element '" + std::string(name) +
                   "' in the header; a mesh has "
                   "the elements vertex and face");
        if (std::ranges::count(header_.elements, name, &PlyElement::name) > 1)
            refuse("two elements '" + std::string(name) + "' in the header");
        return *found;
    }

    void check_room(const PlyElement& element) const {
        std::size_t smallest = 0;
        for (const PlyProperty& p : element.properties)
            smallest += body_.ascii() ? 2 : p.count ? p.count->bytes : p.type->bytes;
        if (smallest == 0 && element.count > 0)
            refuse("element '" + element.name + "' has no properties");
        if (element.count > 0)
            require_room(element.count, smallest, body_.remaining() + 1,
                         "elements '" + element.name + "'", name_);
    }

    void check_properties(const PlyElement& vertex, const PlyElement& face) {
        const auto has = [&vertex](std::string_view name) {
            return std::ranges::count_if(vertex.properties, [name](const PlyProperty& p) {
                return p.name == name && position_or_normal(p);
            });
        };
        if (has("x") != 1 || has("y") != 1 || has("z") != 1)
            refuse("a vertex must have the properties x, y and z, of type float or double, once");
        const auto normals = has("nx") + has("ny") + has("nz");
        if (normals != 0 && (has("nx") != 1 || has("ny") != 1 || has("nz") != 1))
            refuse("a vertex must have all of nx, ny and nz, of type float or double, or none");
        if (std::ranges::count_if(face.properties, corner_list) != 1)
            refuse("a face must have one list vertex_indices (or vertex_index) of an integer type");
        essence_.normals = normals != 0;
    }

    void walk(const PlyElement& element, Keep keep, std::string& out) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            body_.at(element.name, i);
            for (const PlyProperty& p : element.properties) property(p, keep(p), out);
            if (body_.ascii()) out += '\n';
        }
    }

    void property(const PlyProperty& p, bool kept, std::string& out) {
        if (!p.count) return copy(body_.value(*p.type), kept, out);
        const std::string_view raw = body_.value(*p.count);
        const std::uint64_t count = body_.count(raw, *p.count, *p.type);
        if (kept && count < 3)
            body_.refuse("has " + std::to_string(count) + " corners; a face has three or more");
        if (kept) essence_.corners += count;
        if (kept) out += body_.written(count);
        for (std::uint64_t i = 0; i < count; ++i) copy(body_.value(*p.type), kept, out);
    }

    void copy(std::string_view raw, bool kept, std::string& out) const {
        if (!kept) return;
        out += raw;
        if (body_.ascii()) out += ' ';
    }

    static std::string declaration(const PlyElement& element, Keep keep) {
        std::string text = "element " + element.name + " " + std::to_string(element.count) + "\n";
        for (const PlyProperty& p : element.properties) {
            if (!keep(p)) continue;
            text += "property ";
            if (p.count) text += "list int ";  // OpenMesh knows few types of counts
            text += std::string(p.type->name) + " " + p.name + "\n";
        }
        return text;
    }

    [[noreturn]] void refuse(const std::string& message) const {
        throw std::invalid_argument(name_ + ": " + message);
    }

    PlyHeader header_;
    PlyBody body_;
    std::string name_;
    MeshEssence essence_;
    std::string vertices_, faces_, nothing_;
};

}  // namespace

MeshEssence ply_essence(std::string_view text, const std::string& name) {
    return PlyReducer(text, name).reduce();
}

}  // namespace rayshoot
