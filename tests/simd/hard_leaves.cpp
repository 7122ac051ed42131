#include "tests/simd/hard_leaves.h"

#include <cmath>

namespace rayshoot::cases {
namespace {

vec3 times(const vec3& p, float scale) { return p * scale; }

Triangle scaled(const Triangle& triangle, float scale) {
    return {times(triangle.a, scale), times(triangle.b, scale), times(triangle.c, scale)};
}
Sphere scaled(const Sphere& sphere, float scale) {
    return {times(sphere.centre, scale), sphere.radius * scale};
}

Motion drift(Random& random) {
    Motion motion;
    motion.translation[1] = random.in_cube(1);
    return motion;
}

/// Neighbours of one mesh, copies, and degenerate ones among them.
void add_triangle(GeometryBuilder& builder, Triangle& last, float scale, Random& random) {
    Triangle next = scaled(triangle(random), scale);
    const std::uint32_t choice = random.below(8);
    if (choice == 0) next = last;
    if (choice == 1) next = {last.c, last.b, last.a};
    if (choice == 2 || choice == 3) next.a = last.b, next.b = last.a;  // an edge in common
    if (choice == 4) next.a = last.c;
    if (random.below(64) == 0) next.c = next.b;
    if (random.below(16) == 0) next.a.z = next.b.z = next.c.z;  // in a plane across an axis
    builder.add_triangle(next.a, next.b, next.c);
    last = next;
}

void add_sphere(GeometryBuilder& builder, Sphere& last, float scale, Random& random) {
    Sphere next = scaled(sphere(random), scale);
    const std::uint32_t choice = random.below(16);
    if (choice == 0) next = last;
    if (choice == 1) next.centre = last.centre;
    if (choice == 2) next.radius = 0;
    if (choice == 3) next.radius = static_cast<float>(next.radius * random.magnitude(-30, 0));
    if (choice == 4) next.centre = vec3(0);
    builder.add_sphere(next);
    last = next;
}

void add_other(GeometryBuilder& builder, Random& random) {
    switch (random.below(4)) {
        case 0:
            builder.add_frustum(frustum(random));
            break;
        case 1:
            builder.add_polygon(polygon(random).corners);
            break;
        case 2:
            builder.add_sphere(sphere(random), builder.add_motion(drift(random)));
            break;
        case 3: {
            const Triangle moving = triangle(random);
            builder.add_triangle(moving.a, moving.b, moving.c, builder.add_motion(drift(random)));
        }
    }
}

float some_scale(Random& random) {
    if (random.below(2) == 0) return 1;
    return static_cast<float>(random.magnitude(-70, 70));
}

Spot hard_spot(const Triangle& triangle, Random& random) {
    Spot spot = spot_on(triangle, random);
    const std::uint32_t choice = random.below(6);
    if (choice == 0) spot.point = dvec3(triangle.a);
    if (choice == 1) spot.point = dvec3(triangle.c);
    if (choice == 2) spot.point = 0.5 * (dvec3(triangle.a) + dvec3(triangle.b));
    return spot;
}

/// Every other one at a pole, where the sphere touches its box.
Spot hard_spot(const Sphere& sphere, Random& random) {
    Spot spot = spot_on(sphere, random);
    if (random.below(2) == 0) return spot;
    spot.normal = dvec3(0);
    spot.normal[static_cast<int>(random.below(3))] = random.below(2) ? 1 : -1;
    spot.point = dvec3(sphere.centre) + double(sphere.radius) * spot.normal;
    return spot;
}

Spot hard_spot(const Geometry& geometry, const PrimitiveRef& ref, Random& random) {
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            return hard_spot(geometry.triangle(ref.index), random);
        case PrimitiveKind::sphere:
            return hard_spot(geometry.sphere(ref.index), random);
        case PrimitiveKind::frustum:
            return spot_on(geometry.frustum(ref.index), random);
        case PrimitiveKind::polygon:
            return spot_on(geometry.polygon(ref.index), random);
    }
    return {};
}

/// A zero in a component or two, of either sign.
void flatten(vec3& direction, Random& random) {
    for (std::uint32_t i = 0; i < 1 + random.below(2); ++i)
        direction[static_cast<int>(random.below(3))] = random.below(2) ? 0.0f : -0.0f;
    if (!(taxicab(direction) > 0)) direction.y = 1;
}

/// Two components or three of the same size.
void balance(vec3& direction, Random& random) {
    const int one = static_cast<int>(random.below(3)), other = (one + 1) % 3, third = (one + 2) % 3;
    direction[other] = std::copysign(direction[one], direction[other]);
    if (random.below(2)) direction[third] = direction[one];
}

}  // namespace

