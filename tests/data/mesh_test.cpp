#include "data/mesh.h"

#include "tests/data/messages.h"

#include <bit>
#include <cstring>

namespace rayshoot {
namespace {

using Triangle3 = std::array<std::uint32_t, 3>;

Mesh read(const std::string& text, const std::string& format) {
    return read_mesh(text, format, "test" + format);
}

std::string ply(const std::string& vertices, const std::string& faces, const std::string& body,
                const std::string& format = "ascii", const std::string& more = "") {
    return "ply\nformat " + format + " 1.0\ncomment made here\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more + "element face " +
           faces + "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

template <class... Values>
std::string bytes(Values... values) {
    std::string text;
    ((text += std::string(reinterpret_cast<const char*>(&values), sizeof values)), ...);
    return text;
}

const std::string corners = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

TEST(Ply, keeps_every_face_degenerate_and_non_manifold_ones_too) {
    const Mesh mesh =
        read(ply("4", "6", corners + "3 0 1 2\n3 0 1 2\n3 2 1 0\n3 0 0 1\n3 3 3 3\n4 0 1 3 2\n"),
             ".ply");
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.triangles,
              (std::vector<Triangle3>{
                  {0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {0, 0, 1}, {3, 3, 3}, {0, 1, 3}, {0, 3, 2}}));
}

TEST(Ply, reads_what_stands_between_as_if_it_were_not_there) {
    const std::string text =
        "ply\r\nformat ascii 1.0\r\nelement material 1\r\nproperty list uchar int tags\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty double z\r\nproperty double x\r\n"
        "property list uchar float weights\r\nproperty double y\r\nelement face 1\r\n"
        "property list uchar float texcoord\r\nproperty list uint uint vertex_index\r\n"
        "property int flags\r\nelement edge 1\r\nproperty int vertex1\r\nend_header\r\n"
        "3 7 7 7\r\n255 3 1 2 0.5 0.5 2\r\n0 6 4 0 5\r\n9 9 7 1 0.5 8\r\n6 0 0 1 0 0 1 3 0 1 2 "
        "5\r\n0\r\n";
    const Mesh mesh = read(text, ".ply");
    EXPECT_EQ(mesh.vertices, (std::vector<vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}}));
}

TEST(Ply, reads_normals) {
    const Mesh mesh =
        read(ply("3", "1", "0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n", "ascii",
                 "property float nx\nproperty float ny\nproperty float nz\n"),
             ".ply");
    EXPECT_EQ(mesh.normals, (std::vector<vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

std::string binary_body(std::uint8_t corners_of_face, std::int32_t last) {
    return bytes(0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, corners_of_face, 0, 1, last);
}

TEST(Ply, reads_binary) {
    const Mesh mesh = read(ply("3", "1", binary_body(3, 2), "binary_little_endian"), ".ply");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}}));
    EXPECT_EQ(mesh.vertices[2], vec3(0, 1, 0));
}

TEST(Ply, reads_indices_of_every_type) {
    const std::string floats = binary_body(3, 2).substr(0, 36);
    const auto read_as = [&](const std::string& count, const std::string& index,
                             const std::string& face) {
        std::string text = ply("3", "1", floats + face, "binary_little_endian");
        text.replace(text.find("uchar int"), 9, count + " " + index);
        EXPECT_EQ(read(text, ".ply").triangles, (std::vector<Triangle3>{{0, 1, 2}}))
            << count << " " << index;
    };
    const std::int8_t byte = 3;
    const auto bytes_of = [](auto zero) {
        using Index = decltype(zero);
        return bytes(Index(0), Index(1), Index(2));
    };
    for (const char* type : {"char", "uchar"}) read_as(type, type, bytes(byte) + bytes_of(byte));
    for (const char* type : {"short", "ushort"})
        read_as(type, type, bytes(std::int16_t{3}) + bytes_of(std::int16_t{0}));
    for (const char* type : {"int", "uint", "int32", "uint32"})
        read_as(type, type, bytes(std::int32_t{3}) + bytes_of(std::int32_t{0}));
}

TEST(Off, reads_colours_comments_and_polygons) {
    const Mesh mesh = read(
        "COFF # with colours\n# counts\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n"
        "1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n4 0 1 2 3 0.5 0.5 0.5\n3 0 0 1\n",
        ".off");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}, {0, 2, 3}, {0, 0, 1}}));
    EXPECT_EQ(mesh.vertices[2], vec3(1, 1, 0));
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal nan 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
           "\nendloop\nendfacet\n";
}

