#include "data/generators/generators.h"

#include "data/generators/scenes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayshoot {

namespace {

using namespace procedural;

using Values = std::span<const double>;

constexpr double most_triangles = 4'000'000;  // about half a gigabyte while a scene is made
constexpr double most_seeds = std::numeric_limits<int>::max();

template <int fallback, int largest>
constexpr std::array size_option{
    GeneratorOption{"size", fallback, 1, largest, true, "depth, or objects along a side"}};

constexpr std::array soup_options{
    GeneratorOption{"count", 100'000, 1, most_triangles, true, "triangles"},
    GeneratorOption{"length", 0.01, 1e-6, 2, false, "of an edge; the cube's is 1"},
    GeneratorOption{"seed", 1, 0, most_seeds, true, "another seed is another soup"}};

constexpr std::array needles_options{
    GeneratorOption{"count", 10'000, 1, most_triangles, true, "triangles"},
    GeneratorOption{"aspect", 1000, 1000, 1e6, false, "length over width; the length is 1"},
    GeneratorOption{"seed", 1, 0, most_seeds, true, "another seed is another heap"}};

template <Scene (*scene)(int, Precision)>
Scene sized(Values values, Precision precision) {
    return scene(static_cast<int>(values[0]), precision);
}

template <Scene (*scene)(int, double, int, Precision)>
Scene random(Values values, Precision precision) {
    return scene(static_cast<int>(values[0]), values[1], static_cast<int>(values[2]), precision);
}

constexpr std::array all{
    GeneratorInfo{"spd/balls", size_option<4, 6>,
                  "sphereflake on a floor: objects of very different sizes, mirrors", sized<balls>},
    GeneratorInfo{"spd/gears", size_option<4, 20>,
                  "block of gears: concave polygons of 144 corners, glass", sized<gears>},
    GeneratorInfo{"spd/mount", size_option<6, 10>,
                  "fractal mountain and glass balls: an even height field", sized<mount>},
    GeneratorInfo{"spd/rings", size_option<7, 50>,
                  "pyramid of linked rings: much depth, seen along it", sized<rings>},
    GeneratorInfo{"spd/teapot", size_option<12, 200>,
                  "Newell's teapot on a chequered floor: smooth normals, mirrors", sized<teapot>},
    GeneratorInfo{"spd/tetra", size_option<6, 11>, "Sierpinski tetrahedron: mostly empty space",
                  sized<tetra>},
    GeneratorInfo{"spd/tree", size_option<11, 20>,
                  "binary tree on a huge field: objects crowd in a corner of it", sized<tree>},
    GeneratorInfo{"spd/lattice", size_option<12, 80>,
                  "cubic lattice of balls and rods, seen from inside: even density",
                  sized<lattice>},
    GeneratorInfo{"spd/shells", size_option<5, 14>,
                  "sea shell of overlapping balls: many objects at every point", sized<shells>},
    GeneratorInfo{"spd/jacks", size_option<1, 7>,
                  "jacks within jacks: a recursive scene of cylinders and spheres", sized<jacks>},
    GeneratorInfo{"spd/sombrero", size_option<1, 6>, "height field of a damped wave, in rows",
                  sized<sombrero>},
    GeneratorInfo{"soup", soup_options,
                  "random triangles in the unit cube: no structure to find, any count",
                  random<soup>},
    GeneratorInfo{"needles", needles_options,
                  "random long thin triangles in the unit cube: boxes that fit badly",
                  random<needles>},
    GeneratorInfo{"stadium", size_option<10, 200>,
                  "Newell's teapot in a stadium 4000 times as wide: the grid's worst case",
                  sized<stadium>},
    GeneratorInfo{"chair",
                  {},
                  "96 objects in groups with bounding volumes: a missing ray needs one test",
                  [](Values, Precision precision) { return chair(precision); }},
};

const GeneratorInfo* find(std::string_view name) {
    const auto found = std::ranges::find(all, name, &GeneratorInfo::name);
    return found == all.end() ? nullptr : &*found;
}

const GeneratorInfo& require(std::string_view name) {
    if (const GeneratorInfo* info = find(name)) return *info;
    std::string known;
    for (const GeneratorInfo& info : all)
        known += (known.empty() ? "" : ", ") + std::string(info.name);
    throw std::invalid_argument("there is no generator '" + std::string(name) + "'; there are " +
                                known);
}

double value(const SceneOptions& options, const GeneratorOption& option) {
    const auto [key, fallback, lowest, highest, whole, meaning] = option;
    if (!whole) return options.number(key, fallback, lowest, highest);
    return options.integer(key, static_cast<int>(fallback), static_cast<int>(lowest),
                           static_cast<int>(highest));
}

}  // namespace

std::span<const GeneratorInfo> generators() { return all; }

bool is_generator(std::string_view name) { return find(name) != nullptr; }

Scene generate(std::string_view name, const SceneOptions& options, Precision precision) {
    const GeneratorInfo& info = require(name);
    std::vector<std::string_view> known;
    std::vector<double> values;
    for (const GeneratorOption& option : info.options) known.push_back(option.name);
    options.require_known(known);
    for (const GeneratorOption& option : info.options) values.push_back(value(options, option));
    Scene scene = info.make(values, precision);
    scene.name = name;
    return scene;
}

}  // namespace rayshoot
