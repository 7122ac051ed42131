#pragma once

#include "bench/timing/stream_tracer.h"

#include <optional>
#include <string>

/// Where and how two sets of answers to one stream differ.
namespace rayshoot {

struct Difference {
    std::size_t ray = 0;   ///< its number in the stream
    std::string expected;  ///< the reference's answer
    std::string found;
    std::string asked;  ///< the ray, in hexadecimal floats: enough to ask again
};

struct Differences {
    std::size_t count = 0;
    std::optional<Difference> first;
};

/// Bit for bit: t, primitive, u and v, or occluded. Answer i of `found` is about ray i of `stream`,
/// answer chosen[i] of `expected`; an empty `chosen` is all of them in order.
Differences exact_differences(const RayStream& stream, const StreamAnswers& expected,
                              const StreamAnswers& found,
                              const std::vector<std::size_t>& chosen = {});

std::string describe(const Ray& ray);
Difference difference_at(const RayStream& stream, std::size_t ray, const std::string& expected,
                         const std::string& found);
std::string describe_answer(const StreamAnswers& answers, std::size_t ray);
/// One line for an error message.
std::string describe(const Difference& difference);

}  // namespace rayshoot