TEST(Stl, keeps_facets_that_collapse_in_their_place) {
    const std::string good = facet("0 0 0", "1 0 0", "0 1 0"),
                      point = facet("5 5 5", "5 5 5", "5 5 5");
    const Mesh mesh =
        read("solid a b\n" + point + good + point + point + good + "endsolid a b\n", ".stl");
    ASSERT_EQ(mesh.triangles.size(), 5u);
    for (const std::size_t i : {0u, 2u, 3u})
        EXPECT_EQ(mesh.vertices[mesh.triangles[i][1]], vec3(5));
    for (const std::size_t i : {1u, 4u})
        EXPECT_EQ(mesh.vertices[mesh.triangles[i][1]], vec3(1, 0, 0));
}

TEST(Stl, reads_binary_even_when_it_begins_like_text) {
    const std::string one = bytes(0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f,
                                  0.0f, std::uint16_t{0});
    const std::string header = "solid" + std::string(75, ' ');
    const Mesh mesh = read(header + bytes(std::uint32_t{2}) + one + one, ".stl");
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(contains(message_of([&] { read(header + bytes(std::uint32_t{3}) + one, ".stl"); }),
                         "test.stl:"));
}

struct Malformed {
    std::string text, format, what;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.what;
}

class MalformedMesh : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedMesh, is_refused_with_place_and_remedy) {
    const std::string message = message_of([] { read(GetParam().text, GetParam().format); });
    EXPECT_TRUE(contains(message, "test" + GetParam().format + ":"));
    EXPECT_TRUE(contains(message, GetParam().what));
}

const float not_a_number = std::numeric_limits<float>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Ply, MalformedMesh,
    testing::Values(
        Malformed{"", ".ply", "empty"}, Malformed{"plx\n", ".ply", "begins with the line 'ply'"},
        Malformed{"ply\nformat ascii 1.0\n", ".ply", "ends within its header"},
        Malformed{"ply\nformat foo 1.0\n", ".ply", "'foo' is no format"},
        Malformed{"ply\nelement vertex x\n", ".ply", "test.ply:2"},
        Malformed{"ply\nelement vertex -1\n", ".ply", "test.ply:2"},
        Malformed{"ply\nproperty float x\n", ".ply", "before the first element"},
        Malformed{"ply\nelement vertex 1\nproperty real x\n", ".ply", "'real' is no type"},
        Malformed{"ply\nelement vertex 1\nproperty list float int x\n", ".ply", "integer type"},
        Malformed{"ply\nend_header\n", ".ply", "no line 'format'"},
        Malformed{"ply\nformat ascii 1.0\nend_header\n", ".ply", "no element 'vertex'"},
        Malformed{ply("3", "0", "0 0 0 1 0 0 0 1 0\n"), ".ply", "no faces"},
        Malformed{ply("2000000000", "1", corners), ".ply", "declares 2000000000"},
        Malformed{ply("3", "99999999999999999", corners), ".ply", "declares 99999999999999999"},
        Malformed{ply("4", "1", corners + "3 0 1 4\n"), ".ply", "face 0"},
        Malformed{ply("4", "1", corners + "3 0 1 -1\n"), ".ply", "face 0"},
        Malformed{ply("4", "1", corners + "3 0 1 4294967296\n"), ".ply", "test.ply"},
        Malformed{ply("4", "1", corners + "2 0 1\n"), ".ply", "face 0 (counted from 0): has 2"},
        Malformed{ply("4", "1", corners + "200000 0 1 2\n"), ".ply", "does not fit"},
        Malformed{ply("4", "2", corners + "3 0 1 2\n3 0 1"), ".ply",
                  "face 1 (counted from 0): a list of 3 values does not fit"},
        Malformed{ply("4", "1", "0 0 0\n1 nan 0\n0 1 0\n1 1 0\n3 0 1 2\n"), ".ply", "vertex 1"},
        Malformed{ply("4", "1", "0 0 0\n1 x 0\n0 1 0\n1 1 0\n3 0 1 2\n"), ".ply", "vertex 1"},
        Malformed{ply("3", "1", binary_body(3, 3), "binary_little_endian"), ".ply", "face 0"},
        Malformed{ply("3", "1", binary_body(4, 2), "binary_little_endian"), ".ply", "face 0"},
        Malformed{ply("3", "1", binary_body(3, 2).substr(0, 45), "binary_little_endian"), ".ply",
                  "face 0"},
        Malformed{ply("3", "1", bytes(0.0f, not_a_number) + binary_body(3, 2).substr(8),
                      "binary_little_endian"),
                  ".ply", "vertex 0"},
        Malformed{ply("3", "1", binary_body(3, 2), "binary_big_endian"), ".ply", "test.ply"}));

