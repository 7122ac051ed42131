#pragma once

#include "accel/core/catalogue.h"
#include "bench/gate/difference.h"

/// What a structure passes before it is timed on a stream.
namespace rayshoot {

inline constexpr std::string_view oracle_spec = "brute_force";
inline constexpr std::string_view reference_spec = "bvh";  ///< the scalar two-wide tree

struct GateSettings {
    std::size_t sample_rays = 4096;               ///< that brute force answers
    std::uint64_t affordable_tests = 1000000000;  ///< primitives x rays up to which it answers all
    std::uint64_t most_tests = 4000000000;        ///< from here on the sample is smaller, ...
    std::size_t least_rays = 256;                 ///< ... but not smaller than this
    std::uint64_t seed = 1;
    TraceSettings trace;
};

struct Verdict {
    bool passed = false;
    std::string reason;         ///< "" when passed
    std::size_t compared = 0;   ///< rays
    std::size_t ambiguous = 0;  ///< set aside; tolerance structures only
    std::string digest;         ///< of all answers; "" when only a sample was compared
};

/// The gate of one stream over one scene. Brute force answers a seeded sample, the scalar bvh must
/// agree with it there, and everyone else with the bvh everywhere.
class Gate {
public:
    /// Keeps references. Throws std::invalid_argument when the catalogue lacks one of the two.
    Gate(const Catalogue& catalogue, const BuildInput& input, const RayStream& stream,
         const GateSettings& settings);

    Verdict judge(const Accel& accel, Agreement agreement) const;
    /// The same for a structure too slow for the whole stream: on the rays in `chosen` only.
    Verdict judge_sample(const Accel& accel, Agreement agreement,
                         const std::vector<std::size_t>& chosen) const;

    std::size_t oracle_rays() const { return sample_.size(); }
    const StreamAnswers& answers() const { return reference_; }

private:
    void compare_with_oracle(const Accel& oracle);
    Verdict verdict(const RayStream& stream, const StreamTracer& tracer, Agreement agreement,
                    const std::vector<std::size_t>& chosen) const;

    const BuildInput& input_;
    const RayStream& stream_;
    GateSettings settings_;
    std::vector<std::size_t> sample_;
    std::unique_ptr<Accel> reference_accel_;
    StreamAnswers reference_;
    std::string broken_;  ///< why nothing can pass: the reference itself is wrong, say
};

}  // namespace rayshoot
