#include "data/scenes.h"

#include "data/mesh_catalogue.h"
#include "tests/data/messages.h"

#include <charconv>
#include <fstream>
#include <map>

/// The scenes below $RAYSHOOT_SCENES against the tables of the README that comes with them:
/// `| file | primitives | spheres / cones / polygons | sides | lights | box min | box max |` and
/// `| file | triangles | vertices | sides | box min | box max |`.
namespace rayshoot {
namespace {

using Row = std::vector<std::string>;

Row cells(const std::string& line) {
    Row row;
    std::size_t begin = line.find('|') + 1;
    for (std::size_t end; (end = line.find('|', begin)) != line.npos; begin = end + 1) {
        const std::string cell = line.substr(begin, end - begin);
        const std::size_t first = cell.find_first_not_of(' ');
        row.push_back(
            first == cell.npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    return row;
}

std::vector<Row> rows(const std::string& folder) {
    std::vector<Row> found;
    if (!scene_collection()) return found;
    std::ifstream readme(*scene_collection() / "README.md");
    for (std::string line; std::getline(readme, line);)
        if (line.starts_with("| " + folder + "/")) found.push_back(cells(line));
    return found;
}

std::vector<double> numbers(const std::string& cell) {
    std::vector<double> values;
    std::istringstream in(cell);
    for (std::string word; in >> word;) {
        double value = 0;
        const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
        if (end.ec == std::errc{}) values.push_back(value);
    }
    return values;
}

/// To the five digits that the tables print, and the padding of bounds.
void expect_near(const vec3& value, const std::string& cell, const Box& box) {
    const std::vector<double> printed = numbers(cell);
    ASSERT_EQ(printed.size(), 3u);
    const double size = length(dvec3(box.hi) - dvec3(box.lo));
    for (int axis = 0; axis < 3; ++axis) {
        const double expected = printed[static_cast<std::size_t>(axis)];
        EXPECT_NEAR(value[axis], expected, 6e-5 * std::abs(expected) + 1e-6 * size) << axis;
    }
}

void expect_box(const Scene& scene, const std::string& lo, const std::string& hi) {
    const Box& box = scene.geometry.bounds();
    expect_near(box.lo, lo, box);
    expect_near(box.hi, hi, box);
}

std::uint32_t count(const Scene& scene, PrimitiveKind kind) {
    return scene.geometry.count_by_kind()[static_cast<std::size_t>(kind)];
}

TEST(Collection, spd_files_have_the_primitives_lights_and_boxes_of_its_table) {
    const auto table = rows("spd");
    if (table.empty()) GTEST_SKIP() << "RAYSHOOT_SCENES names no collection with a README";
    for (const Row& row : table) {
        SCOPED_TRACE(row[0]);
        const Scene scene = load_scene(row[0]);
        const std::vector<double> kinds = numbers(row[2]);
        ASSERT_EQ(kinds.size(), 3u);
        EXPECT_EQ(scene.geometry.size(), numbers(row[1]).at(0));
        EXPECT_EQ(count(scene, PrimitiveKind::sphere), kinds[0]);
        EXPECT_EQ(count(scene, PrimitiveKind::frustum), kinds[1]);
        EXPECT_EQ(count(scene, PrimitiveKind::triangle) + count(scene, PrimitiveKind::polygon),
                  kinds[2]);
        std::size_t most_sides = count(scene, PrimitiveKind::triangle) > 0 ? 3 : 0;
        for (std::uint32_t i = 0; i < count(scene, PrimitiveKind::polygon); ++i)
            most_sides = std::max(most_sides, scene.geometry.polygon(i).corners.size());
        EXPECT_EQ(most_sides, numbers(row[3]).at(0));
        EXPECT_EQ(scene.lights.size(), numbers(row[4]).at(0));
        expect_box(scene, row[5], row[6]);
    }
}

TEST(Collection, meshes_have_the_triangles_vertices_and_boxes_of_its_table) {
    const auto table = rows("meshes");
    if (table.empty()) GTEST_SKIP() << "RAYSHOOT_SCENES names no collection with a README";
    for (const Row& row : table) {
        SCOPED_TRACE(row[0]);
        const Scene scene = load_scene(row[0]);
        EXPECT_EQ(scene.geometry.size(), numbers(row[1]).at(0));
        EXPECT_TRUE(scene.geometry.only_static_triangles());
        // An OBJ file's vertices are more where a position has several normals.
        if (row[0].find(".obj") == row[0].npos)
            EXPECT_EQ(scene.geometry.vertices().size(), numbers(row[2]).at(0));
        else EXPECT_GE(scene.geometry.vertices().size(), numbers(row[2]).at(0));
        expect_box(scene, row[4], row[5]);
    }
}

TEST(Collection, only_manifolds_are_subdivided) {
    if (rows("meshes").empty()) GTEST_SKIP() << "RAYSHOOT_SCENES names no collection with a README";
    EXPECT_EQ(load_scene("mesh/spot:loop=1").geometry.size(), 4u * 5856);
    for (const char* scene : {"meshes/dragon_vrip_res4.ply.gz:loop=1", "mesh/sibenik:loop=1"})
        EXPECT_TRUE(contains(message_of([&] { load_scene(scene); }), "wants a manifold"));
}

}  // namespace
}  // namespace rayshoot
