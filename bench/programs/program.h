#pragma once

#include "bench/commands/plan_options.h"

#include <functional>

/// What the three Google Benchmark programs share.
namespace rayshoot {

/// Registers every case of a plan with Google Benchmark. Whatever the cases refer to is kept alive
/// by what is captured in them.
using RegisterCases = std::function<void(const Catalogue&, const ComparisonPlan&)>;

/// Our options (those of `rayshoot bench`) are read first, Google Benchmark gets the others.
/// `family`: what a --row must begin with. Returns the exit code: 0, 1 for a row that failed its
/// check, 2 for bad usage or input.
int run_program(const std::string& family, const RegisterCases& register_cases, int argc,
                char** argv);

}  // namespace rayshoot
