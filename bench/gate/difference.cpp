#include "bench/gate/difference.h"

#include <bit>
#include <cstdio>

namespace rayshoot {
namespace {

std::string hexadecimal(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%a", static_cast<double>(value));
    return text;
}

std::string hexadecimal(const vec3& value) {
    return "(" + hexadecimal(value.x) + ", " + hexadecimal(value.y) + ", " + hexadecimal(value.z) +
           ")";
}

/// Bits, so that NaN equals itself and -0 is not 0.
bool same_bits(const Hit& a, const Hit& b) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return bits(a.t) == bits(b.t) && a.primitive == b.primitive && bits(a.u) == bits(b.u) &&
           bits(a.v) == bits(b.v);
}

bool same_answer(const StreamAnswers& expected, std::size_t i, const StreamAnswers& found,
                 std::size_t j) {
    return found.hits.empty() ? expected.occluded[i] == found.occluded[j]
                              : same_bits(expected.hits[i], found.hits[j]);
}

}  // namespace

Differences exact_differences(const RayStream& stream, const StreamAnswers& expected,
                              const StreamAnswers& found, const std::vector<std::size_t>& chosen) {
    Differences differences;
    for (std::size_t j = 0; j < stream.size(); ++j) {
        const std::size_t i = chosen.empty() ? j : chosen[j];
        if (same_answer(expected, i, found, j)) continue;
        if (differences.count++ == 0) {
            differences.first =
                difference_at(stream, j, describe_answer(expected, i), describe_answer(found, j));
            differences.first->ray = i;
        }
    }
    return differences;
}

std::string describe(const Ray& ray) {
    return "origin " + hexadecimal(ray.origin) + " direction " + hexadecimal(ray.direction) +
           " t_min " + hexadecimal(ray.t_min) + " t_max " + hexadecimal(ray.t_max) + " time " +
           hexadecimal(ray.time);
}

std::string describe_answer(const StreamAnswers& answers, std::size_t ray) {
    if (answers.hits.empty()) return answers.occluded[ray] != 0 ? "occluded" : "not occluded";
    const Hit& hit = answers.hits[ray];
    if (hit.primitive == no_primitive) return "no hit";
    return "primitive " + std::to_string(hit.primitive) + " at t " + hexadecimal(hit.t) + " u " +
           hexadecimal(hit.u) + " v " + hexadecimal(hit.v);
}

Difference difference_at(const RayStream& stream, std::size_t ray, const std::string& expected,
                         const std::string& found) {
    return {ray, expected, found, describe(stream.rays[ray])};
}

std::string describe(const Difference& difference) {
    return "ray " + std::to_string(difference.ray) + " (" + difference.asked + "): expected " +
           difference.expected + ", found " + difference.found;
}

}  // namespace rayshoot
