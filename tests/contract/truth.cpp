#include "tests/contract/truth.h"

#include <algorithm>
#include <numeric>

namespace rayshoot::contract {
namespace {

Leaves one_primitive_each(const Geometry& geometry) {
    std::vector<std::uint32_t> order(geometry.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<LeafRange> leaves;
    for (std::uint32_t i = 0; i < geometry.size(); ++i) leaves.push_back({i, 1});
    return Leaves(geometry, order, leaves);
}

}  // namespace

bool valid(const Ray& ray) {
    const std::array<float, 6> places{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                      ray.direction.x, ray.direction.y, ray.direction.z};
    const bool all_finite =
        std::all_of(places.begin(), places.end(), [](float x) { return std::abs(x) < infinity; });
    const bool goes_somewhere =
        std::any_of(places.begin() + 3, places.end(), [](float x) { return x < 0 || x > 0; });
    return all_finite && goes_somewhere && ray.t_min < ray.t_max && ray.time == ray.time;
}

Truth::Truth(const Geometry& geometry)
    : size_(geometry.size()), leaves_(one_primitive_each(geometry)) {}

Hit Truth::closest(const Ray& given) const {
    if (!valid(given)) return {};
    Ray ray = given;
    ray.time = std::clamp(ray.time, 0.0f, 1.0f);
    const TestRay test_ray = leaves_.prepared(ray);
    Hit best;
    Silent silent;
    for (std::uint32_t primitive = 0; primitive < size_; ++primitive) {
        Hit hit{ray.t_max, no_primitive, 0, 0};
        leaves_.test<Query::closest>({primitive, 1}, test_ray, hit, silent);
        // Numbers ascend, so at equal t the lower one is there already.
        if (hit.primitive != no_primitive && hit.t < ray.t_max && hit.t < best.t) best = hit;
    }
    return best;
}

}  // namespace rayshoot::contract
