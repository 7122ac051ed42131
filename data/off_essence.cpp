#include "data/mesh_essence.h"
#include "data/tokens.h"

#include <stdexcept>

namespace rayshoot {

namespace {

constexpr std::int64_t most_elements = 0xffff'fffe;  // what a 32-bit index can name, and none

/// What stands before "OFF" says what each vertex line holds after its position.
std::string_view header_prefix(Tokens& tokens) {
    const std::string_view word = tokens.next();
    if (!word.ends_with("OFF"))
        tokens.refuse("an OFF file begins with OFF; this one begins with " + quoted(word));
    const std::string_view prefix = word.substr(0, word.size() - 3);
    if (prefix.find_first_of("4n") != prefix.npos)
        tokens.refuse("vertices of other than three dimensions; convert the file to plain OFF");
    if (tokens.peek() == "BINARY")
        tokens.refuse("binary OFF is not read; convert the file to PLY or ASCII OFF");
    return prefix;
}

void append(std::string& text, std::string_view word) {
    if (!text.empty() && text.back() != '\n') text += ' ';
    text += word;
}

void copy_vertex(Tokens& tokens, std::string& text) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = tokens.peek();
        tokens.number("coordinate of a vertex");
        append(text, word);
    }
    text += '\n';
}

std::uint64_t copy_face(Tokens& tokens, std::string& text, std::int64_t vertices) {
    const auto room = static_cast<std::int64_t>(tokens.remaining());
    const std::int64_t corners =
        tokens.integer("number of a face's corners", 3, std::max<std::int64_t>(3, room));
    append(text, std::to_string(corners));
    for (std::int64_t i = 0; i < corners; ++i)
        append(text, std::to_string(
                         tokens.integer("number of a face's vertex, from 0", 0, vertices - 1)));
    tokens.skip_line();  // a colour
    text += '\n';
    return static_cast<std::uint64_t>(corners);
}

}  // namespace

void require_room(std::uint64_t count, std::uint64_t smallest, std::uint64_t bytes,
                  const std::string& elements, const std::string& name) {
    if (count <= bytes / smallest) return;
    throw std::invalid_argument(
        name + ": the header declares " + std::to_string(count) + " " + elements + ", but only " +
        std::to_string(bytes) +
        " bytes follow it; the file is cut short or its header is wrong: fetch it again");
}

MeshEssence off_essence(std::string_view text, const std::string& name) {
    Tokens tokens(text, name);
    const std::string_view prefix = header_prefix(tokens);
    MeshEssence essence;
    const std::int64_t vertices = tokens.integer("number of vertices", 0, most_elements);
    const std::int64_t faces = tokens.integer("number of faces", 0, most_elements);
    tokens.integer("number of edges", 0, INT64_MAX);
    essence.vertices = static_cast<std::uint64_t>(vertices);
    essence.faces = static_cast<std::uint64_t>(faces);
    require_room(essence.vertices, 6, tokens.remaining() + 1, "vertices", name);  // "0 0 0\n"
    require_room(essence.faces, 8, tokens.remaining() + 1, "faces", name);        // "3 0 0 0\n"

    essence.text = "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces) + " 0\n";
    for (std::int64_t i = 0; i < vertices; ++i) {
        copy_vertex(tokens, essence.text);
        if (!prefix.empty()) tokens.skip_line();  // normal, colour, texture coordinates
    }
    for (std::int64_t i = 0; i < faces; ++i)
        essence.corners += copy_face(tokens, essence.text, vertices);
    if (const std::string_view rest = tokens.next(); !rest.empty())
        tokens.refuse(quoted(rest) +
                      " after the last face; the header's counts are too low, or the file is two");
    return essence;
}

}  // namespace rayshoot
