#include "tests/tracer/spd_scenes.h"

#include "data/generators/generators.h"

namespace rayshoot::tracer_tests {

Scene spd_scene(const std::string& name) {
    // The published teapot has 9264 primitives.
    const std::string options = name == "teapot" ? "size=12" : "";
    return generate("spd/" + name, SceneOptions("spd/" + name, options));
}

}  // namespace rayshoot::tracer_tests
