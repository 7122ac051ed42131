#include "data/file.h"
#include "data/nff.h"
#include "tests/generators/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>

/// Generated scenes against the files that the suite's own programs wrote, bit for bit.
namespace rayshoot {
namespace {

struct Reference {
    const char* scene;
    const char* file;  ///< under RAYSHOOT_SCENES/spd
};

using Numbers = std::vector<float>;

void append(Numbers& to, std::initializer_list<vec3> points) {
    for (const vec3& p : points) to.insert(to.end(), {p.x, p.y, p.z});
}

void append_triangle(Numbers& to, const Geometry& geometry, std::uint32_t index) {
    for (const std::uint32_t vertex : geometry.triangles()[index]) {
        append(to, {geometry.vertices()[vertex]});
        if (!geometry.vertex_normals().empty()) append(to, {geometry.vertex_normals()[vertex]});
    }
}

/// The kind and every number of a primitive.
Numbers numbers(const Geometry& geometry, std::uint32_t primitive) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    Numbers all{static_cast<float>(ref.kind)};
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            append_triangle(all, geometry, ref.index);
            break;
        case PrimitiveKind::sphere: {
            const Sphere& sphere = geometry.sphere(ref.index);
            append(all, {sphere.centre, vec3(sphere.radius)});
            break;
        }
        case PrimitiveKind::frustum: {
            const Frustum& f = geometry.frustum(ref.index);
            append(all, {f.base, f.apex, vec3(f.base_radius, f.apex_radius, 0)});
            break;
        }
        case PrimitiveKind::polygon:
            for (const vec3& corner : geometry.polygon(ref.index).corners) append(all, {corner});
            for (const vec3& normal : geometry.polygon(ref.index).normals) append(all, {normal});
            break;
    }
    return all;
}

Numbers numbers(const Material& m) {
    return {m.colour.x, m.colour.y,  m.colour.z,      m.diffuse,
            m.specular, m.shininess, m.transmittance, m.refraction_index};
}

Numbers lights_and_view(const Scene& scene) {
    Numbers all;
    for (const Light& light : scene.lights) append(all, {light.position, light.intensity});
    const Camera& camera = scene.camera;
    append(all, {camera.from, camera.at, camera.up, scene.background});
    append(all, {vec3(camera.angle, camera.hither, 0), vec3(camera.width, camera.height, 0)});
    return all;
}

/// Floats that are not the same bits; those that only one has count too.
std::size_t differences(const Numbers& a, const Numbers& b) {
    std::size_t count = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]);
    return count;
}

class ReferenceTest : public testing::TestWithParam<Reference> {};

TEST_P(ReferenceTest, generated_scene_equals_the_file) {
    const char* const folder = std::getenv("RAYSHOOT_SCENES");
    if (!folder) GTEST_SKIP() << "RAYSHOOT_SCENES is unset: no reference files to compare with";
    const auto path = std::filesystem::path(folder) / "spd" / GetParam().file;
    const Scene file = read_nff(read_file(path), path.filename().string());
    const Scene made = generate_scene(GetParam().scene);

    ASSERT_EQ(made.geometry.size(), file.geometry.size());
    std::size_t different = 0;
    for (std::uint32_t i = 0; i < file.geometry.size(); ++i) {
        const std::size_t here = differences(numbers(made.geometry, i), numbers(file.geometry, i)) +
                                 differences(numbers(made.material(i)), numbers(file.material(i)));
        if (here > 0 && different == 0) ADD_FAILURE() << "the first primitive that differs: " << i;
        different += here;
    }
    EXPECT_EQ(different, 0u) << "numbers differ";
    EXPECT_EQ(differences(lights_and_view(made), lights_and_view(file)), 0u);
    EXPECT_EQ(digest(made), digest(file));
}

std::string test_name(const testing::TestParamInfo<Reference>& info) {
    std::string name = info.param.file;
    name.resize(name.find('.'));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(
    Spd, ReferenceTest,
    testing::Values(
        Reference{"spd/balls:size=3", "balls-s3.nff.xz"}, Reference{"spd/balls", "balls.nff.xz"},
        Reference{"spd/balls:size=5", "balls-s5.nff.xz"}, Reference{"spd/gears", "gears.nff.xz"},
        Reference{"spd/jacks", "jacks.nff.xz"}, Reference{"spd/lattice", "lattice.nff.xz"},
        Reference{"spd/mount", "mount.nff.xz"}, Reference{"spd/mount:size=8", "mount-s8.nff.xz"},
        Reference{"spd/rings", "rings.nff.xz"}, Reference{"spd/shells", "shells.nff.xz"},
        Reference{"spd/sombrero", "sombrero.nff.xz"}, Reference{"spd/teapot", "teapot-s12.nff.xz"},
        Reference{"spd/teapot:size=6", "teapot-s6.nff.xz"},
        Reference{"spd/tetra:size=5", "tetra-s5.nff.xz"}, Reference{"spd/tetra", "tetra.nff.xz"},
        Reference{"spd/tetra:size=8", "tetra-s8.nff.xz"}, Reference{"spd/tree", "tree.nff.xz"},
        Reference{"spd/tree:size=14", "tree-s14.nff.xz"}),
    test_name);

}  // namespace
}  // namespace rayshoot
