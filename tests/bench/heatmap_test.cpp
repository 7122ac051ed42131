#include "bench/heatmap/cost_map.h"

#include "accel/core/catalogue.h"
#include "bench/timing/watched_accel.h"
#include "data/scenes.h"
#include "tests/bench/command.h"
#include "tracer/colour_map.h"
#include "tracer/wavefront.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <sstream>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

const char* const scene_name = "spd/balls:size=2";
constexpr ImageFormat small{20, 17, 1, Raster::corners, 0};

RenderSettings settings_of(const ImageFormat& format) {
    RenderSettings settings;
    settings.format = format;
    return settings;
}

std::unique_ptr<Accel> built(const Scene& scene, const std::string& spec,
                             const ImageFormat& format) {
    return build(built_in_catalogue(), spec, build_input(scene, format));
}

std::uint64_t counted(const Scene& scene, const Accel& accel, RenderSettings settings,
                      Event event) {
    settings.mode = Mode::counting;
    const RenderResult result = render(scene, accel, settings);
    std::uint64_t sum = 0;
    for (int kind = 0; kind < ray_kinds; ++kind)
        sum += (*result.session->counters(static_cast<RayKind>(kind)))[event];
    return sum;
}

TEST(CostMap, sums_to_what_the_image_counts_in_batches_of_one_ray) {
    const Scene scene = load_scene(scene_name);
    const RenderSettings settings = settings_by_pixel(settings_of(small));
    EXPECT_EQ(settings.batch, 1u);
    for (const char* spec : {"brute_force", "bvh", "bvh8", "grid", "octree", "bsp"}) {
        const auto accel = built(scene, spec, small);
        for (const auto& [cost, event] :
             {std::pair(Cost::tests, Event::object_test), std::pair(Cost::steps, Event::step),
              std::pair(Cost::boxes, Event::bounding_volume_test)}) {
            const CostSummary summary = summarise(cost_map(scene, *accel, settings, cost));
            EXPECT_EQ(summary.sum, counted(scene, *accel, settings, event))
                << spec << ' ' << name_of(cost);
        }
    }
}

TEST(CostMap, of_several_samples_sums_to_the_count_too) {
    const Scene scene = load_scene(scene_name);
    ImageFormat format = small;
    format.spp = 3;
    const RenderSettings settings = settings_by_pixel(settings_of(format));
    EXPECT_EQ(settings.batch, 3u);
    const auto accel = built(scene, "bvh", format);
    EXPECT_EQ(summarise(cost_map(scene, *accel, settings, Cost::tests)).sum,
              counted(scene, *accel, settings, Event::object_test));
}

TEST(CostMap, charges_a_pixel_with_the_rays_of_its_own_path) {
    const Scene scene = load_scene(scene_name);
    const auto accel = built(scene, "brute_force", small);
    const ScalarImage map =
        cost_map(scene, *accel, settings_by_pixel(settings_of(small)), Cost::tests);
    // An image of that pixel alone, in the middle of the raster: the same camera ray.
    const CameraRays camera(scene.camera, small);
    const auto integrator = make_integrator(scene, {});
    const Sampler sampler({});
    for (const Pixel pixel : {Pixel{0, 0}, Pixel{10, 8}, Pixel{19, 16}, Pixel{5, 12}}) {
        const auto session = accel->open(Mode::counting);
        Shot shot;
        shot.ray = camera.ray(pixel.x + 0.5, pixel.y + 0.5, {}, 0);
        shot.source = CameraRays::source(pixel);
        shot.sampler = &sampler;
        shot.pixel = pixel;
        Wavefront(*integrator, *session, scene.lights.size(), 1).trace({&shot, 1});
        double tests = 0;
        for (int kind = 0; kind < ray_kinds; ++kind)
            tests += static_cast<double>(
                (*session->counters(static_cast<RayKind>(kind)))[Event::object_test]);
        EXPECT_EQ(map.at(pixel.x, pixel.y), tests) << pixel.x << ' ' << pixel.y;
    }
}

