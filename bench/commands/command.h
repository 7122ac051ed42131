#pragma once

#include "accel/core/catalogue.h"

#include <functional>
#include <iosfwd>

namespace CLI {
class App;
}

/// One function per subcommand: it declares the options, and sets what is to be done when chosen.
namespace rayshoot {

struct Invocation {
    const Catalogue& catalogue;
    std::ostream& out;
    std::ostream& err;
    std::function<int()> chosen;  ///< returns the exit code; throws for bad input
};

void add_list(CLI::App& app, Invocation& invocation);
void add_count(CLI::App& app, Invocation& invocation);
void add_check(CLI::App& app, Invocation& invocation);
void add_render(CLI::App& app, Invocation& invocation);
void add_heatmap(CLI::App& app, Invocation& invocation);
void add_difference(CLI::App& app, Invocation& invocation);
void add_rays(CLI::App& app, Invocation& invocation);
void add_bench(CLI::App& app, Invocation& invocation);
void add_limits(CLI::App& app, Invocation& invocation);
void add_scaling(CLI::App& app, Invocation& invocation);
void add_report(CLI::App& app, Invocation& invocation);
void add_replay(CLI::App& app, Invocation& invocation);
void add_seed_question(CLI::App& app, Invocation& invocation);
void add_textbook(CLI::App& app, Invocation& invocation);
void add_gallery(CLI::App& app, Invocation& invocation);

}  // namespace rayshoot
