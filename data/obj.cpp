#include "data/obj.h"

#include "data/obj_lines.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace rayshoot {

namespace {

float in_unit_interval(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

/// The illumination models of the MTL format that reflect, and those that let light through.
bool reflects(int model) { return model >= 3 && model <= 9; }
bool transmits(int model) { return model == 4 || model == 6 || model == 7 || model == 9; }

Material material_of(const tinyobj::material_t& given) {
    Material material;
    for (int i = 0; i < 3; ++i) material.colour[i] = in_unit_interval(given.diffuse[i]);
    const float mirror = std::max({given.specular[0], given.specular[1], given.specular[2]});
    material.specular = reflects(given.illum) ? in_unit_interval(mirror) : 0;
    material.shininess = given.shininess >= 1 && given.shininess < infinity ? given.shininess : 1;
    material.transmittance = transmits(given.illum) ? in_unit_interval(1 - given.dissolve) : 0;
    material.refraction_index = given.ior >= 1 && given.ior < infinity ? given.ior : 1;
    return material;
}

class ObjReader final : public tinyobj::MaterialReader {
public:
    ObjReader(std::string_view text, const std::string& name, const MaterialLibrary& library)
        : lines_(text, name), library_(library) {}

    Mesh read() {
        std::istream in(&lines_);
        in.exceptions(std::ios::badbit);  // what lines_ throws must not be swallowed
        std::string warnings, errors;
        const bool success =
            tinyobj::LoadObjWithCallback(in, callbacks(), this, this, &warnings, &errors);
        if (!success) lines_.refuse("tinyobjloader cannot read on: " + errors);
        if (face_sizes_.empty())
            lines_.refuse("the file ends without a face (f v v v ...); there is nothing to see");
        return mesh();
    }

    /// Called by tinyobjloader for each mtllib.
    bool operator()(const std::string& file, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* numbers, std::string* warnings,
                    std::string* errors) override {
        const auto text = library_(file);
        if (!text) return false;
        std::istringstream in(*text);
        tinyobj::LoadMtl(numbers, materials, &in, warnings, errors);
        materials_.resize(1);
        for (const tinyobj::material_t& given : *materials)
            materials_.push_back(material_of(given));
        return true;
    }

private:
    struct Corner {
        std::uint32_t vertex;
        std::uint32_t normal;  ///< 1 + index; 0: none
    };

    static tinyobj::callback_t callbacks() {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* self, float x, float y, float z, float) {
            static_cast<ObjReader*>(self)->vertex({x, y, z});
        };
        calls.normal_cb = [](void* self, float x, float y, float z) {
            static_cast<ObjReader*>(self)->normals_.emplace_back(x, y, z);
        };
        calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<ObjReader*>(self)->face({corners, static_cast<std::size_t>(count)});
        };
        calls.usemtl_cb = [](void* self, const char*, int number) {
            static_cast<ObjReader*>(self)->material_ = static_cast<std::uint32_t>(number + 1);
        };
        return calls;
    }

    void vertex(const vec3& position) {
        if (!finite(position)) lines_.refuse("a coordinate beyond what a float can hold");
        positions_.push_back(position);
    }

    void face(std::span<const tinyobj::index_t> corners) {
        for (const tinyobj::index_t& corner : corners) {
            const std::uint32_t vertex = resolved(corner.vertex_index, positions_.size(), "vertex");
            const std::uint32_t normal =
                corner.normal_index == 0
                    ? 0
                    : resolved(corner.normal_index, normals_.size(), "normal") + 1;
            corners_.push_back({vertex, normal});
        }
        face_sizes_.push_back(static_cast<std::uint32_t>(corners.size()));
        face_materials_.push_back(material_);
    }

    /// OBJ counts from 1, or backwards from -1 for the last one so far.
    std::uint32_t resolved(int index, std::size_t count, const std::string& what) const {
        const auto existing = static_cast<std::int64_t>(count);
        const std::int64_t position = index > 0 ? index - 1 : existing + index;
        if (index == 0 || position < 0 || position >= existing)
            lines_.refuse("a face names " + what + " " + std::to_string(index) +
                          ", but the file has " + std::to_string(count) +
                          " of them up to here, counted from 1 or back from -1");
        return static_cast<std::uint32_t>(position);
    }

    Mesh mesh() {
        Mesh mesh;
        mesh.vertices = std::move(positions_);
        const std::vector<std::uint32_t> corners = shared_vertices(mesh);
        std::span<const std::uint32_t> rest(corners);
        for (std::size_t i = 0; i < face_sizes_.size(); ++i) {
            mesh.add_fan(rest.first(face_sizes_[i]));
            rest = rest.subspan(face_sizes_[i]);
            mesh.material_of.resize(mesh.triangles.size(), face_materials_[i]);
        }
        mesh.materials = std::move(materials_);
        return mesh;
    }

    /// A vertex of the mesh per corner. A position that faces use with several normals becomes
    /// several vertices; the first normal stays at the file's own place.
    std::vector<std::uint32_t> shared_vertices(Mesh& mesh) const {
        std::vector<std::uint32_t> vertices;
        const bool with_normals =
            std::ranges::any_of(corners_, [](const Corner& c) { return c.normal != 0; });
        if (!with_normals) {
            for (const Corner& corner : corners_) vertices.push_back(corner.vertex);
            return vertices;
        }
        constexpr std::uint32_t unused = 0xffffffff;
        std::vector<std::uint32_t> first_normal(mesh.vertices.size(), unused);
        std::unordered_map<std::uint64_t, std::uint32_t> others;
        mesh.normals.resize(mesh.vertices.size(), vec3(0));
        for (const Corner& corner : corners_) {
            std::uint32_t& first = first_normal[corner.vertex];
            if (first == unused) {
                first = corner.normal;
                mesh.normals[corner.vertex] = normal(corner);
            }
            if (first == corner.normal) {
                vertices.push_back(corner.vertex);
                continue;
            }
            const std::uint64_t key = std::uint64_t{corner.vertex} << 32 | corner.normal;
            const auto [place, added] =
                others.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (added) {
                mesh.vertices.push_back(vec3(mesh.vertices[corner.vertex]));
                mesh.normals.push_back(normal(corner));
            }
            vertices.push_back(place->second);
        }
        return vertices;
    }

    vec3 normal(const Corner& corner) const {
        return corner.normal == 0 ? vec3(0) : normals_[corner.normal - 1];
    }

    ObjLines lines_;
    const MaterialLibrary& library_;
    std::vector<vec3> positions_, normals_;
    std::vector<Corner> corners_;  ///< of all faces
    std::vector<std::uint32_t> face_sizes_, face_materials_;
    std::vector<Material> materials_{Material{}};  ///< the default one, then the libraries'
    std::uint32_t material_ = 0;                   ///< of the faces to come
};

}  // namespace

Mesh read_obj(std::string_view text, const std::string& name, const MaterialLibrary& library) {
    return ObjReader(text, name, library).read();
}

}  // namespace rayshoot
