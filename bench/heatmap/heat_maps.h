#pragma once

#include "bench/heatmap/cost_map.h"
#include "bench/output/progress.h"
#include "tracer/colour_map.h"

#include <filesystem>

/// The cost maps of several structures, in one scale of colours.
namespace rayshoot {

struct HeatMaps {
    Cost cost = Cost::tests;
    std::vector<std::string> structures;  ///< canonical specs
    std::vector<ScalarImage> maps;        ///< one for each, all of one size
    ColourScale scale;                    ///< of all of them
};

/// Time: the least of `rounds` rounds in which every structure goes once, so that a machine that
/// drifts drifts for all. Counts need one round, since they repeat exactly.
HeatMaps measure_heat(const Scene& scene, const std::vector<std::unique_ptr<Accel>>& accels,
                      const RenderSettings& settings, Cost cost, int rounds);

/// Where a map's files went: names in the folder.
struct HeatMapFiles {
    std::string image, values;  ///< .png in colours, .exr of numbers
};

/// Writes the files of every structure, colour_bar.png, and values.csv with columns x, y and one
/// for each structure. The folder exists.
std::vector<HeatMapFiles> write_heat_maps(const HeatMaps& heat,
                                          const std::filesystem::path& folder);

}  // namespace rayshoot
