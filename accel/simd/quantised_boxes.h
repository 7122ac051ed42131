#pragma once

#include "accel/core/box.h"
#include "accel/simd/lanes.h"

/// Eight boxes in a cache line.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Boxes rounded outward to a grid of their own: 255 cells along each axis, which are a power of
/// two wide (Ylitie, Karras & Laine 2017). Unlike there, planes are decoded, not the ray brought
/// into the grid: each is a float that is not inside the box it stands for, so that the slab form,
/// whose rounding is monotone, misses nothing that it meets in the box itself.
class QuantisedBoxes {
public:
    static constexpr std::size_t width = 8;

    QuantisedBoxes() = default;  ///< none
    explicit QuantisedBoxes(const Boxes<width>& boxes);

    // As of Boxes (wide_box.h), but NaN, which bounds nothing, across an axis along which one of
    // the boxes is unbounded.
    friend simd::Floats<width> row(const QuantisedBoxes& boxes, std::size_t axis,
                                   std::size_t first) {
        using namespace simd;
        constexpr auto tag = floats<width>;
        constexpr auto word = words<width>;
        constexpr hn::FixedTag<std::int32_t, width> integer;
        const auto exponents =
            hn::ShiftLeftSame(hn::Set(word, boxes.shape_), 23 - 8 * static_cast<int>(axis));
        const auto cell = hn::BitCast(tag, hn::And(exponents, hn::Set(word, exponent_bits)));
        const auto places =
            hn::LoadU(hn::FixedTag<std::uint8_t, width>(), boxes.planes_[0].data() + first);
        return hn::MulAdd(hn::ConvertTo(tag, hn::PromoteTo(integer, places)), cell,
                          hn::Set(tag, boxes.origin_[axis]));
    }
    friend float plane(const QuantisedBoxes& boxes, std::size_t axis, std::size_t place,
                       std::size_t box) {
        return boxes.plane_at(axis, boxes.planes_[place][box]);
    }
    /// NaN, before which nothing is met, where there is no box: seen from afar, an empty one whose
    /// planes are finite could be met by rounding.
    friend simd::Floats<width> limit(const QuantisedBoxes& boxes, float t_max) {
        using namespace simd;
        constexpr auto tag = floats<width>;
        const auto live = static_cast<std::uint8_t>(boxes.shape_ >> 24);
        return hn::IfThenElse(hn::LoadMaskBits(tag, &live), hn::Set(tag, t_max),
                              hn::Set(tag, std::numeric_limits<float>::quiet_NaN()));
    }

private:
    static constexpr std::uint32_t exponent_bits = 0x7f800000;  ///< of a float
    static constexpr std::uint32_t unbounded = 0xff;            ///< exponent of infinity

    std::uint32_t exponent(std::size_t axis) const { return shape_ >> 8 * axis & 0xff; }
    float cell(std::size_t axis) const { return std::bit_cast<float>(exponent(axis) << 23); }
    /// Rounded once. The cell may be 0, and then every place is the origin.
    float plane_at(std::size_t axis, std::uint32_t place) const {
        return std::fma(static_cast<float>(place), cell(axis), origin_[axis]);
    }
    void fit(std::size_t axis, float lo, float hi);
    double cells_to(std::size_t axis, float plane) const;
    std::uint8_t place_below(std::size_t axis, float plane) const;
    std::uint8_t place_above(std::size_t axis, float plane) const;

    std::array<float, 3> origin_{};
    /// Bytes, from the lowest: the exponents of the cells as a float has them; a bit for each box.
    std::uint32_t shape_ = 0;
    std::array<std::array<std::uint8_t, width>, 6> planes_{};  ///< in cells from the origin
};
static_assert(sizeof(QuantisedBoxes) == 64);

}  // namespace rayshoot::inline RAYSHOOT_ISA
