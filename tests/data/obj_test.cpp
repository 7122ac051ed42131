#include "data/obj.h"

#include "tests/data/messages.h"

namespace rayshoot {
namespace {

std::optional<std::string> no_library(const std::string&) { return std::nullopt; }

Mesh read(const std::string& text, const MaterialLibrary& library = no_library) {
    return read_obj(text, "test.obj", library);
}

using Triangle3 = std::array<std::uint32_t, 3>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // four lines

TEST(Obj, cuts_faces_into_fans) {
    const Mesh mesh = read(square + "f 1 2 3 4\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(Obj, counts_negative_indices_from_the_last_vertex_so_far) {
    const Mesh mesh = read(square + "f -4 -3 -2\nv 5 5 5\nf -1// -2/ -3\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}, {4, 3, 2}}));
}

TEST(Obj, keeps_degenerate_and_duplicate_faces) {
    EXPECT_EQ(read(square + "f 1 1 2\nf 3 3 3\nf 1 2 3\nf 1 2 3\nf 3 2 1\n").triangles.size(), 5u);
}

TEST(Obj, gives_a_position_with_two_normals_two_vertices) {
    const Mesh mesh =
        read(square + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//2\nf 1//2 3 4//2\n");
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}, {4, 2, 3}, {4, 5, 3}}));
    EXPECT_EQ(mesh.vertices[4], mesh.vertices[0]);
    EXPECT_EQ(mesh.normals[0], vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[4], vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[5], vec3(0));
}

TEST(Obj, reads_any_line_ends_continuations_and_comments) {
    const std::string lines =
        "# c\n" + square + "g a b\no thing\ns off\nf 1 2 \\\n3 # done\nl 1 2\np 1";
    std::string crlf, cr;
    for (const char c : lines) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    for (const std::string& text : {lines, crlf, cr}) EXPECT_EQ(read(text).triangles.size(), 1u);
}

TEST(Obj, takes_materials_from_a_library_and_the_default_for_unknown_ones) {
    const auto library = [](const std::string& name) -> std::optional<std::string> {
        if (name != "m.mtl") return std::nullopt;
        return "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 2\nKs 0.5 0.25 0\nNs 50\nillum 7\nd "
               "0.25\n"
               "Ni 1.5\n";
    };
    const Mesh mesh =
        read("mtllib none.mtl\nmtllib m.mtl\n" + square +
                 "f 1 2 3\nusemtl glass\nf 1 2 3 4\nusemtl red\nf 1 2 3\nusemtl x\nf 2 3 4\n",
             library);
    EXPECT_EQ(mesh.material_of, (std::vector<std::uint32_t>{0, 2, 2, 1, 0}));
    EXPECT_EQ(mesh.materials.at(1).colour, vec3(1, 0, 0));
    EXPECT_EQ(mesh.materials.at(1).specular, 0);
    EXPECT_EQ(mesh.materials.at(2).colour, vec3(0, 0, 1));
    EXPECT_EQ(mesh.materials.at(2).specular, 0.5f);
    EXPECT_EQ(mesh.materials.at(2).transmittance, 0.75f);
    EXPECT_EQ(mesh.materials.at(2).refraction_index, 1.5f);
}

struct Malformed {
    std::string text;
    int line;
    std::string what;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.what;
}

class MalformedObj : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedObj, is_refused_with_line_and_remedy) {
    const std::string message = message_of([] { read(GetParam().text); });
    EXPECT_TRUE(contains(message, "test.obj:" + std::to_string(GetParam().line) + ": "));
    EXPECT_TRUE(contains(message, GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedObj,
    testing::Values(Malformed{"", 1, "without a face"}, Malformed{square, 4, "without a face"},
                    Malformed{square + "f 1 2 5\n", 5, "vertex 5, but the file has 4"},
                    Malformed{square + "f 0 1 2\n", 5, "vertex 0"},
                    Malformed{square + "f -5 1 2\n", 5, "vertex -5"},
                    Malformed{square + "f 1//1 2 3\n", 5, "normal 1, but the file has 0"},
                    Malformed{square + "f 1 2\n", 5, "fewer than three corners"},
                    Malformed{square + "f\n", 5, "fewer than three corners"},
                    Malformed{square + "f 1 2 x\n", 5, "'x' is not a corner"},
                    Malformed{square + "f 1 2 3/1/1/1\n", 5, "'3/1/1/1'"},
                    Malformed{square + "f 1 2 4294967297\n", 5, "is not a corner"},
                    Malformed{square + "f 1 2 3.5\n", 5, "is not a corner"},
                    Malformed{square + "f 1 2 /3\n", 5, "is not a corner"},
                    Malformed{"v 1 2\n", 1, "three numbers"},
                    Malformed{"v 1 2 nan\n", 1, "'nan' is not a finite number"},
                    Malformed{"\r\n\r\nv inf 2 3\r\n", 3, "'inf' is not a finite number"},
                    Malformed{"v 1e39 2 3\n", 1, "'1e39'"},
                    Malformed{"v 1 2 3\\\n4\nv 1 2 x\n", 3, "'x'"},
                    Malformed{"vn 0 zero 0\n", 1, "'zero'"}));

}  // namespace
}  // namespace rayshoot
