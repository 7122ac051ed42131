#include "data/generators/printer.h"
#include "data/generators/scenes.h"

#include <array>
#include <cmath>

/// A chair of 96 turned parts, grouped as a modeller would: arms, back, seat, legs, each group with
/// a bounding box and the whole with a sphere (Rubin & Whitted 1980). Metres, z up, seen from +y.
namespace rayshoot::procedural {

namespace {

constexpr double half_width = 0.25, half_depth = 0.22, seat_height = 0.45, top = 1.05;

/// Prints parts and remembers which group each belongs to.
class Workshop {
public:
    explicit Workshop(Printer& printer) : printer_(printer), groups_(1) {}

    std::uint32_t group(std::uint32_t parent = 0) {
        const auto id = static_cast<std::uint32_t>(groups_.size());
        groups_.emplace_back();
        groups_[parent].groups.push_back(id);
        return id;
    }
    void rod(std::uint32_t group, const dvec3& from, double from_radius, const dvec3& to,
             double to_radius) {
        groups_[group].primitives.push_back(printer_.count());
        printer_.frustum(from, from_radius, to, to_radius);
    }
    void ball(std::uint32_t group, const dvec3& centre, double radius) {
        groups_[group].primitives.push_back(printer_.count());
        printer_.sphere(centre, radius);
    }

    Hierarchy hierarchy(const Geometry& geometry) &&;

private:
    Printer& printer_;
    std::vector<Hierarchy::Group> groups_;
};

/// Round the middle of the box, through its corners, and a thousandth wider, so that no rounding in
/// a sphere test can lose what is inside.
Sphere sphere_round(const Box& box) {
    const dvec3 half = 0.5 * (dvec3(box.hi) - dvec3(box.lo));
    const double radius = 1.001 * length(half);
    return {.centre = box.centre(), .radius = static_cast<float>(radius)};
}

/// A group comes after its parent, so the boxes are made from the last to the first.
Hierarchy Workshop::hierarchy(const Geometry& geometry) && {
    std::vector<Box> boxes(groups_.size());
    for (std::size_t i = groups_.size(); i-- > 0;) {
        for (const std::uint32_t group : groups_[i].groups) boxes[i].include(boxes[group]);
        for (const std::uint32_t part : groups_[i].primitives)
            boxes[i].include(geometry.bounds(part));
        groups_[i].bound = boxes[i];
    }
    groups_[0].bound = sphere_round(boxes[0]);
    return {std::move(groups_)};
}

/// `count` places from `from` to `to`, ends included.
template <class Make>
void along_line(const dvec3& from, const dvec3& to, int count, Make&& make) {
    for (int i = 0; i < count; ++i)
        make(from + (to - from) * (static_cast<double>(i) / (count - 1)));
}

/// Four turned legs of six parts.
void make_legs(Workshop& workshop) {
    const std::uint32_t legs = workshop.group();
    for (const double x : {-half_width, half_width})
        for (const double y : {-half_depth, half_depth}) {
            const std::uint32_t leg = workshop.group(legs);
            const auto at = [&](double height) { return dvec3(x, y, height); };
            workshop.ball(leg, at(0.02), 0.02);
            workshop.rod(leg, at(0.02), 0.012, at(0.15), 0.022);
            workshop.rod(leg, at(0.15), 0.022, at(0.25), 0.015);
            workshop.ball(leg, at(0.26), 0.024);
            workshop.rod(leg, at(0.27), 0.015, at(0.36), 0.024);
            workshop.rod(leg, at(0.36), 0.024, at(seat_height), 0.018);
        }
}

/// A frame of four rails and four corner balls with sixteen slats: 24 parts.
void make_seat(Workshop& workshop) {
    const std::uint32_t seat = workshop.group();
    const auto corner = [](double x, double y) {
        return dvec3(x * half_width, y * half_depth, seat_height);
    };
    const std::array corners{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    for (std::size_t i = 0; i < 4; ++i) {
        workshop.ball(seat, corners[i], 0.028);
        workshop.rod(seat, corners[i], 0.02, corners[(i + 1) % 4], 0.02);
    }
    along_line(corner(-0.9, -1), corner(0.9, -1), 16, [&](const dvec3& front) {
        workshop.rod(seat, front, 0.012, {front.x, half_depth, front.z}, 0.012);
    });
}

/// Two posts with finials, two rails and thirteen spindles of two cones each: 32 parts.
void make_back(Workshop& workshop) {
    const std::uint32_t back = workshop.group();
    const dvec3 left(-half_width, -half_depth, 0), right(half_width, -half_depth, 0);
    for (const dvec3& post : {left, right}) {
        workshop.rod(back, post + dvec3(0, 0, seat_height), 0.02, post + dvec3(0, 0, top), 0.016);
        workshop.ball(back, post + dvec3(0, 0, top), 0.03);
    }
    constexpr double low = 0.55, high = 1;
    for (const double height : {low, high})
        workshop.rod(back, left + dvec3(0, 0, height), 0.015, right + dvec3(0, 0, height), 0.015);
    along_line(0.9 * left, 0.9 * right, 13, [&](const dvec3& spindle) {
        const auto at = [&](double height) { return dvec3(spindle.x, -half_depth, height); };
        workshop.rod(back, at(low), 0.006, at((low + high) / 2), 0.011);
        workshop.rod(back, at((low + high) / 2), 0.011, at(high), 0.006);
    });
}

/// Two arms of eight parts: a rest with a ball at either end, a post and four spindles.
void make_arms(Workshop& workshop) {
    const std::uint32_t arms = workshop.group();
    for (const double x : {-half_width, half_width}) {
        const std::uint32_t arm = workshop.group(arms);
        const auto at = [&](double y, double height) { return dvec3(x, y, height); };
        constexpr double rest = 0.68;
        workshop.rod(arm, at(-half_depth, rest), 0.018, at(half_depth, rest), 0.022);
        workshop.ball(arm, at(-half_depth, rest), 0.026);
        workshop.ball(arm, at(half_depth, rest), 0.03);
        workshop.rod(arm, at(half_depth, seat_height), 0.02, at(half_depth, rest), 0.016);
        along_line(at(-0.12, 0), at(0.12, 0), 4, [&](const dvec3& spindle) {
            workshop.rod(arm, at(spindle.y, seat_height), 0.01, at(spindle.y, rest), 0.007);
        });
    }
}

}  // namespace

Scene chair(Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {1.1, 1.9, 1.3}, .at = {0, 0, 0.5}, .up = {0, 0, 1}, .angle = 40});
    printer.light({3, 4, 5});
    printer.light({-4, 2, 3});
    printer.surface(
        {.colour = {0.6, 0.4, 0.2}, .diffuse = 0.8, .specular = 0.1, .highlight_angle = 20});
    Workshop workshop(printer);
    make_arms(workshop);
    make_back(workshop);
    make_seat(workshop);
    make_legs(workshop);
    Scene scene = std::move(printer).scene(precision);
    scene.hierarchy = std::move(workshop).hierarchy(scene.geometry);
    return scene;
}

}  // namespace rayshoot::procedural
