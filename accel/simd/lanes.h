#pragma once

#include "accel/core/vec.h"

// Level v3 of x86-64 has neither AES nor CLMUL, which Highway would ask of its AVX2 target.
#define HWY_DISABLE_PCLMUL_AES
// We dispatch statically. Without saying so, Highway 1.0 does not compile for a processor with all
// of AVX-512's extensions (HWY_AVX3_DL), which it takes for the baseline but not for attainable.
#define HWY_COMPILE_ONLY_STATIC
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Vectors of floats, by Google Highway with static dispatch: for the one instruction set that the
/// build is compiled for.
namespace rayshoot::inline RAYSHOOT_ISA::simd {

namespace hn = hwy::HWY_NAMESPACE;

template <std::size_t Width>
using Floats = hn::Vec<hn::FixedTag<float, Width>>;
template <std::size_t Width>
using Words = hn::Vec<hn::FixedTag<std::uint32_t, Width>>;

template <std::size_t Width>
inline constexpr hn::FixedTag<float, Width> floats{};
template <std::size_t Width>
inline constexpr hn::FixedTag<std::uint32_t, Width> words{};

/// a > b ? a : b in every lane: b where one of them is NaN, as box.h has it.
template <class V>
inline V larger(V a, V b) {
#if HWY_ARCH_X86
    return hn::Max(a, b);  // vmaxps is just that
#else
    return hn::IfThenElse(hn::Gt(a, b), a, b);
#endif
}
/// a < b ? a : b, likewise.
template <class V>
inline V smaller(V a, V b) {
#if HWY_ARCH_X86
    return hn::Min(a, b);
#else
    return hn::IfThenElse(hn::Lt(a, b), a, b);
#endif
}

/// t < lo ? lo : t > hi ? hi : t
template <class V>
inline V clamp(V t, V lo, V hi) {
    return hn::IfThenElse(hn::Lt(t, lo), lo, hn::IfThenElse(hn::Gt(t, hi), hi, t));
}

/// if_set ? a : b, and no branch, whatever the compiler thinks of it.
inline std::uint64_t select(bool if_set, std::uint64_t a, std::uint64_t b) {
    const std::uint64_t all = 0 - static_cast<std::uint64_t>(if_set);
    return (a & all) | (b & ~all);
}

/// Whether the sign bit is set.
template <class V>
inline auto is_negative(V v) {
    constexpr hn::DFromV<V> tag;
    constexpr hn::RebindToSigned<hn::DFromV<V>> word;
    return hn::RebindMask(tag, hn::Lt(hn::BitCast(word, v), hn::Zero(word)));
}

/// float_below of neighbour.h.
template <class V>
inline V below(V x) {
    constexpr hn::DFromV<V> tag;
    constexpr hn::RebindToUnsigned<hn::DFromV<V>> word;
    const auto all = [&](std::uint32_t bits) { return hn::Set(word, bits); };
    const auto bits = hn::BitCast(word, x);
    const auto sign = hn::ShiftRight<31>(bits);
    auto result = hn::Add(hn::Sub(bits, all(1)), hn::Add(sign, sign));
    result = hn::IfThenElse(hn::Eq(hn::Add(bits, bits), all(0)), all(0x80000001), result);
    return hn::BitCast(tag, hn::IfThenElse(hn::Eq(bits, all(0xff800000)), bits, result));
}

/// As many floats as one register holds, but 16 at most.
inline constexpr std::size_t widest = HWY_TARGET <= HWY_AVX3 ? 16 : 8;

/// One bit a lane, the first lane's lowest; at most 16 lanes.
template <class D, class Mask>
inline std::uint32_t bits(D tag, Mask mask) {
    std::array<std::uint8_t, 8> bytes{};  // as many as Highway may write
    hn::StoreMaskBits(tag, mask, bytes.data());
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The other way round.
template <class D>
inline auto mask_of(D tag, std::uint32_t bits) {
    const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(bits),
                                            static_cast<std::uint8_t>(bits >> 8)};
    return hn::LoadMaskBits(tag, bytes.data());
}

/// Calls visit(number) for each bit that is set, the lowest first.
inline void for_each(std::uint64_t set, auto&& visit) {
    for (; set != 0; set &= set - 1) visit(static_cast<std::size_t>(std::countr_zero(set)));
}

/// For each set of up to eight lanes their numbers in ascending order, a byte each.
inline constexpr auto lane_numbers = [] {
    std::array<std::array<std::uint8_t, 8>, 256> numbers{};
    for (std::size_t set = 0; set < 256; ++set) {
        std::size_t place = 0;
        for (std::uint8_t lane = 0; lane < 8; ++lane)
            if ((set >> lane & 1) != 0) numbers[set][place++] = lane;
    }
    return numbers;
}();

/// Moves the lanes of a set (a bit each) to the front; what follows them is undefined. Where there
/// is no instruction for it, by a table that stays in place: g++ 12 copies Highway's at each use.
template <class V>
inline V compress(V v, std::uint32_t set) {
    constexpr hn::DFromV<V> tag;
#if HWY_TARGET <= HWY_AVX3
    const auto byte = static_cast<std::uint8_t>(set);
    return hn::Compress(v, hn::LoadMaskBits(tag, &byte));
#else
    constexpr std::size_t lanes = hn::MaxLanes(tag);
    static_assert(lanes <= 8);
    const auto numbers = hn::LoadU(hn::FixedTag<std::uint8_t, lanes>(), lane_numbers[set].data());
    const auto indices = hn::PromoteTo(hn::FixedTag<std::uint32_t, lanes>(), numbers);
    return hn::TableLookupLanes(v, hn::IndicesFromVec(tag, indices));
#endif
}

/// A vector in space: a component, many lanes.
template <class V>
struct Vectors {
    V x, y, z;

    friend Vectors operator-(const Vectors& a, const Vectors& b) {
        return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
    }
};

/// Doubles take twice the room: a vector of floats becomes one vector of doubles or, where a
/// register does not hold as many, two halves.
template <class V>
inline constexpr std::size_t double_parts =
    hn::MaxLanes(hn::DFromV<V>()) * sizeof(double) > HWY_MAX_BYTES ? 2 : 1;

/// Part 0 has the first lanes.
template <std::size_t Part, class V>
inline auto as_doubles(V v) {
    using D = hn::DFromV<V>;
    if constexpr (double_parts<V> == 1) {
        return hn::PromoteTo(hn::Rebind<double, D>(), v);
    } else {
        const hn::Half<D> half;
        const hn::Rebind<double, hn::Half<D>> doubles;
        if constexpr (Part == 0) return hn::PromoteTo(doubles, hn::LowerHalf(half, v));
        else return hn::PromoteTo(doubles, hn::UpperHalf(half, v));
    }
}

/// The same point or direction in every lane.
template <std::size_t Width>
inline Vectors<Floats<Width>> everywhere(const vec3& p) {
    return {hn::Set(floats<Width>, p.x), hn::Set(floats<Width>, p.y), hn::Set(floats<Width>, p.z)};
}

/// The product-sums of vec.h, lane by lane: each the same fma, so the same bits.
template <class V>
inline V dot(const Vectors<V>& a, const Vectors<V>& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
template <class V>
inline Vectors<V> cross(const Vectors<V>& a, const Vectors<V>& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
template <class V>
inline Vectors<V> scaled(V scale, const Vectors<V>& a) {
    return {hn::Mul(scale, a.x), hn::Mul(scale, a.y), hn::Mul(scale, a.z)};
}
template <class V>
inline V taxicab(const Vectors<V>& a) {
    return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::simd
