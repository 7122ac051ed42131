#pragma once

#include "accel/core/box.h"
#include "accel/simd/lanes.h"

/// A box in one register, for those who unite many.
namespace rayshoot::inline RAYSHOOT_ISA::simd {

/// lo.x, lo.y, lo.z, any, -hi.x, -hi.y, -hi.z, any: with `hi` negated one minimum unites two boxes.
class Bounds {
public:
    using V = Floats<8>;

    Bounds() : planes_(hn::Set(tag, infinity)) {}
    explicit Bounds(V planes) : planes_(planes) {}
    explicit Bounds(const Box& box) {
        const float* planes = &box.lo.x;
        const auto lo = hn::LoadU(half_tag, planes);                       // and hi.x
        const auto hi = hn::Shuffle0321(hn::LoadU(half_tag, planes + 2));  // and lo.z
        planes_ = hn::Combine(tag, hn::Neg(hi), lo);
    }

    /// What a register leaves in memory, aligned as it is.
    struct alignas(32) Stored {
        std::array<float, 8> planes;
    };
    explicit Bounds(const Stored& stored) : planes_(hn::Load(tag, stored.planes.data())) {}
    void store(Stored& to) const { hn::Store(planes_, tag, to.planes.data()); }

    V planes() const { return planes_; }
    Box box() const {
        std::array<float, 8> p;
        hn::StoreU(planes_, tag, p.data());
        return {{p[0], p[1], p[2]}, {-p[4], -p[5], -p[6]}};
    }

    /// NaN counts for nothing, as in Box.
    void include(const Bounds& other) { planes_ = smaller(other.planes_, planes_); }

    /// This box or an empty one, without a branch.
    Bounds or_nothing_if(bool condition) const {
        return or_nothing({-infinity, infinity}, condition);
    }
    Bounds or_nothing_unless(bool condition) const {
        return or_nothing({infinity, -infinity}, condition);
    }

    /// Twice the box's centre, as a box.
    Bounds centre() const {
        return Bounds(hn::Sub(planes_, hn::ConcatLowerUpper(tag, planes_, planes_)));
    }
    Floats<4> lo() const { return hn::LowerHalf(half_tag, planes_); }
    Floats<4> size() const { return hn::Neg(hn::Add(lo(), hn::UpperHalf(half_tag, planes_))); }
    /// Of an empty box: infinite.
    float half_area() const {
        alignas(16) std::array<float, 4> s;
        hn::Store(size(), half_tag, s.data());
        return std::fma(s[0], s[1], std::fma(s[1], s[2], s[2] * s[0]));
    }

private:
    Bounds or_nothing(const std::array<float, 2>& least, bool which) const {
        return Bounds(larger(hn::Set(tag, least[which]), planes_));
    }

    static constexpr hn::FixedTag<float, 8> tag{};
    static constexpr hn::FixedTag<float, 4> half_tag{};
    V planes_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::simd
