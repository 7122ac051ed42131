#include "accel/core/catalogue.h"
#include "data/scenes.h"
#include "tracer/recorder.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

/// million_rays mesh.obj: how many of a million random rays hit the mesh, and how fast.
int main(int argc, char** argv) try {
    using namespace rayshoot;
    const Scene scene = load_scene(argc > 1 ? argv[1] : "");
    const auto accel = build(built_in_catalogue(), "bvh8", {scene.geometry});
    const std::vector<Ray> rays = random_chords(scene.geometry.bounds(), 1000000);
    std::vector<Hit> hits(rays.size());

    const auto start = std::chrono::steady_clock::now();
    const auto session = accel->open(Mode::timing);
    for (std::size_t first = 0; first < rays.size(); first += default_batch) {
        const std::size_t count = std::min(default_batch, rays.size() - first);
        session->closest({.rays = std::span(rays).subspan(first, count)},
                         std::span(hits).subspan(first, count));
    }
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;

    const auto found = [](const Hit& hit) { return hit.primitive != no_primitive; };
    std::printf("%td hits, %.3f Mrays/s\n", std::ranges::count_if(hits, found),
                static_cast<double>(rays.size()) / time.count());
} catch (const std::exception& wrong) {
    std::fprintf(stderr, "million_rays: %s\n", wrong.what());
    return 1;
}
