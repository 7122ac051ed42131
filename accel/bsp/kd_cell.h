#pragma once

#include "accel/bsp/clipper.h"
#include "accel/bsp/sah.h"

#include <vector>

/// A cell of a kd-tree on its way to be divided, and how that is done.
namespace rayshoot::inline RAYSHOOT_ISA {

struct KdSettings {
    Sah sah;
    int deepest = 0;                     ///< levels
    std::uint32_t smallest_divided = 0;  ///< cells with no more primitives are leaves
    std::uint64_t most_references = 0;   ///< of all leaves together
};

struct KdCell {
    Box box;
    int depth = 0;
    std::uint64_t most_references = 0;  ///< of all its leaves together

    struct Halves;
    /// The references to spare are shared in proportion to those that the halves have.
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
