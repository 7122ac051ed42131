#pragma once

#include "bench/comparison/plan.h"
#include "data/scene.h"

#include <memory>

namespace rayshoot {

/// A structure over a scene that is timed as a whole (built, or rendered with), once it has
/// answered seeded rays as brute force does.
struct CheckedCase {
    std::shared_ptr<const Scene> scene;
    std::string spec;
    ImageFormat format;
    std::unique_ptr<Accel> accel;  ///< null: see error
    std::string error;
};

/// Cases of every scene and structure of the plan whose row `<family>/<scene>/<spec>` it wants;
/// what a structure refuses is left out, unless it was asked for by name.
std::vector<std::shared_ptr<CheckedCase>> checked_cases(const Catalogue& catalogue,
                                                        const ComparisonPlan& plan,
                                                        const std::string& family);

std::string row_name(const std::string& family, const CheckedCase& checked);

}  // namespace rayshoot