TEST(CostMap, is_of_images_whose_rays_stay_in_their_pixels) {
    RenderSettings wide = settings_of(small);
    wide.filter = {FilterKind::raised_cosine, 1.6};
    EXPECT_THROW(settings_by_pixel(wide), std::invalid_argument);
    RenderSettings shared = settings_of(small);
    shared.transport.method = Method::irradiance;
    EXPECT_THROW(settings_by_pixel(shared), std::invalid_argument);
    // All rays of paths through a lens are charged to somebody.
    const Scene scene = load_scene("gallery/depth_of_field");
    RenderSettings paths = settings_of({20, 15, 3, Raster::centres, 0});
    paths.transport.method = Method::path;
    const RenderSettings settings = settings_by_pixel(paths);
    const auto accel = build(built_in_catalogue(), "bvh", build_input(scene, settings));
    EXPECT_EQ(summarise(cost_map(scene, *accel, settings, Cost::tests)).sum,
              counted(scene, *accel, settings, Event::object_test));
}

TEST(CostMap, of_time_is_positive_everywhere_and_no_more_than_the_whole_took) {
    const Scene scene = load_scene(scene_name);
    const RenderSettings settings = settings_by_pixel(settings_of(small));
    const auto accel = built(scene, "bvh", small);
    const auto start = std::chrono::steady_clock::now();
    const ScalarImage map = cost_map(scene, *accel, settings, Cost::time);
    const std::chrono::duration<double, std::nano> whole = std::chrono::steady_clock::now() - start;
    for (const double cost : map.values()) EXPECT_GT(cost, 0);
    EXPECT_LT(summarise(map).sum, whole.count());
}

TEST(CostMap, keeps_the_least_of_each_pixel) {
    ScalarImage least(2, 1, 5), other(2, 1, 7);
    other.at(0, 0) = 3;
    keep_least(least, other);
    EXPECT_EQ(least.values(), (std::vector<double>{3, 5}));
    EXPECT_EQ(summarise(least).largest, 5);
    EXPECT_EQ(summarise(least).largest_at, (Pixel{1, 0}));
    EXPECT_EQ(summarise(least).mean, 4);
}

TEST(WatchedAccel, answers_and_counts_as_the_structure_itself) {
    const Scene scene = load_scene(scene_name);
    const auto accel = built(scene, "bvh8", small);
    std::size_t rays = 0;
    const WatchedAccel watched(*accel, [&](const AnsweredBatch& answered) {
        EXPECT_GE(answered.seconds, 0);
        EXPECT_EQ(answered.question == Query::occluded, answered.batch.kind == RayKind::shadow);
        rays += answered.batch.rays.size();
    });
    RenderSettings settings;
    settings.format = small;
    settings.mode = Mode::counting;
    const RenderResult plain = render(scene, *accel, settings);
    const RenderResult seen = render(scene, watched, settings);
    EXPECT_EQ(seen.image, plain.image);
    std::size_t expected = 0;
    for (int i = 0; i < ray_kinds; ++i) {
        const auto kind = static_cast<RayKind>(i);
        EXPECT_EQ(*seen.session->counters(kind), *plain.session->counters(kind));
        expected += plain.counts.of(kind).rays;
    }
    EXPECT_EQ(rays, expected);
}