HardLeaf::HardLeaf(Mixture mixture, Precision precision, Random& random) {
    GeometryBuilder builder;
    const float scale = mixture == Mixture::anything ? 1 : some_scale(random);
    Triangle last_triangle = scaled(triangle(random), scale);
    Sphere last_sphere = scaled(sphere(random), scale);
    const std::uint32_t size = 1 + random.below(random.below(8) == 0 ? 70 : 10);
    const std::uint32_t kinds = mixture == Mixture::anything ? 3 : 2;
    for (std::uint32_t i = 0; i < size; ++i) {
        std::uint32_t kind = random.below(kinds);
        if (mixture == Mixture::triangles) kind = 0;
        if (mixture == Mixture::spheres) kind = 1;
        if (kind == 0) add_triangle(builder, last_triangle, scale, random);
        if (kind == 1) add_sphere(builder, last_sphere, scale, random);
        if (kind == 2) add_other(builder, random);
    }
    geometry = std::move(builder).build(precision);
    for (std::uint32_t i = 0; i < size; ++i) members.push_back(i);
    for (std::uint32_t i = size; i > 1; --i) std::swap(members[i - 1], members[random.below(i)]);
}

Ray hard_ray(const Geometry& geometry, std::uint32_t primitive, Random& random) {
    const Spot spot = hard_spot(geometry, geometry.ref(primitive), random);
    const double size = std::max(diagonal(geometry.bounds(primitive)), 0x1p-60);
    Ray ray = ray_at(spot, size, random);
    ray.time = static_cast<float>(random.uniform(0, 1));
    const std::uint32_t choice = random.below(16);
    if (choice == 0) {  // far away
        const dvec3 way = random.unit();
        ray.origin = vec3(spot.point - 3e6 * size * way);
        ray.direction = vec3(way);
    }
    if (choice == 1) ray.origin = vec3(spot.point);
    if (choice == 2) {  // in a plane of the primitive's stored bounds, and along it
        const int axis = static_cast<int>(random.below(3));
        const Box& box = geometry.bounds(primitive);
        ray.origin[axis] = random.below(2) ? box.lo[axis] : box.hi[axis];
        ray.direction[axis] = 0;
    }
    if (choice == 3) flatten(ray.direction, random);
    if (choice == 4) balance(ray.direction, random);
    if (choice == 5) ray.direction = times(ray.direction, random.below(2) ? 0x1p-40f : 0x1p40f);
    if (choice == 6) ray.direction = vec3(spot.point) - ray.origin;
    if (!answerable(ray)) ray.direction = vec3(dvec3(random.unit()));
    return ray;
}

std::vector<Ray> hard_packet(const Geometry& geometry, std::uint32_t primitive, std::size_t size,
                             Random& random) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    const Spot middle = hard_spot(geometry, ref, random);
    const double extent = std::max(diagonal(geometry.bounds(primitive)), 0x1p-60);
    dvec3 way = random.unit();
    const std::uint32_t choice = random.below(4);
    if (choice == 0) {  // grazing
        way = way - dot(way, middle.normal) * middle.normal;
        way = way + random.magnitude(-40, -4) * middle.normal;
    }
    if (choice == 1)
        for (const int axis : {1, 2}) way[axis] *= random.magnitude(-40, -4);
    const bool from_there = random.below(8) == 0, apart = random.below(2) == 0;
    const dvec3 origin = middle.point - extent * random.magnitude(2, 20) * way;
    const auto length = static_cast<float>(random.magnitude(-20, 20));
    std::vector<Ray> rays(size);
    for (Ray& ray : rays) {
        const Spot spot = hard_spot(geometry, ref, random);
        ray.origin = vec3(from_there ? spot.point : origin);
        if (apart) ray.origin = ray.origin + random.in_cube(0.01 * extent);
        ray.direction = vec3(from_there ? way + dvec3(random.in_cube(0.01)) : spot.point - origin);
        if (random.below(4) == 0 && !from_there) ray.direction = vec3(spot.point) - ray.origin;
        ray.direction = times(ray.direction, length);
        ray.t_min = random.below(4) == 0 ? 0 : -infinity;
        ray.time = static_cast<float>(random.uniform(0, 1));
    }
    return rays;
}

Ray ending_near(const Ray& ray, float t, Random& random) {
    Ray limited = ray;
    switch (random.below(6)) {
        case 0:
            limited.t_max = t;
            break;
        case 1:
            limited.t_max = float_above(t);
            break;
        case 2:
            limited.t_max = float_below(t);
            break;
        case 3:
            limited.t_min = t;
            break;
        case 4:
            limited.t_min = float_below(t);
            break;
        case 5:
            limited.t_min = 0;
            break;
    }
    return limited;
}

}  // namespace rayshoot::cases
