#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

/// Where and by what a result was made, without the name of a machine, a person or a path.
namespace rayshoot {

/// The processor's model as it calls itself, "unknown" where it does not.
std::string processor_model();
int processor_count();

/// Lower case, runs of anything but letters and digits as one hyphen: "amd-epyc-7763".
std::string slug(std::string_view text);

/// Today in UTC: "2026-11-22".
std::string today();

/// Release, commit, compiler, flags, instruction set, libraries, processor, date.
nlohmann::ordered_json provenance();

}  // namespace rayshoot
