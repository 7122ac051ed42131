#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <numbers>

/// A pyramid of dodecahedra made of six linked pentagonal rings each, before a wall.
/// 5 size (size + 1) (2 size + 1) spheres, as many cylinders, and the wall.
namespace rayshoot::procedural {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.07412;  // of rods and joints: the rings just touch
constexpr int rings_each = 6, joints = 5;

using Joints = std::array<dvec3, rings_each * joints>;

/// The joints of one object, within the unit sphere: the first ring lies in the plane z = 0, the
/// others are tilted by the dodecahedron's dihedral angle and turned by odd tenths of a circle.
Joints object_joints() {
    const double scale = 1 / (1 + radius);
    const Matrix tilt = rotation(x_axis, 2 * std::acos(std::cos(pi / 3) / std::sin(pi / 5)));
    Joints all;
    for (std::size_t i = 0; i < joints; ++i) {
        const double angle = static_cast<double>(i) * 2 * pi / 5;
        all[i] = {scale * std::cos(angle), scale * std::sin(angle), 0};
    }
    for (std::size_t ring = 1; ring < rings_each; ++ring) {
        const Matrix turn = rotation(z_axis, pi * (2 * static_cast<double>(ring - 1) + 1) / 5);
        for (std::size_t i = 0; i < joints; ++i)
            all[ring * joints + i] = point(point(all[i], tilt), turn);
    }
    return all;
}

void print_object(Printer& printer, const Joints& all, const dvec3& offset) {
    constexpr std::array colours{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1),
                                 dvec3(0, 1, 1), dvec3(1, 0, 1), dvec3(1, 1, 0)};
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % joints == 0)
            printer.surface({.colour = colours[i / joints],
                             .diffuse = 0.5,
                             .specular = 0.2,
                             .highlight_angle = 37});
        const dvec3 joint = all[i] + offset;
        const dvec3 before = all[i % joints == 0 ? i + joints - 1 : i - 1] + offset;
        printer.frustum(joint, radius, before, radius);
        printer.sphere(joint, radius);
    }
}

}  // namespace

Scene rings(int size, Precision precision) {
    const double spread = 1 / std::sin(pi / 8);  // between layers
    const dvec3 from(-1, -spread, 0.5);
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = from, .at = {-1, from.y + 1, 0.5}, .up = {0, 0, 1}, .hither = 1});
    for (const dvec3 light : {dvec3(3, -spread, 3), dvec3(-4, -spread, 1), dvec3(2, -spread, -4)})
        printer.light(light);

    printer.surface({});
    const double wall = spread * (size + 1);
    const double reach = 1.01 * (wall - from.y) * std::tan(pi / 8);  // a percent beyond the view
    const double left = -reach + from.x, right = reach + from.x;
    const double low = -reach + from.z, high = reach + from.z;
    printer.polygon(std::array{dvec3(right, wall, high), dvec3(left, wall, high),
                               dvec3(left, wall, low), dvec3(right, wall, low)});

    const Joints all = object_joints();
    for (int layer = 0; layer < size; ++layer)
        for (int z = 0; z <= layer; ++z)
            for (int x = 0; x <= layer; ++x)
                print_object(printer, all, {2 * x - layer, spread * (layer + 1), 2 * z - layer});
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural
