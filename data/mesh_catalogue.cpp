#include "data/mesh_catalogue.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rayshoot {

namespace {

using enum MeshSource;

/// In the nave, looking along it.
constexpr Interior sibenik_nave() {
    Interior nave;
    nave.camera.from = {-16, -11.5f, 0};
    nave.camera.at = {0, -10, 0};
    nave.camera.angle = 60;
    nave.lamp = {-4, 4, 0};
    return nave;
}

/// Through the open side; the lamp is below the ceiling.
constexpr Interior cornell_room() {
    Interior room;
    room.camera.from = {278, 273, -800};
    room.camera.at = {278, 273, 0};
    room.camera.angle = 40;
    room.lamp = {278, 530, 280};
    return room;
}

const std::array<MeshEntry, 20> entries{{
    {"mesh/bunny00", "bunny00.off", cgal, "75k triangles: the Stanford bunny, remeshed"},
    {"mesh/elephant", "refined_elephant.off", cgal, "89k triangles, closed"},
    {"mesh/armadillo", "armadillo.off", cgal, "52k triangles, closed"},
    {"mesh/camel", "camel.off", cgal, "20k triangles"},
    {"mesh/bear", "bear.off", cgal, "28k triangles"},
    {"mesh/man", "man.off", cgal, "35k triangles"},
    {"mesh/lion_head", "lion-head.off", cgal, "17k triangles, open"},
    {"mesh/fandisk", "fandisk.off", cgal, "13k triangles: flat and sharp parts"},
    {"mesh/dragon", "dragon_vrip.ply.gz", fetched,
     "871k triangles: the full Stanford dragon, 108 of them degenerate"},
    {"mesh/dragon_res2", "dragon_vrip_res2.ply.gz", fetched, "203k triangles, non-manifold"},
    {"mesh/dragon_res4", "dragon_vrip_res4.ply.gz", fetched, "11k triangles, non-manifold"},
    {"mesh/bunny", "stanford-bunny.obj.xz", collection, "69k triangles: the Stanford bunny"},
    {"mesh/sibenik", "sibenik.obj.xz", collection, "75k triangles: a cathedral, seen from inside",
     sibenik_nave()},
    {"mesh/cornell_box", "cornell_box.obj", collection, "34 triangles, seen from its open side",
     cornell_room()},
    {"mesh/horse", "horse.ply.xz", collection, "97k triangles, closed"},
    {"mesh/beast", "beast.obj.xz", collection, "65k triangles, from faces of 3 to 6 sides"},
    {"mesh/cow", "cow.obj.xz", collection, "6k triangles, closed"},
    {"mesh/spot", "spot.obj.xz", collection, "6k triangles, closed"},
    {"mesh/teapot", "teapot.obj.xz", collection, "6k triangles, open"},
    {"mesh/woody", "woody.obj.xz", collection, "1k triangles, all in one plane"},
}};

std::filesystem::path folder_of(MeshSource source) {
    switch (source) {
        case cgal:
            return data_folder() / "meshes" / "cgal";
        case fetched:
            return data_folder() / "meshes" / "fetched";
        case collection:
            return scene_collection().value_or("") / "meshes";
    }
    return {};
}

bool is_file(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

}  // namespace

std::span<const MeshEntry> mesh_catalogue() { return entries; }

const MeshEntry* find_mesh(std::string_view name) {
    const auto found = std::ranges::find(entries, name, &MeshEntry::name);
    return found == entries.end() ? nullptr : &*found;
}

std::optional<std::filesystem::path> locate(const MeshEntry& mesh) {
    if (mesh.source != collection) {
        const auto own = folder_of(mesh.source) / mesh.file;
        if (is_file(own)) return own;
    }
    if (mesh.source != cgal && scene_collection()) {
        const auto collected = folder_of(collection) / mesh.file;
        if (is_file(collected)) return collected;
    }
    return std::nullopt;
}

std::string how_to_get(const MeshEntry& mesh) {
    switch (mesh.source) {
        case cgal:
            return "./setup.sh";
        case fetched:
            return "data/fetch.sh dragon";
        case collection:
            break;
    }
    return "put " + std::string(mesh.file) +
           " into a folder 'meshes' and set RAYSHOOT_SCENES to the folder above it";
}

std::filesystem::path data_folder() {
    if (const char* given = std::getenv("RAYSHOOT_DATA"); given && *given) return given;
    const std::filesystem::path source = RAYSHOOT_SOURCE_DATA;
    std::error_code error;
    if (std::filesystem::is_directory(source, error)) return source;
    return RAYSHOOT_INSTALLED_DATA;
}

std::optional<std::filesystem::path> scene_collection() {
    const char* given = std::getenv("RAYSHOOT_SCENES");
    std::error_code error;
    if (!given || !*given || !std::filesystem::is_directory(given, error)) return std::nullopt;
    return given;
}

}  // namespace rayshoot
