#pragma once

#include "accel/grid/lattice.h"
#include "accel/simd/packet.h"

#include <optional>

/// The cells that a packet of rays sweeps over, slice by slice of a lattice across the axis that
/// the rays follow most (Wald, Ize, Kensler, Knoll & Parker 2006).
namespace rayshoot::inline RAYSHOOT_ISA {

class Sweep {
public:
    /// Farther from a lattice, in cells, places are not computed well enough.
    static constexpr int most_cells_away = 1 << 12;
    /// By which, in cells, the swept range is grown: for what is rounded, here and in the slab
    /// form. With no coordinate beyond 2^13 cells that is below 20 * 2^-24 * 2^13 of a cell.
    static constexpr float margin = 0x1p-5f;

    /// None where the rays are not made for it. `beam`: round all rays of the packet.
    static std::optional<Sweep> of(const Packet& packet, const Beam& beam, const Lattice& lattice);

    bool inside() const { return slice_ != end_; }
    void advance(int slices) {
        const int left = (end_ - slice_) * forward_;
        slice_ += forward_ * std::min(slices, left);
    }
    /// The cells of the slice that rays may touch; none where that is empty.
    std::optional<CellRange> cells() const;
    /// Slices after this one that rays surely see nothing of but what is so many cells from those
    /// of this one.
    int slices_within(int clearance) const {
        return static_cast<int>(static_cast<float>(clearance) / steepest_);
    }
    int axis() const { return axis_; }
    /// The plane by which the rays leave the slice.
    float end_plane(const Lattice& lattice) const {
        return lattice.plane(axis_, slice_ + (forward_ > 0));
    }

private:
    /// A bound of all rays along one axis, in cells: linear in the plane that they meet.
    struct Bound {
        float at_0, per_plane;
        float at(int plane) const { return std::fma(static_cast<float>(plane), per_plane, at_0); }
    };
    struct Across {
        int axis, last;
        Bound lo, hi;
    };
    static Bound bound(const std::array<int, 2>& planes, float first, float second) {
        const float slope = (second - first) / static_cast<float>(planes[1] - planes[0]);
        return {std::fma(-slope, static_cast<float>(planes[0]), first), slope};
    }

    int axis_, forward_, slice_, end_;
    float steepest_ = 1;
    std::array<Across, 2> across_;
};

inline std::optional<Sweep> Sweep::of(const Packet& packet, const Beam& beam,
                                      const Lattice& lattice) {
    constexpr float steepest = 4;     // cells across for a cell along
    constexpr float most_across = 8;  // cells: of wider packets too few rays share a cell
    Sweep sweep;
    float least = infinity;  // the longest component of the direction has the least inverse
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = std::abs(beam.inverse_lo[axis]);
        if (!(std::max(inverse, std::abs(beam.inverse_hi[axis])) < infinity)) return std::nullopt;
        if (inverse * lattice.step()[axis] >= least) continue;
        least = inverse * lattice.step()[axis];
        sweep.axis_ = axis;
    }
    const auto over = static_cast<std::size_t>(sweep.axis_);
    const bool descending = beam.near[over] > beam.far[over];
    sweep.forward_ = descending ? -1 : 1;
    const int slices = lattice.cells()[over];
    sweep.slice_ = descending ? lattice.last(sweep.axis_, beam.origin_hi[sweep.axis_])
                              : lattice.first(sweep.axis_, beam.origin_lo[sweep.axis_]);
    sweep.end_ = descending ? -1 : slices;
    // Between the outer planes the least of straight lines lies above the line between its ends.
    const std::array<int, 2> planes{descending ? 0 : sweep.slice_,
                                    descending ? sweep.slice_ + 1 : slices};
    for (std::size_t i = 0; i < 2; ++i) {
        Across& across = sweep.across_[i];
        across.axis = (sweep.axis_ + 1 + static_cast<int>(i)) % 3;
        const auto along = static_cast<std::size_t>(across.axis);
        across.last = lattice.cells()[along] - 1;
        std::array<float, 2> lo, hi;
        for (std::size_t end = 0; end < 2; ++end) {
            const auto [from, to] =
                packet.span(along, over, lattice.plane(sweep.axis_, planes[end]));
            const auto place = [&](float x) {
                return (x - lattice.lo()[across.axis]) * lattice.per_step()[across.axis];
            };
            lo[end] = place(from);
            hi[end] = place(to);
            const float farthest = std::max(std::abs(lo[end]), std::abs(hi[end]));
            if (!(farthest < 2 * most_cells_away) || hi[end] - lo[end] > most_across)
                return std::nullopt;
        }
        across.lo = bound(planes, lo[0], lo[1]);
        across.hi = bound(planes, hi[0], hi[1]);
        sweep.steepest_ = std::max(
            {sweep.steepest_, std::abs(across.lo.per_plane), std::abs(across.hi.per_plane)});
    }
    if (sweep.steepest_ > steepest) return std::nullopt;
    return sweep;
}

inline std::optional<CellRange> Sweep::cells() const {
    CellRange range;
    const auto set = [&](int axis, int first, int last) {
        range.first[static_cast<std::size_t>(axis)] = first;
        range.last[static_cast<std::size_t>(axis)] = last;
    };
    set(axis_, slice_, slice_);
    for (const Across& across : across_) {
        const float lo = std::min(across.lo.at(slice_), across.lo.at(slice_ + 1)) - margin;
        const float hi = std::max(across.hi.at(slice_), across.hi.at(slice_ + 1)) + margin;
        if (hi < 0 || lo >= static_cast<float>(across.last + 1)) return std::nullopt;
        const int first = lo > 0 ? static_cast<int>(lo) : 0;
        set(across.axis, first, std::min(static_cast<int>(hi), across.last));
    }
    return range;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
