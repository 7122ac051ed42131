#include "tests/contract/random.h"
#include "tests/contract/scenes.h"

#include <algorithm>

/// What stands round the geometry of a hard scene: camera, lights of most kinds, hierarchy.
namespace rayshoot::contract {
namespace {

constexpr int image_cells = 24;  // across and down
constexpr int image_border = 2;  // cells

/// The largest extent, or something positive to take its place.
float extent(const Box& bounds) {
    if (bounds.empty()) return 1;
    const vec3 size = bounds.size();
    const float largest = std::max({size.x, size.y, size.z});
    return largest > 0 ? largest : std::max(taxicab(bounds.centre()), 1.0f);
}

/// Looks along -(-1, 2, 2) / 3; every number of the pose is a third of a whole one, so it is
/// orthonormal to rounding without a square root.
View framing_view(const Box& bounds, bool through_a_lens) {
    const float size = extent(bounds);
    const vec3 centre = bounds.empty() ? vec3(0) : bounds.centre();
    View view;
    view.right = vec3(2, -1, 2) / 3.0f;
    view.up = vec3(2, 2, -1) / 3.0f;
    view.forward = vec3(1, -2, -2) / 3.0f;
    view.eye = centre - 2.0f * size * view.forward;
    view.width = view.height = image_cells;
    view.border = image_border;
    view.across = view.right / static_cast<float>(image_cells);
    view.down = -view.up / static_cast<float>(image_cells);
    view.to_corner = view.forward - 0.5f * view.right + 0.5f * view.up;
    if (through_a_lens) {
        view.lens_radius = 0.05f * size;
        view.focus_distance = 2 * size;
        view.motion =
            Motion{.pivot = view.eye, .translation = {vec3(0), 0.25f * size * view.right}};
    }
    return view;
}

Light light(LightKind kind, const vec3& position, const Box& samples) {
    Light made;
    made.kind = kind;
    made.position = position;
    made.samples = samples;
    return made;
}

Box between(const vec3& a, const vec3& b) {
    Box box;
    box.include(a);
    box.include(b);
    return box;
}

/// Above the bounds and inside them.
std::vector<Light> framing_lights(const Box& bounds) {
    const float size = extent(bounds), radius = 0.125f * size;
    const vec3 centre = bounds.empty() ? vec3(0) : bounds.centre();
    const vec3 above = centre + size * vec3(0.3f, 0.4f, 1.5f);
    const vec3 u = 0.5f * size * vec3(1, 0, 0), v = 0.5f * size * vec3(0, 1, 0);

    Light sun = light(LightKind::directional, vec3(0), Box{});
    sun.direction = vec3(1, 2, -2) / 3.0f;
    Light spot = light(LightKind::spot, above, between(above, above));
    spot.cos_inner = 0.9f;
    spot.cos_outer = 0.5f;
    Light rectangle = light(LightKind::rectangle, above, between(above, above + u + v));
    rectangle.edge_u = u;
    rectangle.edge_v = v;
    rectangle.strata_u = rectangle.strata_v = 2;
    Light ball =
        light(LightKind::sphere, above, between(above - vec3(radius), above + vec3(radius)));
    ball.radius = radius;
    return {light(LightKind::point, above, between(above, above)),
            light(LightKind::point, centre, between(centre, centre)),
            sun,
            spot,
            rectangle,
            ball};
}

/// A root with groups of up to five neighbours by number, with boxes and (some) without.
Hierarchy framing_hierarchy(const Geometry& geometry) {
    Hierarchy hierarchy;
    hierarchy.groups.emplace_back();
    if (geometry.size() > 0) hierarchy.groups.front().bound = geometry.bounds();
    for (std::uint32_t first = 0; first < geometry.size(); first += 5) {
        Hierarchy::Group group;
        Box box;
        for (std::uint32_t i = first; i < std::min(first + 5, geometry.size()); ++i) {
            group.primitives.push_back(i);
            box.include(geometry.bounds(i));
        }
        if (first % 3 != 0) group.bound = box;
        hierarchy.groups.front().groups.push_back(
            static_cast<std::uint32_t>(hierarchy.groups.size()));
        hierarchy.groups.push_back(std::move(group));
    }
    return hierarchy;
}

}  // namespace

HardScene hard_scene(const Recipe& recipe, Precision precision) {
    GeometryBuilder builder;
    recipe.fill(builder);
    Geometry geometry = std::move(builder).build(precision);
    // A lens and a moving camera where that can be had without rounding away its cells.
    const float reach = taxicab(geometry.bounds().centre()), size = extent(geometry.bounds());
    const bool lens = size > 1e-3f && size < 1e4f && !(reach > 10 * size);
    View view = framing_view(geometry.bounds(), lens);
    std::vector<Light> lights = framing_lights(geometry.bounds());
    Hierarchy hierarchy = framing_hierarchy(geometry);
    return {std::string(recipe.name), std::move(geometry), view, std::move(lights),
            std::move(hierarchy)};
}

std::vector<Recipe> hard_scenes() {
    std::vector<Recipe> all;
    for (const auto family : {plain_scenes, coincident_scenes, extreme_scenes, flat_scenes,
                              uneven_scenes, skinny_scenes, curved_scenes, moving_scenes}) {
        const std::vector<Recipe> some = family();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace rayshoot::contract
