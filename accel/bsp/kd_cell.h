#pragma once

#include "accel/bsp/clipper.h"
#include "accel/bsp/sah.h"
#include "accel/bsp/sketch.h"

#include <algorithm>
#include <functional>
#include <vector>

/// A cell of a kd-tree on its way to be divided, and how that is done.
namespace rayshoot::inline RAYSHOOT_ISA {

struct KdCell;

/// Makes the sub-tree of a node of a sketch; the node's cell holds the references.
using SubTreeMaker =
    std::function<void(BspSketch&, std::uint32_t node, const KdCell&, std::span<const Reference>)>;

struct KdSettings {
    Sah sah;
    int deepest = 0;                     ///< levels
    std::uint32_t smallest_divided = 0;  ///< cells with no more primitives are leaves
    std::uint64_t most_references = 0;   ///< of all leaves together
    /// For cells of so few references, and for those that no plane across an axis is good for.
    std::size_t most_for_other = 0;
    SubTreeMaker other{};
};

/// 8 + 1.3 log2 N levels.
inline int auto_depth(std::uint32_t primitives) {
    return std::min(deepest_bsp, 8 + 13 * static_cast<int>(std::bit_width(primitives)) / 10);
}
/// 10 N and a few.
inline std::uint64_t most_references(std::uint32_t primitives) {
    return std::uint64_t{10} * primitives + 64;
}

struct KdCell {
    Box box;
    int depth = 0;
    std::uint64_t most_references = 0;  ///< of all its leaves together

    struct Halves;
    /// The references to spare are shared in proportion to those that the halves have.
    Halves halves(std::size_t left, std::size_t right) const;
    Halves halves(const KdSplit& split, std::size_t left, std::size_t right) const;
};
struct KdCell::Halves {
    KdCell left, right;
};

using References = std::vector<Reference>;

/// Decides about cells, and parts their references.
class KdParting {
public:
    /// Up to so many references all planes at their faces are compared; beyond it evenly spaced
    /// ones, or the builder knows better.
    static constexpr std::size_t few = 32;
    static_assert(few <= most_counted);

    KdParting(const Geometry& geometry, const Membership& membership, const KdSettings& settings)
        : clipper_(geometry, membership), settings_(settings) {}

    const Sah& sah() const { return settings_.sah; }
    const SubTreeMaker& other() const { return settings_.other; }
    bool leaves_to_other(std::size_t references) const {
        return settings_.other && references <= settings_.most_for_other;
    }
    /// Whether a cell may be divided at all.
    bool divisible(const KdCell& cell, std::size_t references) const {
        return references > settings_.smallest_divided && cell.depth < settings_.deepest;
    }
    /// An infinite cost where it is best to have a leaf: automatic termination.
    KdSplit best_split(const KdCell& cell, std::span<const Reference> references) const;
    KdSplit unless_leaf_is_better(const KdSplit& split, std::size_t references) const;

    /// Adds the references of either half to those that are there. What lies on both sides is
    /// clipped to each (perfect splits: Havran & Bittner 2002).
    void part(const Box& box, const KdSplit& split, std::span<const Reference> references,
              References& left, References& right) const;
    /// The part of what is referred to in a half of its cell; empty: none.
    Box clipped(const Reference& reference, const Box& half) const {
        return clipper_.clipped(reference.number, half).intersection(reference.bounds().box());
    }

private:
    Clipper clipper_;
    KdSettings settings_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