std::vector<std::string> heatmap_of(const std::filesystem::path& folder,
                                    const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"heatmap", "--scene", scene_name, "--size",
                                       "20x17",   "--json",  "--out",    folder.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

double counted_by_command(const std::string& spec, const std::string& event) {
    const Json document = call({"count", "--scene", scene_name, "--structure", spec, "--size",
                                "20x17", "--batch", "1", "--json"})
                              .json();
    double sum = 0;
    for (const Json& kind : document["rays"]) sum += kind[event].get<double>();
    return sum;
}

TEST(Heatmap, command_agrees_with_count_and_has_one_scale_for_all) {
    const auto folder = fresh_folder("heatmap") / "new";
    const Call mapped = call(heatmap_of(folder, {"--structure", "bvh", "bvh8"}));
    ASSERT_EQ(mapped.code, 0) << mapped.err;
    const Json document = mapped.json();
    double largest = 0;
    for (const Json& row : document["structures"]) {
        const std::string spec = row["structure"];
        EXPECT_EQ(row["sum"].get<double>(), counted_by_command(spec, "object_tests")) << spec;
        largest = std::max(largest, row["largest"].get<double>());
    }
    EXPECT_EQ(document["scale"]["high"], largest);
    EXPECT_EQ(document["unit"], "object tests");

    std::ifstream csv(folder / "values.csv");
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "x,y,bvh,bvh8\r");
    double sum = 0;
    while (std::getline(csv, line)) {
        int x = 0, y = 0;
        double bvh = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%lf", &x, &y, &bvh), 3) << line;
        const Image values = read_image(folder / "bvh.exr");
        EXPECT_EQ(values.at(x, y).x, bvh);
        sum += bvh;
    }
    EXPECT_EQ(sum, document["structures"][0]["sum"].get<double>());
    for (const char* file : {"bvh.png", "bvh8.png", "colour_bar.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

TEST(Heatmap, top_and_logarithm_change_colours_alone) {
    const auto folder = fresh_folder("heatmap_top");
    const Call mapped = call(heatmap_of(folder, {"--structure", "brute_force", "--quantity",
                                                 "tests", "--top", "100", "--scale", "log"}));
    ASSERT_EQ(mapped.code, 0) << mapped.err;
    EXPECT_EQ(mapped.json()["scale"]["high"], 100);
    EXPECT_EQ(mapped.json()["structures"][0]["sum"].get<double>(),
              counted_by_command("brute_force", "object_tests"));
    // 91 primitives a ray and more rays than one: beyond the top everywhere.
    const Image image = read_image(folder / "brute-force.png");
    const vec3 last = map_colour(1);
    for (const vec3& pixel : image.pixels()) EXPECT_LT(length(pixel - last), 0.05f);
}

TEST(Heatmap, of_time_says_what_it_is) {
    const auto folder = fresh_folder("heatmap_time");
    std::vector<std::string> arguments =
        heatmap_of(folder, {"--structure", "bvh", "--quantity", "time", "--repetitions", "2"});
    std::erase(arguments, "--json");
    const Call mapped = call(arguments);
    ASSERT_EQ(mapped.code, 0) << mapped.err;
    EXPECT_NE(mapped.out.find("ns per pixel"), std::string::npos) << mapped.out;
    EXPECT_NE(mapped.out.find("slower"), std::string::npos) << mapped.out;
}

TEST(Heatmap, specs_that_differ_in_punctuation_get_files_of_their_own) {
    const auto folder = fresh_folder("heatmap_twice");
    const Call mapped = call(heatmap_of(folder, {"--structure", "bvh", "bvh"}));
    ASSERT_EQ(mapped.code, 0) << mapped.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "bvh.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "bvh-2.png"));
}

TEST(Heatmap, a_structure_that_cannot_count_is_refused_but_for_time) {
    if (call({"list"}).out.find("embree") == std::string::npos)
        GTEST_SKIP() << "Embree was not found when this was built";
    const auto folder = fresh_folder("heatmap_embree");
    const Call refused = call(heatmap_of(folder, {"--structure", "embree"}));
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("--quantity time"), std::string::npos) << refused.err;
    EXPECT_EQ(call(heatmap_of(folder, {"--structure", "embree", "--quantity", "time",
                                       "--repetitions", "1"}))
                  .code,
              0);
}

}  // namespace
}  // namespace rayshoot
