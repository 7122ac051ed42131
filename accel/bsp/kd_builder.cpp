#include "accel/bsp/kd_builder.h"

#include "accel/bsp/kd_sub_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Where work is divided among threads depends on these numbers alone, so the tree is the same for
/// any number of them.
constexpr std::size_t references_per_part = 4096, references_per_chunk = 8192;

class Builder {
public:
    Builder(const Geometry& geometry, const Membership& membership, const KdSettings& settings)
        : parting_(geometry, membership, settings) {}

    std::unique_ptr<BspSketch> build(const KdCell& cell, References references) const;

private:
    /// KdParting::part() of all references, a chunk after the other.
    void part(const Box& box, const KdSplit& split, const References& references, References& left,
              References& right) const;

    KdParting parting_;
};

void Builder::part(const Box& box, const KdSplit& split, const References& references,
                   References& left, References& right) const {
    struct Chunk {
        References left, right;
    };
    const std::size_t size = references.size();
    std::vector<Chunk> chunks((size + references_per_chunk - 1) / references_per_chunk);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
        const std::size_t first = i * references_per_chunk;
        const auto some =
            std::span(references).subspan(first, std::min(references_per_chunk, size - first));
        parting_.part(box, split, some, chunks[i].left, chunks[i].right);
    });
    std::size_t in_left = 0, in_right = 0;
    for (const Chunk& chunk : chunks) {
        in_left += chunk.left.size();
        in_right += chunk.right.size();
    }
    left.reserve(in_left);
    right.reserve(in_right);
    for (const Chunk& chunk : chunks) {
        left.insert(left.end(), chunk.left.begin(), chunk.left.end());
        right.insert(right.end(), chunk.right.begin(), chunk.right.end());
    }
}

std::unique_ptr<BspSketch> Builder::build(const KdCell& cell, References references) const {
    auto sketch = std::make_unique<BspSketch>();
    const auto alone = [&] {
        KdSubTree(parting_, *sketch).build(0, cell, references);
        return std::move(sketch);
    };
    if (references.size() <= references_per_part) return alone();
    const KdSplit split = parting_.best_split(cell, references);
    if (split.cost == infinity) return alone();
    References left, right;
    part(cell.box, split, references, left, right);
    if (left.size() + right.size() > cell.most_references) return alone();
    references = References();
    const KdCell::Halves both = cell.halves(split, left.size(), right.size());
    const std::uint32_t children = sketch->divide(0, split.axis, split.plane);
    std::unique_ptr<BspSketch> left_part, right_part;
    tbb::parallel_invoke([&] { left_part = build(both.left, std::move(left)); },
                         [&] { right_part = build(both.right, std::move(right)); });
    sketch->make_part(children, std::move(left_part));
    sketch->make_part(children + 1, std::move(right_part));
    return sketch;
}

}  // namespace

References all_references(const Geometry& geometry, const Membership& membership) {
    References all;
    all.reserve(geometry.size());
    for (std::uint32_t i = 0; i < geometry.size(); ++i) all.emplace_back(membership.box(i), i);
    return all;
}

BspSketch build_by_bins(const Geometry& geometry, const Membership& membership,
                        const KdSettings& settings) {
    return std::move(*Builder(geometry, membership, settings)
                          .build({membership.space(), 0, settings.most_references},
                                 all_references(geometry, membership)));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
