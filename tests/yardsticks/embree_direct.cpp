#include "accel/embree/direct.h"
#include "accel/embree/embree.h"
#include "tests/yardsticks/scenes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>

/// Embree called directly on rays in its own layout, and through the adaptor: the adaptor has to
/// reach `least_ratio` on every path. Exit status 1 where it does not, or where answers differ.
namespace rayshoot::yardsticks {
namespace {

/// All hits of rays, through the catalogue's entry.
std::vector<Hit> hits_of(const Accel& accel, const std::vector<Ray>& rays) {
    const std::unique_ptr<Session> session = accel.open(Mode::timing);
    std::vector<Hit> hits(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += max_batch) {
        const std::size_t count = std::min(max_batch, rays.size() - first);
        session->closest({RayKind::camera, 1, std::span(rays).subspan(first, count), {}},
                         std::span(hits).subspan(first, count));
    }
    return hits;
}

const char* name(RayKind kind) {
    return kind == RayKind::camera ? "camera" : kind == RayKind::shadow ? "shadow" : "diffuse";
}

/// Whether every row is right and fast enough: the upper end of its interval decides, because a
/// machine that others use as well can only blur the ratio.
bool print(const std::vector<DirectRow>& rows, double least_ratio) {
    bool good = true;
    for (const DirectRow& row : rows) {
        const bool right = row.differences == 0 && row.ratio.high >= least_ratio;
        good = good && right;
        std::printf("%-8s %-9s %-7s %8.2f %8.2f   %.3f [%.3f, %.3f] %6zu %6zu%s\n", name(row.kind),
                    row.query == Query::closest ? "closest" : "occluded",
                    std::string(row.path).c_str(), row.direct_mrays, row.adaptor_mrays,
                    row.ratio.median, row.ratio.low, row.ratio.high, row.blocks, row.differences,
                    right ? "" : "  <-- too low, or different answers");
    }
    return good;
}

struct Settings {
    int splits = 94;  ///< 8 * 94^2 triangles: about the bunny's number
    int size = 256;   ///< pixels along each side of the view
    int repetitions = 3;
    double least_ratio = 0.9;
};

bool run(const Settings& settings) {
    const Geometry geometry = bumpy_ball(settings.splits);
    const auto accel = build({embree_entry()}, "embree", {geometry});
    const std::vector<Ray> camera = camera_rays(settings.size);
    const std::vector<Hit> hits = hits_of(*accel, camera);
    std::printf("%s; %u triangles, one thread\n", embree_description().c_str(), geometry.size());
    std::printf(
        "rays     question  path    direct   adaptor  ratio [95 %% interval]  blocks  diff.\n"
        "                            Mrays/s  Mrays/s\n");
    const auto measure = [&](RayKind kind, const std::vector<Ray>& rays) {
        return print(measure_direct(geometry, kind, rays, settings.repetitions),
                     settings.least_ratio);
    };
    bool good = measure(RayKind::camera, camera);
    good &= measure(RayKind::shadow, shadow_rays(geometry, camera, hits));
    good &= measure(RayKind::secondary, diffuse_rays(geometry, camera, hits));
    return good;
}

}  // namespace
}  // namespace rayshoot::yardsticks

int main(int argc, char** argv) {
    rayshoot::yardsticks::Settings settings;
    CLI::App app("Embree called directly against the same calls through the adaptor");
    app.add_option("--splits", settings.splits, "the mesh has 8 * splits^2 triangles")
        ->check(CLI::Range(1, 2000))
        ->capture_default_str();
    app.add_option("--size", settings.size, "pixels along each side of the view; a multiple of 8")
        ->check(CLI::Range(32, 4096))
        ->capture_default_str();
    app.add_option("--repetitions", settings.repetitions, "passes over the rays")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--least-ratio", settings.least_ratio, "fail below this")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        return rayshoot::yardsticks::run(settings) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "embree_direct: " << error.what() << '\n';
        return 2;
    }
}
