#include "accel/bsp/bsp.h"

#include "accel/bsp/kd_builder.h"
#include "accel/bsp/midpoint.h"

#include <algorithm>
#include <optional>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

enum class Build { events, binned, midpoint };

template <class Number>
Number chosen_or(const Options& chosen, std::string_view key, int most, Number fallback) {
    const int given = chosen.integer(key, 0, most);
    return given == 0 ? fallback : static_cast<Number>(given);
}

BspSketch sketched(const Geometry& geometry, const Membership& membership, const Options& chosen) {
    const std::uint64_t most = most_references(geometry.size());
    const auto build = chosen.choice<Build>(
        "build",
        {{"sah", Build::events}, {"binned", Build::binned}, {"midpoint", Build::midpoint}});
    const Midpoint midpoint;
    if (build == Build::midpoint)
        return build_midpoint(geometry, membership,
                              {.deepest = chosen_or(chosen, "depth", deepest_bsp, midpoint.deepest),
                               .largest_leaf = chosen_or(chosen, "leaf", 64, midpoint.largest_leaf),
                               .most_references = most});
    KdSettings settings;
    settings.deepest = chosen_or(chosen, "depth", deepest_bsp, auto_depth(geometry.size()));
    settings.smallest_divided = chosen_or(chosen, "leaf", 64, 0u);
    settings.most_references = most;
    return build == Build::events ? build_by_events(geometry, membership, settings)
                                  : build_by_bins(geometry, membership, settings);
}

/// So many rays in flight need so many fleets; one ray is no fleet.
std::size_t fleets_for(int flights) {
    return flights == 1 ? 0 : (static_cast<std::size_t>(flights) + Fleet::lanes - 1) / Fleet::lanes;
}

/// The mean of the longest edges of the primitives' boxes.
float mean_extent(const Geometry& geometry) {
    double sum = 0;
    for (const Box& box : geometry.all_bounds()) {
        const vec3 size = box.size();
        sum += std::max({size.x, size.y, size.z});
    }
    return static_cast<float>(sum / geometry.size());
}

/// Cells hold what is near the part of a primitive inside them, but where "near" means farther than
/// primitives are large they hold all that their bounds reach into.
Membership membership(const BuildInput& input, const Options& chosen) {
    constexpr float most_of_extent = 0.125f;
    const auto asked = chosen.choice<std::optional<Overlap>>(
        "overlap",
        {{"auto", std::nullopt}, {"bounds", Overlap::bounds}, {"exact", Overlap::exact}});
    if (asked) return {input, *asked};
    Membership exact(input, Overlap::exact);
    if (exact.radius() <= most_of_extent * mean_extent(input.geometry)) return exact;
    return {input, Overlap::bounds};
}

}  // namespace

Bsp::Bsp(const BuildInput& input, const Options& chosen)
    : membership_(membership(input, chosen)),
      space_(membership_.space()),
      traversal_(chosen.choice<Traversal>("traversal", {{"stack", Traversal::stack},
                                                        {"short_stack", Traversal::short_stack},
                                                        {"ropes", Traversal::ropes}})),
      packets_(chosen.flag("packets") && traversal_ == Traversal::stack),
      fleets_(traversal_ == Traversal::stack ? fleets_for(chosen.integer("flight", 1, most_flights))
                                             : 0) {
    const BspSketch sketch = sketched(input.geometry, membership_, chosen);
    tree_ = laid_out(input.geometry, sketch);
    if (membership_.overlap() == Overlap::exact) {
        outlines_ = outlined(input.geometry, sketch, tree_);
        *tree_.footprint.bytes += outlines_.bytes();
    }
    if (traversal_ == Traversal::ropes) {
        ropes_ = roped_leaves(tree_, space_);
        *tree_.footprint.bytes += ropes_.size() * sizeof(RopedLeaf);
    }
    const vec3 size = space_.size();
    most_apart_ = std::max({size.x, size.y, size.z}) / 8;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
