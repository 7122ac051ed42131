#include "accel/bsp/kd_cell.h"

namespace rayshoot::inline RAYSHOOT_ISA {

KdCell::Halves KdCell::halves(std::size_t left, std::size_t right) const {
    const double share = double(left) / double(std::max(left + right, std::size_t{1}));
    const std::uint64_t spare = most_references - left - right;
    const auto spare_left = static_cast<std::uint64_t>(share * double(spare));
    return {{box, depth + 1, left + spare_left}, {box, depth + 1, right + (spare - spare_left)}};
}

KdCell::Halves KdCell::halves(const KdSplit& split, std::size_t left, std::size_t right) const {
    Halves both = halves(left, right);
    both.left.box.hi[split.axis] = both.right.box.lo[split.axis] = split.plane;
    return both;
}

KdSplit KdParting::best_split(const KdCell& cell, std::span<const Reference> references) const {
    if (!divisible(cell, references.size())) return {};
    const auto best = references.size() <= tests_at_once ? cutting_split
                      : references.size() <= few         ? counted_split
                                                         : binned_split;
    const KdSplit split = best(settings_.sah, cell.box, references);
    return unless_leaf_is_better(split, references.size());
}

KdSplit KdParting::unless_leaf_is_better(const KdSplit& split, std::size_t references) const {
    const bool pays = split.cost < leaf_cost(settings_.sah, static_cast<std::uint32_t>(references));
    return pays ? split : KdSplit{};
}

void KdParting::part(const Box& box, const KdSplit& split, std::span<const Reference> references,
                     References& left, References& right) const {
    Box left_box = box, right_box = box;
    left_box.hi[split.axis] = right_box.lo[split.axis] = split.plane;
    const auto add = [&](const Reference& reference, const Box& half, References& to) {
        const Box inside = clipped(reference, half);
        if (!inside.empty()) to.emplace_back(inside, reference.number);
    };
    for (const Reference& reference : references) {
        const bool in_left = split.in_left(reference), in_right = split.in_right(reference);
        if (!in_right) {
            left.push_back(reference);
        } else if (!in_left) {
            right.push_back(reference);
        } else {
            add(reference, left_box, left);
            add(reference, right_box, right);
        }
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
