#include <gtest/gtest.h>

#include "accel/bsp/general/polyhedron.h"

#include <random>

namespace rayshoot::bsp_test {
namespace {

const Box unit_cube{vec3(0), vec3(1)};
const double root_2 = std::sqrt(2.0), root_3 = std::sqrt(3.0);

ObliquePlane through(const vec3& normal, double at) {
    const double size = length(dvec3(normal));
    return {vec3(dvec3(normal) / size), static_cast<float>(at / size)};
}

TEST(Polyhedron, of_a_box_has_the_area_of_its_faces) {
    EXPECT_NEAR(Polyhedron({vec3(1, 2, 3), vec3(2, 4, 6)}, vec3(5)).area(), 22, 1e-12);
}

TEST(Polyhedron, of_half_a_cube_cut_along_a_diagonal_has_half_its_faces_and_the_cut) {
    const Polyhedron cube(unit_cube, vec3(0));
    const ObliquePlane plane = through({1, -1, 0}, 0);
    for (const Polyhedron& half : {cube.below(plane), cube.above(plane)})
        EXPECT_NEAR(half.area(), 3 + root_2, 1e-6);
}

TEST(Polyhedron, of_a_cubes_corner_is_a_tetrahedron) {
    const Polyhedron cube(unit_cube, vec3(0));
    const ObliquePlane plane = through({1, 1, 1}, 0.5);
    EXPECT_NEAR(cube.below(plane).area(), 0.25 * (1.5 + root_3 / 2), 1e-6);
    EXPECT_EQ(cube.below(plane).faces(), 4u);
    EXPECT_NEAR(cube.above(plane).area(), 6 - 0.25 * (1.5 - root_3 / 2), 1e-6);
    EXPECT_EQ(cube.above(plane).faces(), 7u);
}

TEST(Polyhedron, of_a_cube_without_its_corners_is_an_octahedron) {
    Polyhedron cell({vec3(-1), vec3(1)}, vec3(0));
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) cell = cell.below(through({x, y, z}, 1));
    EXPECT_NEAR(cell.area(), 4 * root_3, 1e-5);
}

TEST(Polyhedron, halves_have_the_areas_foretold_for_however_many_cuts) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-1, 1);
    for (int i = 0; i < 200; ++i) {
        Polyhedron cell({vec3(-1), vec3(1)}, vec3(0));
        for (int cuts = 0; cuts < 20 && cell.faces() > 0; ++cuts) {
            const float x = place(random), y = place(random), z = place(random);
            const ObliquePlane plane = through({x, y, z}, 0.3f * place(random));
            const Polyhedron::Areas areas = cell.areas_of_halves(plane);
            const Polyhedron below = cell.below(plane), above = cell.above(plane);
            EXPECT_NEAR(areas.below, below.area(), 1e-9);
            EXPECT_NEAR(areas.above, above.area(), 1e-9);
            EXPECT_GE(areas.below + areas.above, cell.area() - 1e-9);
            cell = areas.below > areas.above ? below : above;
        }
    }
}

TEST(Polyhedron, beside_a_plane_is_whole_on_one_side_and_nothing_on_the_other) {
    const Polyhedron cube(unit_cube, vec3(0));
    const ObliquePlane plane = through({1, 2, 3}, -1);
    EXPECT_EQ(cube.areas_of_halves(plane).below, 0);
    EXPECT_NEAR(cube.areas_of_halves(plane).above, 6, 1e-12);
    EXPECT_EQ(cube.below(plane).faces(), 0u);
    EXPECT_NEAR(cube.above(plane).area(), 6, 1e-12);
}

}  // namespace
}  // namespace rayshoot::bsp_test
