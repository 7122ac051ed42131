#pragma once

#include "accel/core/catalogue.h"

#include <iosfwd>

/// The command line, as a library: a structure of one's own has a `main` of four lines.
namespace rayshoot {

inline constexpr int exit_ok = 0;
inline constexpr int exit_differences = 1;  ///< answers differ, or a row failed the gate
inline constexpr int exit_bad_input = 2;    ///< usage, input or output

/// One call of the program, subcommand and all; the README lists them. Never throws.
int run(const Catalogue& catalogue, int argc, const char* const* argv);

/// The same, onto given streams.
int run(const Catalogue& catalogue, int argc, const char* const* argv, std::ostream& out,
        std::ostream& err);

}  // namespace rayshoot
