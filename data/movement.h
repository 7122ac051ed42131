#pragma once

#include "accel/core/primitive/motion.h"
#include "data/animation.h"
#include "data/tokens.h"

#include <optional>

/// How NFF's extension says that things move: a shift and a turn, each steady over the animation's
/// time 0 to 1.
namespace rayshoot {

class Movement {
public:
    /// `move x y z x y z`: where what is at the coordinates' origin is at time 0 and at time 1.
    void read_shift(Tokens& tokens);
    /// `turn x y z ax ay az from to`: about the axis a through a point, right-handed, in degrees
    /// at time 0 and at time 1. The turn comes before the shift.
    void read_turn(Tokens& tokens);

    bool moves() const { return shift_ || turn_; }

    /// The motion while the shutter is open. Throws std::invalid_argument for a turn of more than
    /// 180 degrees in that time: Motion's interpolation no longer resembles it.
    Motion over(const Exposure& exposure) const;

private:
    struct Shift {
        dvec3 from, to;
    };
    struct Turn {
        vec3 pivot;
        dvec3 axis;       ///< unit
        double from, to;  ///< degrees
    };
    std::optional<Shift> shift_;
    std::optional<Turn> turn_;
};

}  // namespace rayshoot
