#include "data/movement.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

constexpr double largest_turn = 180;  // degrees in one exposure

double between(double from, double to, double time) { return from + (to - from) * time; }

Motion::Quaternion quaternion(const dvec3& axis, double degrees) {
    const double half = degrees * (std::numbers::pi / 360);
    const dvec3 v = std::sin(half) * axis;
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
            static_cast<float>(std::cos(half))};
}

}  // namespace

void Movement::read_shift(Tokens& tokens) {
    constexpr std::string_view use = "shift at the beginning and the end: x y z x y z";
    const vec3 from = tokens.three(use), to = tokens.three(use);
    shift_ = Shift{dvec3(from), dvec3(to)};
}

void Movement::read_turn(Tokens& tokens) {
    constexpr std::string_view use =
        "point, axis, degrees at the beginning and the end: x y z ax ay az from to";
    Turn turn{};
    turn.pivot = tokens.three(use);
    turn.axis = dvec3(tokens.three(use));
    if (!(length(turn.axis) > 0)) tokens.refuse("the axis of a turn is zero; give a direction");
    turn.axis = normalised(turn.axis);
    turn.from = tokens.number(use);
    turn.to = tokens.number(use);
    turn_ = turn;
}

Motion Movement::over(const Exposure& exposure) const {
    Motion motion;
    if (shift_) {
        const auto at = [this](double time) {
            return vec3(shift_->from + (shift_->to - shift_->from) * time);
        };
        motion.translation = {at(exposure.open), at(exposure.close)};
    }
    if (!turn_) return motion;
    const double open = between(turn_->from, turn_->to, exposure.open);
    const double close = between(turn_->from, turn_->to, exposure.close);
    if (!(std::abs(close - open) <= largest_turn))
        throw std::invalid_argument("a turn by " + std::to_string(std::abs(close - open)) +
                                    " degrees while the shutter is open; 180 are the most: load "
                                    "more frames (frames=N) or a shorter shutter");
    motion.pivot = turn_->pivot;
    motion.rotation = {quaternion(turn_->axis, open), quaternion(turn_->axis, close)};
    return motion;
}

}  // namespace rayshoot
