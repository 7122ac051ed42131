#pragma once

#include "bench/comparison/plan.h"

#include <optional>

namespace CLI {
class App;
}

/// The options that say what to measure, shared by `rayshoot bench` and the bench_* programs.
namespace rayshoot {

inline constexpr int default_repetitions = 11;
inline constexpr const char* default_size = "384x384";

struct PlanOptions {
    std::vector<std::string> scenes, structures, rows, ray_files;
    std::vector<std::string> kinds{"camera", "shadow", "diffuse", "random"};
    std::optional<std::string> size;  ///< WxH; none: default_size, or the protocol's
    int spp = 1, threads = 1;
    std::optional<int> repetitions;  ///< none: default_repetitions, or the protocol's
    std::string protocol;            ///< empty: none
    std::size_t batch = default_batch;
    std::uint64_t seed = 1;
    bool warm = false, standard = false, adaptor_cost = false;
};

/// The options are written to `options`, which must live until the command line is parsed.
void add_plan_options(CLI::App& command, PlanOptions& options);

/// Throws std::invalid_argument for what makes no plan.
ComparisonPlan make_plan(const Catalogue& catalogue, const PlanOptions& options);

}  // namespace rayshoot
