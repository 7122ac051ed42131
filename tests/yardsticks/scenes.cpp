#include "tests/yardsticks/scenes.h"

#include <array>
#include <cmath>

namespace rayshoot::yardsticks {
namespace {

Motion drift(Random& random) {
    Motion motion;
    motion.translation[1] = random.in_cube(0.5f);
    // A quarter turn about z, about.
    motion.rotation[1] = {0, 0, 0.6f, 0.8f};
    motion.pivot = random.in_cube(0.5f);
    return motion;
}

void add_triangle(GeometryBuilder& builder, Random& random, std::uint32_t motion = no_motion) {
    const vec3 a = random.in_cube(1);
    builder.add_triangle(a, a + random.in_cube(0.3f), a + random.in_cube(0.3f), motion);
}

void add_sphere(GeometryBuilder& builder, Random& random, std::uint32_t motion = no_motion) {
    const vec3 centre = random.in_cube(1);
    builder.add_sphere({centre, random.between(0.02f, 0.2f)}, motion);
}

void add_frustum(GeometryBuilder& builder, Random& random, std::uint32_t motion = no_motion) {
    Frustum frustum;
    frustum.base = random.in_cube(1);
    frustum.apex = frustum.base + random.in_cube(0.5f);
    frustum.base_radius = random.between(0.05f, 0.2f);
    frustum.apex_radius = random.between(0, 0.1f);
    builder.add_frustum(frustum, motion);
}

/// An arrowhead: concave, planar.
void add_polygon(GeometryBuilder& builder, Random& random, std::uint32_t motion = no_motion) {
    const vec3 o = random.in_cube(1), x = random.in_cube(0.4f), y = random.in_cube(0.4f);
    const std::array<vec3, 4> corners{o, o + x, o + 0.25f * x + 0.25f * y, o + y};
    builder.add_polygon(corners, {}, motion);
}

/// A bump that is continuous, in [0, 1], and made of + - * alone.
float bump(const vec3& p) {
    float product = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float wave = 8 * p[axis] - std::floor(8 * p[axis]);
        product *= 4 * wave * (1 - wave);
    }
    return product;
}

constexpr vec3 eye{0.4f, 0.7f, 3};
constexpr vec3 light{3, 4, 2};

/// The hit's point and the unit normal on the side that the ray came from.
struct Surface {
    vec3 point, normal;
};

Surface surface(const Geometry& geometry, const Ray& ray, const Hit& hit) {
    vec3 normal = geometry.normal(ray, hit).geometric;
    if (dot(normal, ray.direction) > 0) normal = -normal;
    // A step off the surface that is large against the rounding of a scene of size 1.
    return {along(ray.origin, hit.t, ray.direction) + 1e-5f * normal, normal};
}

}  // namespace

vec3 Random::on_sphere() {
    for (;;) {
        const vec3 p = in_cube(1);
        const float square = dot(p, p);
        if (square > 0.01f && square <= 1) return p / std::sqrt(square);
    }
}

Geometry triangle_soup(int count, Precision precision) {
    GeometryBuilder builder;
    Random random(1);
    for (int i = 0; i < count; ++i) add_triangle(builder, random);
    return std::move(builder).build(precision);
}

Geometry sphere_cloud(int count) {
    GeometryBuilder builder;
    Random random(2);
    for (int i = 0; i < count; ++i) add_sphere(builder, random);
    return std::move(builder).build();
}

Geometry frustum_pile(int count) {
    GeometryBuilder builder;
    Random random(3);
    for (int i = 0; i < count; ++i) add_frustum(builder, random);
    return std::move(builder).build();
}

Geometry polygon_pile(int count) {
    GeometryBuilder builder;
    Random random(4);
    for (int i = 0; i < count; ++i) add_polygon(builder, random);
    return std::move(builder).build();
}

Geometry everything(int count) {
    GeometryBuilder builder;
    Random random(5);
    const std::uint32_t motion = builder.add_motion(drift(random));
    for (int i = 0; i < count; ++i) {
        const std::uint32_t moving = i % 3 == 0 ? motion : no_motion;
        switch (i % 4) {
            case 0:
                add_triangle(builder, random, moving);
                break;
            case 1:
                add_sphere(builder, random, moving);
                break;
            case 2:
                add_frustum(builder, random, moving);
                break;
            default:
                add_polygon(builder, random, moving);
        }
    }
    return std::move(builder).build();
}

Geometry bumpy_ball(int splits, Precision precision) {
    GeometryBuilder builder;
    const float n = static_cast<float>(splits);
    for (int octant = 0; octant < 8; ++octant) {
        const vec3 sign{octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
        std::vector<std::uint32_t> before, row;
        for (int i = 0; i <= splits; ++i) {
            row.clear();
            for (int j = 0; j <= splits - i; ++j) {
                const float x = static_cast<float>(i) / n, y = static_cast<float>(j) / n;
                const vec3 p = sign * normalised(vec3{x, y, 1 - x - y});
                row.push_back(builder.add_vertex((1 + 0.1f * bump(p)) * p));
            }
            for (std::size_t j = 0; j < row.size() && i > 0; ++j) {
                builder.add_triangle({before[j], before[j + 1], row[j]});
                if (j + 1 < row.size()) builder.add_triangle({before[j + 1], row[j + 1], row[j]});
            }
            before = row;
        }
    }
    return std::move(builder).build(precision);
}

std::vector<Ray> inward_rays(std::size_t count, float distance, float half) {
    Random random(6);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = distance * random.on_sphere();
        ray.direction = random.in_cube(half) - ray.origin;
        ray.time = random.next();
    }
    return rays;
}

std::vector<Ray> camera_rays(int size) {
    constexpr int tile = 8;
    const vec3 forward = normalised(-eye), right = normalised(cross(forward, vec3{0, 1, 0}));
    const vec3 up = cross(right, forward);
    const auto place = [&](int pixel) {
        return (static_cast<float>(pixel) + 0.5f) / static_cast<float>(size) - 0.5f;
    };
    std::vector<Ray> rays;
    for (int top = 0; top < size; top += tile)
        for (int left = 0; left < size; left += tile)
            for (int y = top; y < top + tile; ++y)
                for (int x = left; x < left + tile; ++x) {
                    Ray ray;
                    ray.origin = eye;
                    ray.direction = forward + 0.9f * (place(x) * right - place(y) * up);
                    rays.push_back(ray);
                }
    return rays;
}

std::vector<Ray> diffuse_rays(const Geometry& geometry, const std::vector<Ray>& rays,
                              const std::vector<Hit>& hits) {
    Random random(7);
    std::vector<Ray> diffuse;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].primitive == no_primitive) continue;
        const Surface at = surface(geometry, rays[i], hits[i]);
        Ray ray;
        ray.origin = at.point;
        ray.direction = at.normal + 0.999f * random.on_sphere();
        diffuse.push_back(ray);
    }
    return diffuse;
}

std::vector<Ray> shadow_rays(const Geometry& geometry, const std::vector<Ray>& rays,
                             const std::vector<Hit>& hits) {
    std::vector<Ray> shadow;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].primitive == no_primitive) continue;
        Ray ray;
        ray.origin = surface(geometry, rays[i], hits[i]).point;
        ray.direction = light - ray.origin;
        ray.t_max = 0.9999f;
        shadow.push_back(ray);
    }
    return shadow;
}

}  // namespace rayshoot::yardsticks
