#pragma once

#include "accel/core/box.h"
#include "accel/core/counters.h"
#include "accel/core/ray.h"

#include <tbb/parallel_for.h>

#include <vector>

/// Boxes round many leaves each, for the rays that the cells of a structure were not made for.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A binary tree of boxes. Where cells hold only what is near the part of a primitive inside them,
/// a ray from farther away than they are made for can be reported to hit it where no cell holds it:
/// a ray that misses the primitive by a rounding is clamped into its stored bounds, and comes into
/// these far away if it runs nearly along a face. But always into them: the reported t is in the
/// bounds' interval (rule 2 of ../core/README.md), hence in that of every box round them, exactly,
/// from whatever distance the ray comes. So a tree of such boxes, visited while their intervals
/// begin at or before the hit, whose leaves are tested whole, loses no hit and no tie.
class Outlines {
public:
    /// What has no more references together has one box.
    static constexpr std::uint64_t references_per_box = 256;
    static constexpr std::size_t most_levels = 64;

    struct Outline {
        Box box;
        std::uint32_t place = 0;  ///< what it is round, below 2^31; or a pair
    };

    /// One round both.
    Outline join(const Outline& first, const Outline& second);
    /// Of the whole tree, with what it was joined from.
    void set_root(const Outline& root) { root_ = root; }

    /// visit(place) for what is in a box that the ray meets before `hit`, until it says so.
    template <class Visit, Counter C>
    void each(const SlabRay& ray, float t_min, const Hit& hit, const Visit& visit, C& count) const;
    std::size_t bytes() const { return pairs_.size() * sizeof(Pair); }

private:
    static constexpr std::uint32_t pair_bit = 0x80000000;
    using Pair = std::array<Outline, 2>;

    Outline root_;
    std::vector<Pair> pairs_;
};

inline Outlines::Outline Outlines::join(const Outline& first, const Outline& second) {
    Outline both{first.box, pair_bit | static_cast<std::uint32_t>(pairs_.size())};
    both.box.include(second.box);
    pairs_.push_back({first, second});
    return both;
}

template <class Visit, Counter C>
inline void Outlines::each(const SlabRay& ray, float t_min, const Hit& hit, const Visit& visit,
                           C& count) const {
    std::array<const Outline*, most_levels> later;
    std::size_t size = 0;
    later[size++] = &root_;
    while (size > 0) {
        const Outline& outline = *later[--size];
        count(Event::bounding_volume_test);
        if (clip(ray, outline.box, {t_min, hit.t}).empty()) continue;
        if ((outline.place & pair_bit) == 0) {
            if (visit(outline.place)) return;
            continue;
        }
        for (const Outline& next : pairs_[outline.place & ~pair_bit]) later[size++] = &next;
    }
}

/// Of things in a row that hold references, cells or nodes: neighbours in runs, each with an
/// outline.
class OutlinedRuns {
public:
    OutlinedRuns() = default;
    /// references(i): how many the ith of `size` things holds; bounds(i): a box round the stored
    /// bounds of what they refer to, if it holds any; it is called in parallel.
    template <class References, class Bounds>
    OutlinedRuns(std::size_t size, const References& references, const Bounds& bounds);

    /// visit(i) for all things in runs that the ray meets before `hit`, until it says so.
    template <class Visit, Counter C>
    void each(const SlabRay& ray, float t_min, const Hit& hit, const Visit& visit, C& count) const {
        const auto visit_run = [&](std::uint32_t run) {
            for (std::uint32_t i = first_[run]; i < first_[run + 1]; ++i)
                if (visit(i)) return true;
            return false;
        };
        if (runs() > 0) outlines_.each(ray, t_min, hit, visit_run, count);
    }
    std::size_t runs() const { return first_.empty() ? 0 : first_.size() - 1; }
    std::size_t bytes() const { return outlines_.bytes() + first_.size() * sizeof(first_.front()); }

private:
    Outlines::Outline joined(const std::vector<Box>& boxes, std::size_t first, std::size_t end);

    Outlines outlines_;
    std::vector<std::uint32_t> first_;  ///< of each run, then the end
};

template <class References, class Bounds>
OutlinedRuns::OutlinedRuns(std::size_t size, const References& references, const Bounds& bounds) {
    std::uint64_t in_run = Outlines::references_per_box;  // so that one begins
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint64_t own = references(i);
        if (own == 0) continue;
        if (in_run + own > Outlines::references_per_box) {
            first_.push_back(static_cast<std::uint32_t>(i));
            in_run = 0;
        }
        in_run += own;
    }
    if (first_.empty()) return;
    first_.push_back(static_cast<std::uint32_t>(size));
    std::vector<Box> boxes(runs());
    tbb::parallel_for(std::size_t{0}, runs(), [&](std::size_t run) {
        for (std::size_t i = first_[run]; i < first_[run + 1]; ++i)
            if (references(i) > 0) boxes[run].include(bounds(i));
    });
    outlines_.set_root(joined(boxes, 0, runs()));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
