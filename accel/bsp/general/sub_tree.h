#pragma once

#include "accel/bsp/general/split.h"
#include "accel/bsp/sketch.h"

/// A part of a tree whose planes may lie anyhow.
namespace rayshoot::inline RAYSHOOT_ISA {

class GeneralSubTree {
public:
    /// Cells of more references are not divided.
    static constexpr std::size_t most_references = 4096;

    GeneralSubTree(const Geometry& geometry, const Membership& membership,
                   const KdSettings& settings)
        : geometry_(geometry),
          parting_(geometry, membership, settings),
          maker_(geometry, membership) {}

    /// The sub-tree of a node of the sketch, a SubTreeMaker.
    void build(BspSketch& sketch, std::uint32_t node, const KdCell& cell,
               std::span<const Reference> references) const;

private:
    using Parts = std::vector<Part>;
    struct Halves {
        Parts left, right;
    };

    void subdivide(BspSketch& sketch, std::uint32_t node, const KdCell& cell,
                   const Polyhedron& hull, const Parts& parts) const;
    Halves halves(const ObliquePlane& plane, const Parts& parts) const;
    Halves halves(const KdSplit& split, const Box& cell, const Parts& parts) const;
    std::optional<Part> within(const Part& part, const Box& half) const;

    const Geometry& geometry_;
    KdParting parting_;
    PartMaker maker_;
};

/// The whole tree: cells of at most `few` references, and those that no plane across an axis is
/// good for, may be divided by any plane. Where the membership knows no error radius none are.
BspSketch build_general(const Geometry& geometry, const Membership& membership,
                        const KdSettings& settings, std::size_t few);

}  // namespace rayshoot::inline RAYSHOOT_ISA
