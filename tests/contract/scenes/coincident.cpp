#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Ties: primitives in the same place, hits at the same t, corners on the planes between cells.
namespace rayshoot::contract {
namespace {

void coincident_triangles(GeometryBuilder& builder) {
    for (int i = 0; i < 100; ++i)
        builder.add_triangle(vec3(0, 0, 0.5f), vec3(1, 0, 0.25f), vec3(0, 1, 0.125f));
}

void coincident_spheres(GeometryBuilder& builder) {
    for (int i = 0; i < 70; ++i) builder.add_sphere({vec3(1, 2, 3), 0.5f});
}

void duplicates(GeometryBuilder& builder) {
    for (int copy = 0; copy < 16; ++copy) {
        Random random(0xd0b1e5);
        add_soup(builder, random, Box{vec3(-1), vec3(1)}, 0.5f, 24);
    }
}

/// The same triangles wound and rotated differently: equal points, other floats on the way there.
void turned_duplicates(GeometryBuilder& builder) {
    Random random(0x702);
    for (int i = 0; i < 40; ++i) {
        const Box box{vec3(-1), vec3(1)};
        const vec3 a = random.inside(box), b = random.inside(box), c = random.inside(box);
        builder.add_triangle(a, b, c);
        builder.add_triangle(b, c, a);
        builder.add_triangle(c, b, a);
    }
}

/// Overlapping triangles in one slanted plane (up to rounding): hits differ by an ulp or not at
/// all.
void coplanar_soup(GeometryBuilder& builder) {
    Random random(0xc09);
    for (int i = 0; i < 250; ++i) {
        std::array<vec3, 3> corners;
        for (vec3& p : corners) {
            const float x = random.between(-1, 1), y = random.between(-1, 1);
            p = vec3(x, y, std::fma(0.3f, x, 0.1f * y));
        }
        builder.add_triangle(corners[0], corners[1], corners[2]);
    }
}

/// Quads on the faces of a 4 x 4 x 4 lattice: every corner lies on likely split planes.
void lattice_faces(GeometryBuilder& builder) {
    for (int plane = 0; plane <= 4; ++plane)
        for (int axis = 0; axis < 3; ++axis)
            for (int u = 0; u < 4; ++u)
                for (int v = 0; v < 4; v += 1 + (u + plane + axis) % 2) {
                    vec3 corner(0), across(0), along_v(0);
                    corner[axis] = static_cast<float>(plane);
                    corner[(axis + 1) % 3] = static_cast<float>(u);
                    corner[(axis + 2) % 3] = static_cast<float>(v);
                    across[(axis + 1) % 3] = 1;
                    along_v[(axis + 2) % 3] = 1;
                    builder.add_triangle(corner, corner + across, corner + along_v);
                }
}

/// Cubes that share corners, edges and faces, like a solid built of bricks.
void bricks(GeometryBuilder& builder) {
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int z = 0; z < 3; ++z)
                if ((x + y + z) % 4 != 3)
                    add_cube(builder, vec3(x, y, z), vec3(x + 1, y + 1, z + 1));
}

void touching_spheres(GeometryBuilder& builder) {
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            for (int z = 0; z < 4; ++z) builder.add_sphere({vec3(x, y, z), 0.5f});
}

}  // namespace

std::vector<Recipe> coincident_scenes() {
    return {{"coincident_triangles", coincident_triangles},
            {"coincident_spheres", coincident_spheres},
            {"duplicates", duplicates},
            {"turned_duplicates", turned_duplicates},
            {"coplanar_soup", coplanar_soup},
            {"lattice_faces", lattice_faces},
            {"bricks", bricks},
            {"touching_spheres", touching_spheres}};
}

}  // namespace rayshoot::contract
