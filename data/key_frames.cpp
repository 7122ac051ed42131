#include "data/key_frames.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_exponential.hpp>

#include <algorithm>

namespace rayshoot {
namespace {

/// The four keys that decide the curve at a time, and where between the middle two it is.
template <class Value>
struct Span {
    const Key<Value>&before, &from, &to, &after;
    double share;  ///< of the way, 0 to 1
};

template <class Value>
Span<Value> span_at(const std::vector<Key<Value>>& keys, double time) {
    const std::size_t last = keys.size() - 2;
    std::size_t to = 2;
    while (to < last && time >= keys[to].time) ++to;
    const double begin = keys[to - 1].time, end = keys[to].time;
    const double share = time < begin ? 0 : time >= end ? 1 : (time - begin) / (end - begin);
    return {keys[to - 2], keys[to - 1], keys[to], keys[to + 1], share};
}

/// Shares of the step before a key and of the one after it in a tangent at the key.
struct Tangent {
    double before, after;
};

/// `adapted`: the step that the tangent belongs to, over the mean of the two steps at the key.
Tangent leaving(const KeyShape& k, double adapted) {
    const double half = 0.5 * adapted * (1 - k.tension);
    return {half * (1 + k.continuity) * (1 + k.bias), half * (1 - k.continuity) * (1 - k.bias)};
}
Tangent arriving(const KeyShape& k, double adapted) {
    const double half = 0.5 * adapted * (1 - k.tension);
    return {half * (1 - k.continuity) * (1 + k.bias), half * (1 + k.continuity) * (1 - k.bias)};
}

struct Tangents {
    Tangent leaving, arriving;
};

template <class Value>
Tangents tangents(const Span<Value>& s) {
    const double step = s.to.time - s.from.time;
    return {leaving(s.from.shape, 2 * step / (s.to.time - s.before.time)),
            arriving(s.to.shape, 2 * step / (s.after.time - s.from.time))};
}

/// log(from^-1 to): the way from one rotation to another, as seen from the first.
glm::dquat way(const glm::dquat& from, const glm::dquat& to) {
    return glm::log(glm::conjugate(from) * to);
}

}  // namespace

dvec3 PositionTrack::at(double time) const {
    const Span<dvec3> s = span_at(keys_, time);
    if (s.share <= 0) return s.from.value;
    if (s.share >= 1) return s.to.value;
    const auto [out, in] = tangents(s);
    const dvec3 step = s.to.value - s.from.value;
    const dvec3 leave = out.before * (s.from.value - s.before.value) + out.after * step;
    const dvec3 arrive = in.before * step + in.after * (s.after.value - s.to.value);
    const double u = s.share;  // Hermite's cubic
    return s.from.value + u * (leave + u * (3.0 * step - 2.0 * leave - arrive +
                                            u * (leave + arrive - 2.0 * step)));
}

RotationTrack::RotationTrack(std::vector<Key<glm::dquat>> keys) : keys_(std::move(keys)) {
    for (std::size_t i = 1; i < keys_.size(); ++i)
        if (glm::dot(keys_[i - 1].value, keys_[i].value) < 0) keys_[i].value = -keys_[i].value;
}

glm::dquat RotationTrack::at(double time) const {
    const Span<glm::dquat> s = span_at(keys_, time);
    if (s.share <= 0) return s.from.value;
    if (s.share >= 1) return s.to.value;
    const auto [out, in] = tangents(s);
    const glm::dquat &p = s.from.value, &q = s.to.value;
    const glm::dquat step = way(p, q);
    const glm::dquat leave = out.before * way(s.before.value, p) + out.after * step;
    const glm::dquat arrive = in.before * step + in.after * way(q, s.after.value);
    const glm::dquat a = p * glm::exp(0.5 * (leave - step));
    const glm::dquat b = q * glm::exp(0.5 * (step - arrive));
    const double u = s.share;
    return glm::normalize(glm::mix(glm::mix(p, q, u), glm::mix(a, b, u), 2 * u * (1 - u)));
}

bool KeyFrames::visible(double time) const {
    bool seen = true;
    for (const Key<bool>& key : visibility)
        if (time >= key.time) seen = key.value;
    return seen;
}

glm::dmat4 KeyFrames::matrix(double time) const {
    glm::dmat4 m(1);
    if (translation) m = glm::translate(m, translation->at(time));
    if (rotation) m *= glm::mat4_cast(rotation->at(time));
    if (scale) m = glm::scale(m, scale->at(time));
    return m;
}

}  // namespace rayshoot
