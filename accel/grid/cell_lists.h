#pragma once

#include "accel/core/raw_array.h"
#include "accel/grid/lattice.h"
#include "accel/space/membership.h"

/// Which primitives each cell of a lattice holds, as compressed rows.
namespace rayshoot::inline RAYSHOOT_ISA {

struct CellLists {
    RawArray<std::uint32_t> first;    ///< by cell, and one more: where in `members` its own begin
    RawArray<std::uint32_t> members;  ///< primitive numbers, those of a cell ascending

    std::span<const std::uint32_t> of(std::size_t cell) const {
        return {members.begin() + first[cell], members.begin() + first[cell + 1]};
    }
};

/// How many references cells would hold if boxes alone decided.
std::uint64_t box_references(const Membership& membership, const Lattice& lattice,
                             std::span<const std::uint32_t> primitives);

/// Counts, sums up, fills: in parallel, and the same lists for any number of threads. There are at
/// most 2^32 - 1 box_references().
CellLists list_members(const Membership& membership, const Lattice& lattice,
                       std::span<const std::uint32_t> primitives);

}  // namespace rayshoot::inline RAYSHOOT_ISA
