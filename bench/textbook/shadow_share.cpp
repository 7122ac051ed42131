#include "bench/textbook/figures.h"

#include "bench/timing/watched_accel.h"
#include "data/scenes.h"
#include "tracer/render.h"

#include <cmath>
#include <numbers>

/// "Shadow rays a major cost factor (90%??). Usually have lots of lights."
namespace rayshoot::textbook {
namespace {

constexpr const char* lit_scene = "spd/balls";
constexpr const char* lit_structure = "bvh8";
constexpr std::array light_counts{1, 2, 4, 8, 16, 32, 64};
constexpr double published_share = 0.9;

/// Points of the upper half of the sphere that the scene's first light is on, evenly spread along a
/// spiral of golden angles; together as bright as NFF's lights are (1 / sqrt(n) each).
std::vector<Light> lights_above(const Scene& scene, int count) {
    const dvec3 middle(scene.geometry.bounds().centre());
    const dvec3 up = normalised(dvec3(scene.camera.up));
    const dvec3 to_first = dvec3(scene.lights.front().position) - middle;
    const dvec3 side = normalised(cross(up, to_first)), front = cross(side, up);
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const double height = (i + 0.5) / count, across = std::sqrt(1 - height * height);
        const dvec3 direction = up * height + front * (across * std::cos(i * golden_angle)) +
                                side * (across * std::sin(i * golden_angle));
        Light light;
        light.position = vec3(middle + direction * length(to_first));
        light.samples.include(light.position);
        light.intensity = vec3(static_cast<float>(1 / std::sqrt(count)));
        lights.push_back(light);
    }
    return lights;
}

/// How much of an image is due to shadow rays.
struct Share {
    double of_rays = 0, of_tests = 0, of_tracing = 0, of_image = 0;
};

double share(double shadow, double all) { return all > 0 ? shadow / all : 0; }

void count_shares(const Scene& scene, const Accel& accel, RenderSettings settings, Share& result) {
    settings.mode = Mode::counting;
    const RenderResult counted = render(scene, accel, settings);
    double rays = 0, tests = 0, shadow_rays = 0, shadow_tests = 0;
    for (int i = 0; i < ray_kinds; ++i) {
        const auto kind = static_cast<RayKind>(i);
        const Counters& counters = *counted.session->counters(kind);
        const auto of_kind = static_cast<double>(counters[Event::object_test] +
                                                 counters[Event::bounding_volume_test]);
        tests += of_kind;
        rays += static_cast<double>(counters[Event::ray]);
        if (kind != RayKind::shadow) continue;
        shadow_tests = of_kind;
        shadow_rays = static_cast<double>(counters[Event::ray]);
    }
    result.of_rays = share(shadow_rays, rays);
    result.of_tests = share(shadow_tests, tests);
}

void time_shares(const Scene& scene, const Accel& accel, RenderSettings settings, Share& result) {
    double tracing = 0, shadows = 0;
    const WatchedAccel watched(accel, [&](const AnsweredBatch& answered) {
        tracing += answered.seconds;
        if (answered.question == Query::occluded) shadows += answered.seconds;
    });
    settings.threads = 1;
    const double image = render(scene, watched, settings).seconds;
    result.of_tracing = share(shadows, tracing);
    result.of_image = share(shadows, image);
}

std::vector<Share> measure_shares(const Studio& studio) {
    Scene scene = load_scene(lit_scene);
    const std::vector<Light> own = scene.lights;
    RenderSettings settings;
    // A quarter of the rays of other pictures: 64 lights make 100 rays of each camera ray.
    const int edge = std::max(studio.edge / 2, smallest_edge);
    settings.format = {edge, edge, 1, Raster::centres, 0};
    std::vector<Share> shares;
    for (const int count : light_counts) {
        scene.lights = own;
        scene.lights = lights_above(scene, count);
        const auto accel =
            build(studio.catalogue, lit_structure, build_input(scene, settings.format));
        Share& share = shares.emplace_back();
        count_shares(scene, *accel, settings, share);
        time_shares(scene, *accel, settings, share);
    }
    return shares;
}

std::string percent_cell(double share) { return number_cell(100 * share, 3) + " %"; }

Series series_of(std::string name, const std::vector<Share>& shares, double Share::*member) {
    Series series{std::move(name), Series::Mark::line, {}};
    for (std::size_t i = 0; i < shares.size(); ++i) {
        series.values.push_back({static_cast<double>(light_counts[i]), 100 * shares[i].*member});
    }
    return series;
}

}  // namespace

void shadow_share(const Studio& studio, Sheet& sheet) {
    const std::vector<Share> shares = measure_shares(studio);
    Table table{{"lights", "of all rays", "of all tests", "of tracing time", "of the image's time"},
                {}};
    int lights_for_published = 0;
    bool rises = true;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        table.rows.push_back({std::to_string(light_counts[i]), percent_cell(shares[i].of_rays),
                              percent_cell(shares[i].of_tests), percent_cell(shares[i].of_tracing),
                              percent_cell(shares[i].of_image)});
        if (lights_for_published == 0 && shares[i].of_tests >= published_share)
            lights_for_published = light_counts[i];
        if (i > 0) rises &= shares[i].of_tests > shares[i - 1].of_tests;
    }
    sheet.add(CaptionedTable{std::string("The share of shadow rays: ") + lit_scene +
                                 " with lights " + "spread above it, structure " + lit_structure +
                                 ", five levels of rays; tests of objects and of boxes",
                             table});
    sheet.add(Chart{
        "shadow_share",
        "What is due to shadow rays",
        "lights",
        "%",
        {series_of("rays", shares, &Share::of_rays), series_of("tests", shares, &Share::of_tests),
         series_of("tracing time", shares, &Share::of_tracing),
         series_of("whole time", shares, &Share::of_image)}});
    sheet.add(Check{"share of tests with 64 lights", "90 %??", percent_cell(shares.back().of_tests),
                    agrees_if(shares.back().of_tests >= published_share)});
    sheet.add(Check{"fewest of the lights with which it is reached", "usually lots of lights",
                    lights_for_published > 0 ? std::to_string(lights_for_published) : "none",
                    agrees_if(lights_for_published > 1)});
    sheet.add(Check{"each doubling of the lights raises the share of tests", "",
                    rises ? "yes" : "no", agrees_if(rises)});
}

}  // namespace rayshoot::textbook
