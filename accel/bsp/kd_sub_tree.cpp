#include "accel/bsp/kd_sub_tree.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {

/// The references of the cell: those of a stack from `first` on.
void KdSubTree::subdivide(std::uint32_t node, const KdCell& cell, std::size_t stack,
                          std::size_t first) {
    sketch_.depth = std::max(sketch_.depth, cell.depth);
    const std::size_t size = stacks_[stack].size() - first;
    const auto references = [&] { return std::span(stacks_[stack]).subspan(first, size); };
    if (parting_.leaves_to_other(size)) return parting_.other()(sketch_, node, cell, references());
    const KdSplit split = parting_.best_split(cell, references());
    if (split.cost == infinity) {
        return parting_.other() ? parting_.other()(sketch_, node, cell, references())
                                : make_leaf(node, references());
    }
    const std::array<std::size_t, 2> ends{stacks_[0].size(), stacks_[1].size()};
    // So that they stay where they are while they are parted.
    for (References& each : stacks_)
        if (each.capacity() < each.size() + size) each.reserve(2 * (each.size() + size));
    parting_.part(cell.box, split, references(), stacks_[0], stacks_[1]);
    const std::size_t left = stacks_[0].size() - ends[0], right = stacks_[1].size() - ends[1];
    if (left + right > cell.most_references) {
        sketch_.bounded = true;
        make_leaf(node, references());
    } else {
        const KdCell::Halves both = cell.halves(split, left, right);
        const std::uint32_t children = sketch_.divide(node, split.axis, split.plane);
        subdivide(children, both.left, 0, ends[0]);
        subdivide(children + 1, both.right, 1, ends[1]);
    }
    for (std::size_t i = 0; i < 2; ++i)
        stacks_[i].erase(stacks_[i].begin() + static_cast<std::ptrdiff_t>(ends[i]),
                         stacks_[i].end());
}

void KdSubTree::make_leaf(std::uint32_t node, std::span<const Reference> references) {
    numbers_.clear();
    for (const Reference& reference : references) numbers_.push_back(reference.number);
    std::sort(numbers_.begin(), numbers_.end());
    sketch_.make_leaf(node, numbers_);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
