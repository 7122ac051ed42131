#include "data/aff_file.h"

#include <algorithm>

namespace rayshoot {
namespace {

std::int64_t counted(Tokens& tokens, std::string_view use, std::int64_t shortest) {
    return tokens.integer(use, 0, most_to_come(tokens, shortest));
}

std::vector<vec3> read_vectors(Tokens& tokens, std::string_view use) {
    constexpr std::int64_t shortest = 6;  // characters: "0 0 0 "
    std::vector<vec3> all;
    for (std::int64_t left = counted(tokens, use, shortest); left > 0; --left)
        all.push_back(tokens.three(use));
    return all;
}

/// Passes them over; returns how many there are.
std::int64_t skip_texture_coordinates(Tokens& tokens, std::set<std::string>& left_out) {
    constexpr std::string_view use = "texture coordinates: their number, a file, then u v each";
    constexpr std::int64_t shortest = 4;  // characters: "0 0 "
    const std::int64_t count = counted(tokens, use, shortest);
    left_out.insert("texture " + std::string(tokens.next()));
    for (std::int64_t i = 0; i < 2 * count; ++i) tokens.number(use);
    return count;
}

std::array<std::uint32_t, 3> read_corners(Tokens& tokens, std::string_view use,
                                          std::int64_t count) {
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners)
        corner = static_cast<std::uint32_t>(tokens.integer(use, 0, count - 1));
    return corners;
}

}  // namespace

AffMesh read_aff_mesh(Tokens& tokens, std::set<std::string>& left_out) {
    const auto expect = [&](std::string_view word, std::string_view wanted) {
        if (word != wanted)
            tokens.refuse(quoted(word) +
                          " in a mesh: m vertices n ..., perhaps normals n ... and "
                          "texturecoords n file ..., then triangles n ...");
    };
    AffMesh mesh;
    std::int64_t texture_coordinates = 0;
    expect(tokens.next(), "vertices");
    mesh.vertices = read_vectors(tokens, "vertices of a mesh: their number, then x y z each");
    std::string_view word = tokens.next();
    if (word == "normals") {
        mesh.normals = read_vectors(tokens, "normals of a mesh: their number, then x y z each");
        word = tokens.next();
    }
    if (word == "texturecoords") {
        texture_coordinates = skip_texture_coordinates(tokens, left_out);
        word = tokens.next();
    }
    expect(word, "triangles");
    constexpr std::int64_t shortest = 6;  // characters: "0 1 2 "
    for (std::int64_t left =
             counted(tokens, "triangles of a mesh: their number, then indices", shortest);
         left > 0; --left) {
        AffMesh::Triangle& triangle = mesh.triangles.emplace_back();
        triangle.vertices = read_corners(tokens, "index of a vertex", std::ssize(mesh.vertices));
        if (!mesh.normals.empty())
            triangle.normals = read_corners(tokens, "index of a normal", std::ssize(mesh.normals));
        if (texture_coordinates > 0)
            read_corners(tokens, "index of a texture coordinate", texture_coordinates);
    }
    return mesh;
}

}  // namespace rayshoot
