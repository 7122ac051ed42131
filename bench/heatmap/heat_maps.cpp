#include "bench/heatmap/heat_maps.h"

#include "bench/output/machine.h"
#include "bench/output/table.h"
#include "bench/output/whole_file.h"
#include "tracer/colour_bar.h"

#include <algorithm>

namespace rayshoot {
namespace {

/// "bvh-leaf-2"; made different where specs differ in punctuation alone.
std::vector<std::string> file_names(const std::vector<std::string>& structures) {
    std::vector<std::string> names;
    for (const std::string& spec : structures) {
        std::string name = slug(spec);
        for (int other = 2; std::ranges::count(names, name) > 0; ++other)
            name = slug(spec) + "-" + std::to_string(other);
        names.push_back(name);
    }
    return names;
}

/// Not a Table: there may be millions of lines.
std::string values_csv(const HeatMaps& heat) {
    constexpr int digits = 9;  // of a float, and all of a count below a thousand million
    Table heading{{"x", "y"}, {}};
    heading.headings.insert(heading.headings.end(), heat.structures.begin(), heat.structures.end());
    std::string text = to_csv(heading);
    for (int y = 0; y < heat.maps.front().height(); ++y) {
        for (int x = 0; x < heat.maps.front().width(); ++x) {
            text += std::to_string(x) + "," + std::to_string(y);
            for (const ScalarImage& map : heat.maps)
                text += "," + short_number(map.at(x, y), digits);
            text += "\r\n";
        }
    }
    return text;
}

}  // namespace

HeatMaps measure_heat(const Scene& scene, const std::vector<std::unique_ptr<Accel>>& accels,
                      const RenderSettings& settings, Cost cost, int rounds) {
    if (cost != Cost::time) rounds = 1;
    HeatMaps heat{cost, {}, {}, {}};
    for (const auto& accel : accels) heat.structures.push_back(accel->spec());
    Progress progress(accels.size() * static_cast<std::size_t>(rounds));
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < accels.size(); ++i) {
            progress.advance(accels[i]->spec());
            ScalarImage map = cost_map(scene, *accels[i], settings, cost);
            if (round == 0) heat.maps.push_back(std::move(map));
            else keep_least(heat.maps[i], map);
        }
    }
    heat.scale = common_scale(heat.maps, Spacing::linear);
    return heat;
}

std::vector<HeatMapFiles> write_heat_maps(const HeatMaps& heat,
                                          const std::filesystem::path& folder) {
    std::vector<HeatMapFiles> files;
    for (const std::string& name : file_names(heat.structures)) {
        const ScalarImage& map = heat.maps[files.size()];
        files.push_back({name + ".png", name + ".exr"});
        write_image(coloured(map, heat.scale), folder / files.back().image);
        write_image(grey(map), folder / files.back().values);
    }
    write_image(colour_bar(heat.scale, heat.maps.front().width()), folder / "colour_bar.png");
    write_whole_file(folder / "values.csv", values_csv(heat));
    return files;
}

}  // namespace rayshoot
