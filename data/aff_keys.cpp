#include "data/aff_keys.h"

#include "data/nff_shapes.h"

#include <numbers>
#include <utility>

namespace rayshoot {
namespace {

constexpr std::int64_t shortest_key = 4;  // characters: "0 1 "

template <class Value>
void require_order(const Tokens& tokens, const std::vector<Key<Value>>& keys) {
    if (keys.size() < 2 || keys[keys.size() - 2].time <= keys.back().time) return;
    tokens.refuse("key frames must be in the order of time");
}

std::int64_t key_count(Tokens& tokens, std::int64_t fewest) {
    const std::int64_t most = std::max(fewest, most_to_come(tokens, shortest_key));
    return tokens.integer("number of key frames, which all must follow", fewest, most);
}

KeyShape read_shape(Tokens& tokens) {
    constexpr std::string_view use = "tension, continuity and bias of a key frame";
    const double tension = tokens.number(use), continuity = tokens.number(use);
    return {tension, continuity, tokens.number(use)};
}

/// Keys of `time value tension continuity bias`.
template <class Value, class Read>
std::vector<Key<Value>> read_keys(Tokens& tokens, Read&& read_value) {
    std::vector<Key<Value>> keys;
    for (std::int64_t left = key_count(tokens, fewest_keys); left > 0; --left) {
        Key<Value>& key = keys.emplace_back();
        key.time = tokens.number("time of a key frame");
        key.value = read_value();
        key.shape = read_shape(tokens);
        require_order(tokens, keys);
    }
    return keys;
}

std::vector<Key<dvec3>> read_positions(Tokens& tokens) {
    return read_keys<dvec3>(tokens,
                            [&] { return dvec3(tokens.three("value of a key frame: x y z")); });
}

std::vector<Key<glm::dquat>> read_rotations(Tokens& tokens) {
    return read_keys<glm::dquat>(tokens, [&] {
        return read_rotation(tokens, "rotation of a key frame: axis x y z, degrees");
    });
}

std::vector<Key<bool>> read_visibility(Tokens& tokens) {
    std::vector<Key<bool>> keys;
    for (std::int64_t left = key_count(tokens, 1); left > 0; --left) {
        Key<bool>& key = keys.emplace_back();
        key.time = tokens.number("time of a key frame");
        key.value = tokens.integer("visibility: 0 or 1", 0, 1) == 1;
        require_order(tokens, keys);
    }
    return keys;
}

void read_track(Tokens& tokens, std::string_view kind, KeyFrames& frames) {
    const auto once = [&](bool given) {
        if (given) tokens.refuse("a second " + quoted(kind) + " in these key frames; keep one");
    };
    if (kind == "transl") {
        once(frames.translation.has_value());
        frames.translation.emplace(read_positions(tokens));
    } else if (kind == "scale") {
        once(frames.scale.has_value());
        frames.scale.emplace(read_positions(tokens));
    } else if (kind == "rot") {
        once(frames.rotation.has_value());
        frames.rotation.emplace(read_rotations(tokens));
    } else if (kind == "visibility") {
        once(!frames.visibility.empty());
        frames.visibility = read_visibility(tokens);
    } else {
        tokens.refuse(quoted(kind) +
                      " in key frames, which have transl, rot, scale and visibility, then }");
    }
}

}  // namespace

KeyFrames read_key_frames(Tokens& tokens) {
    KeyFrames frames;
    for (std::string_view kind = tokens.next(); kind != "}"; kind = tokens.next())
        read_track(tokens, kind, frames);
    return frames;
}

glm::dquat read_rotation(Tokens& tokens, std::string_view use) {
    const dvec3 axis(tokens.three(use));
    const double degrees = tokens.number(use);
    const double size = length(axis);
    if (size > 0) return glm::angleAxis(degrees * (std::numbers::pi / 180), axis / size);
    if (degrees != 0) tokens.refuse("the axis of this rotation is zero; give a direction");
    return {1, 0, 0, 0};
}

}  // namespace rayshoot
