#pragma once

#include "accel/core/intersector.h"
#include "tests/contract/rays.h"

#include <string>

/// A hard scene with its rays and their true answers.
namespace rayshoot::contract {

struct Settings {
    std::uint64_t seed = 0x5eed;
    std::vector<std::string> scenes = {};  ///< by name; empty: all of them
    /// Primitive tests that the oracle may spend on one scene: how many rays there are follows.
    std::uint64_t tests_per_scene = 100'000;
    /// The run ends after a scene with which there are as many.
    std::uint64_t enough_failures = std::numeric_limits<std::uint64_t>::max();
};

/// Rays of one kind, asked in this order, and what they must be answered.
struct Stream {
    std::string name;
    RayKind kind = RayKind::secondary;
    std::vector<Ray> rays = {};
    std::vector<Source> source = {};              ///< empty, or one per ray
    std::vector<std::string_view> families = {};  ///< per ray: how it was made
    std::vector<Hit> truth = {};

    std::size_t size() const { return rays.size(); }
    RayBatch batch(std::size_t first, std::size_t count) const;
};

struct Case {
    HardScene scene;
    std::uint64_t seed;
    std::vector<Stream> streams;

    const Stream& hard_rays() const { return streams.front(); }
    /// "needles, precision watertight, seed 0x5eed"
    std::string name() const;
};

/// The same rays again and again, up to `size` of them.
Stream repeated(const Stream& stream, std::size_t size);

/// Fills in `truth`.
void answer_truly(const Geometry& geometry, Stream& stream);

Case make_case(const Recipe& recipe, Precision precision, const Settings& settings);

/// Every hard scene at both precisions; scenes without triangles, which precision does not change,
/// at one.
std::vector<Case> make_cases(const Settings& settings);

}  // namespace rayshoot::contract
