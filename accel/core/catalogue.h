#pragma once

#include "accel/core/build_input.h"
#include "accel/core/intersector.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The structures that can be asked for by name, and the specs that ask for them.
namespace rayshoot::inline RAYSHOOT_ISA {

/// exact: answers are bit-identical to brute force. tolerance: a yardstick with its own arithmetic.
enum class Agreement : std::uint8_t { exact, tolerance };

struct OptionInfo {
    std::string_view name;
    std::string_view values;    ///< as help shows them: "on|off", "1 to 64"
    std::string_view fallback;  ///< the default, as it would be written
    std::string_view meaning;
};

class Options;

/// One line of the catalogue.
struct StructureEntry {
    std::string_view name;
    Agreement agreement;
    bool complete;
    bool remembers;
    std::span<const OptionInfo> options;
    std::span<const std::string_view> configurations;  ///< specs that the contract kit runs
    std::string_view summary;                          ///< one line for `rayshoot list`
    std::unique_ptr<Accel> (*build)(const BuildInput&, const Options&, std::string spec);
    /// Why this structure cannot take a scene ("" when it can): the CGAL yardstick and spheres,
    /// say.
    std::string (*refuses)(const Geometry&);
};

using Catalogue = std::vector<StructureEntry>;

/// The structures of catalogue.def that this build holds, in that order.
Catalogue built_in_catalogue();

/// Builds `spec` ("grid:density=3,mailbox=on", "vista_buffer+light_buffer+bvh") over the input.
/// Throws std::invalid_argument, saying what exists, for an unknown name or option, a value out of
/// range, a complete member that is not last or a partial one that is.
std::unique_ptr<Accel> build(const Catalogue& catalogue, std::string_view spec,
                             const BuildInput& input);

/// The entries a spec names, in order; throws like build, without building.
std::vector<const StructureEntry*> entries(const Catalogue& catalogue, std::string_view spec);

/// tolerance if any member is.
Agreement agreement(const Catalogue& catalogue, std::string_view spec);

/// Why `spec` cannot take this geometry; "" when it can.
std::string refusal(const Catalogue& catalogue, std::string_view spec, const Geometry& geometry);

}  // namespace rayshoot::inline RAYSHOOT_ISA
