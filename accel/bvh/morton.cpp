#include "accel/bvh/morton.h"

#include "accel/simd/bounds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t keys_per_chunk = 16384;

template <class Work>
void for_chunks(std::size_t size, const Work& work) {
    tbb::parallel_for(std::size_t{0}, (size + keys_per_chunk - 1) / keys_per_chunk,
                      [&](std::size_t i) {
                          work(i, i * keys_per_chunk, std::min(size, (i + 1) * keys_per_chunk));
                      });
}

simd::Bounds bounds_of_centres(std::span<const Box> boxes) {
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::size_t>(0, boxes.size(), keys_per_chunk), simd::Bounds(),
        [&](const auto& part, simd::Bounds sum) {
            for (std::size_t i = part.begin(); i < part.end(); ++i)
                sum.include(simd::Bounds(boxes[i]).centre());
            return sum;
        },
        [](simd::Bounds a, const simd::Bounds& b) {
            a.include(b);
            return a;
        });
}

/// The curve through a cube of 2^10 cells per axis around all centres.
class MortonCurve {
public:
    explicit MortonCurve(const simd::Bounds& centres) : lo_(centres.lo()) {
        using namespace simd;
        const auto largest =
            hn::MaxOfLanes(tag, hn::IfThenElseZero(hn::FirstN(tag, 3), centres.size()));
        const auto scale = hn::Div(hn::Set(tag, cells), largest);
        const auto usable = hn::And(hn::Gt(scale, hn::Zero(tag)), hn::IsFinite(scale));
        scale_ = hn::IfThenElseZero(usable, scale);
    }

    std::uint32_t code(const simd::Bounds& centre) const {
        using namespace simd;
        const auto place = hn::Mul(hn::Sub(centre.lo(), lo_), scale_);
        const auto within = smaller(larger(place, hn::Zero(tag)), hn::Set(tag, cells - 1));
        // Added, its whole part is the float's last bits.
        const auto cell = hn::BitCast(words<4>, hn::Add(within, hn::Set(tag, 0x1p23f)));
        alignas(16) std::array<std::uint32_t, 4> axes;
        hn::Store(spread(hn::And(cell, hn::Set(words<4>, 0x3ff))), words<4>, axes.data());
        return axes[0] << 2 | axes[1] << 1 | axes[2];
    }

private:
    static constexpr float cells = 1 << MortonKey::bits_per_axis;
    static constexpr simd::hn::FixedTag<float, 4> tag{};

    /// Two zeros between each two bits.
    static simd::Words<4> spread(simd::Words<4> bits) {
        using namespace simd;
        const auto apart = [](auto b, auto shifted, std::uint32_t kept) {
            return hn::And(hn::Or(b, shifted), hn::Set(words<4>, kept));
        };
        bits = apart(bits, hn::ShiftLeft<16>(bits), 0x030000ff);
        bits = apart(bits, hn::ShiftLeft<8>(bits), 0x0300f00f);
        bits = apart(bits, hn::ShiftLeft<4>(bits), 0x030c30c3);
        return apart(bits, hn::ShiftLeft<2>(bits), 0x09249249);
    }

    simd::Floats<4> lo_, scale_;
};

/// A radix sort's pass: stable, by one digit of the code.
class DigitPass {
public:
    static constexpr unsigned digit_bits = 10;

    DigitPass(std::span<const MortonKey> from, unsigned shift)
        : from_(from),
          shift_(shift),
          places_((from.size() + keys_per_chunk - 1) / keys_per_chunk) {}

    void move_to(MortonKey* to) {
        for_chunks(from_.size(), [&](std::size_t chunk, std::size_t first, std::size_t last) {
            places_[chunk].fill(0);
            for (std::size_t i = first; i < last; ++i) ++places_[chunk][digit(from_[i])];
        });
        std::uint32_t before = 0;
        for (std::size_t digit = 0; digit < digits; ++digit)
            for (Places& places : places_) before += std::exchange(places[digit], before);
        for_chunks(from_.size(), [&](std::size_t chunk, std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                to[places_[chunk][digit(from_[i])]++] = from_[i];
        });
    }

private:
    static constexpr std::size_t digits = std::size_t{1} << digit_bits;
    using Places = std::array<std::uint32_t, digits>;

    std::size_t digit(MortonKey key) const { return key.code() >> shift_ & (digits - 1); }

    std::span<const MortonKey> from_;
    unsigned shift_;
    std::vector<Places> places_;
};

}  // namespace

RawArray<MortonKey> sorted_morton_keys(std::span<const Box> boxes) {
    RawArray<MortonKey> keys(boxes.size()), moved(boxes.size());
    const MortonCurve curve(bounds_of_centres(boxes));
    for_chunks(boxes.size(), [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            new (&keys[i]) MortonKey(curve.code(simd::Bounds(boxes[i]).centre()),
                                     static_cast<std::uint32_t>(i));
    });
    for (unsigned shift = 0; shift < MortonKey::code_bits; shift += DigitPass::digit_bits) {
        DigitPass(keys, shift).move_to(moved.data());
        std::swap(keys, moved);
    }
    return keys;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
