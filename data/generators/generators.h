#pragma once

#include "data/scene.h"
#include "data/scene_options.h"

#include <span>
#include <string_view>

/// Procedural scenes, by the names that users write: `spd/balls`, `spd/tetra:size=8`,
/// `soup:count=100000`. The same name and options give the same scene on every machine.
namespace rayshoot {

struct GeneratorOption {
    std::string_view name;
    double fallback;         ///< the value when the option is not given
    double lowest, highest;  ///< accepted, both included; `highest` bounds the memory asked for
    bool whole;              ///< whole numbers only
    std::string_view meaning;
};

struct GeneratorInfo {
    std::string_view name;
    std::span<const GeneratorOption> options;
    std::string_view summary;  ///< one line: what it is and what it is for
    /// Makes the scene from one value per option, in their order.
    Scene (*make)(std::span<const double> values, Precision precision);
};

/// Every generator, in the order of the catalogue.
std::span<const GeneratorInfo> generators();

/// True when generate() knows the name.
bool is_generator(std::string_view name);

/// Makes the scene; its `name` is the generator's (the caller knows the whole scene string).
/// Throws std::invalid_argument, saying what exists, for an unknown name, an unknown option or a
/// value out of its range. The option `precision` is the caller's: hand it over as the parameter.
Scene generate(std::string_view name, const SceneOptions& options,
               Precision precision = Precision::standard);

}  // namespace rayshoot