INSTANTIATE_TEST_SUITE_P(
    Off, MalformedMesh,
    testing::Values(
        Malformed{"OF\n", ".off", "test.off:1: an OFF file begins with OFF"},
        Malformed{"OFF BINARY\n", ".off", "binary OFF is not read"},
        Malformed{"4OFF\n1 1 0\n", ".off", "three dimensions"},
        Malformed{"OFF\n-1 1 0\n", ".off", "test.off:2"},
        Malformed{"OFF\n4000000000 1 0\n", ".off", "declares 4000000000 vertices"},
        Malformed{"OFF\n4 4000000000 0\n" + corners, ".off", "declares 4000000000 faces"},
        Malformed{"OFF\n4 1 0\n" + corners, ".off", "test.off:7: the file ends"},
        Malformed{"OFF\n4 1 0\n" + corners + "3 0 1 4\n", ".off", "test.off:7: 4 is out of range"},
        Malformed{"OFF\n4 1 0\n" + corners + "2 0 1 # line\n", ".off",
                  "test.off:7: 2 is out of range"},
        Malformed{"OFF\n4 1 0\n" + corners + "4000000000 0 1\n", ".off", "out of range"},
        Malformed{"OFF\n4 1 0\n" + corners + "3 0 1 2\n3 0 1 2\n", ".off", "after the last face"},
        Malformed{"OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", ".off", "test.off:4: 'inf'"}));

INSTANTIATE_TEST_SUITE_P(
    Stl, MalformedMesh,
    testing::Values(Malformed{"solid x\nendsolid x\n", ".stl", "no faces"},
                    Malformed{"solid x\n" + facet("0 0 0", "1 0 0", "0 1 0"), ".stl",
                              "without endsolid"},
                    Malformed{"solid x\n" + facet("0 0 0", "1 inf 0", "0 1 0") + "endsolid\n",
                              ".stl", "test.stl:5: 'inf'"},
                    Malformed{"solid x\nfacet normal 0 0 1\nvertex 0 0 0\n", ".stl", "test.stl:3"},
                    Malformed{"not an stl", ".stl", "neither a text STL"}));

TEST(Subdivision, quadruples_the_triangles_of_a_closed_mesh) {
    const Mesh tetrahedron = read(
        ply("4", "4", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"), ".ply");
    const Mesh smooth = subdivide(tetrahedron, 3, "t");
    EXPECT_EQ(smooth.triangles.size(), 4u * 64);
    EXPECT_EQ(smooth.vertices.size(), 2u + 4 * 64 / 2);  // Euler: V = 2 + F / 2
    for (const vec3& v : smooth.vertices) {
        EXPECT_TRUE(finite(v));
        EXPECT_LE(v.x + v.y + v.z, 1);  // within the convex hull
    }
    EXPECT_EQ(subdivide(tetrahedron, 0, "t").triangles, tetrahedron.triangles);
}

TEST(Subdivision, refuses_what_is_no_manifold_and_what_gets_too_large) {
    const Mesh fin = read(ply("4", "3", corners + "3 0 1 2\n3 1 0 3\n3 0 1 3\n"), ".ply");
    EXPECT_TRUE(
        contains(message_of([&] { subdivide(fin, 1, "fin"); }), "fin: loop= wants a manifold"));
    const Mesh point = read(ply("4", "1", corners + "3 0 0 1\n"), ".ply");
    EXPECT_TRUE(contains(message_of([&] { subdivide(point, 1, "p"); }), "triangle 0"));
    const Mesh one = read(ply("4", "1", corners + "3 0 1 2\n"), ".ply");
    EXPECT_TRUE(contains(message_of([&] { subdivide(one, 12, "one"); }), "at most loop=11"));
}

TEST(MeshScene, is_framed_and_lit_the_same_way_at_every_size) {
    const Mesh mesh = read(ply("4", "2", corners + "3 0 1 2\n3 1 3 2\n"), ".ply");
    const Scene unit = mesh_scene(mesh, Precision::standard, "test");
    Mesh large = mesh;
    for (vec3& v : large.vertices) v *= 1024;
    const Scene scaled = mesh_scene(large, Precision::standard, "test");
    EXPECT_EQ(scaled.camera.from, unit.camera.from * 1024.0f);
    EXPECT_EQ(unit.camera.at, vec3(0.5f, 0.5f, 0));
    EXPECT_EQ(unit.lights.size(), 1u);
    EXPECT_TRUE(unit.lights[0].samples.contains(unit.lights[0].position));
    EXPECT_EQ(unit.material_of.size(), 2u);
    for (vec3& v : large.vertices) v *= 3e35f;
    EXPECT_TRUE(
        contains(message_of([&] { mesh_scene(large, Precision::standard, "test"); }), "too large"));
}

}  // namespace
}  // namespace rayshoot
