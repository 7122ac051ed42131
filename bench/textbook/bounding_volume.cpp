#include "bench/textbook/figures.h"

#include "data/scenes.h"
#include "tracer/render.h"

#include <stdexcept>

/// "If a chair is made up of arms, back, seat, legs, but ray misses bounding sphere, big win! ...
/// do one intersection test instead of 96!"
namespace rayshoot::textbook {
namespace {

/// The rays of an image, those that missed the bound, and what both took.
struct Walk {
    std::vector<Hit> hits;
    Counters counters;
};

RayBatch batch_of(std::span<const Ray> rays) { return {RayKind::camera, 1, rays, {}}; }

Walk nearest_hits(const Accel& accel, std::span<const Ray> rays) {
    Walk walk;
    walk.hits.resize(rays.size());
    const auto session = accel.open(Mode::counting);
    for (std::size_t first = 0; first < rays.size(); first += default_batch) {
        const std::size_t count = std::min(default_batch, rays.size() - first);
        session->closest(batch_of(rays.subspan(first, count)),
                         std::span(walk.hits).subspan(first, count));
    }
    walk.counters = *session->counters(RayKind::camera);
    return walk;
}

std::vector<Ray> rays_of(const Scene& scene, int edge) {
    const CameraRays camera(scene.camera, {edge, edge, 1, Raster::centres, 0});
    std::vector<Ray> rays;
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            rays.push_back(
                camera.ray({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)}));
        }
    }
    return rays;
}

/// The sphere that the scene's author put round the whole chair.
Geometry bounding_sphere(const Scene& scene) {
    const auto* sphere = std::get_if<Sphere>(&scene.hierarchy.value().groups.front().bound);
    if (!sphere) throw std::logic_error("the chair has lost its bounding sphere");
    GeometryBuilder builder;
    builder.add_sphere(*sphere);
    return std::move(builder).build();
}

std::string per_ray(std::uint64_t tests, std::size_t rays) {
    return short_number(static_cast<double>(tests) / static_cast<double>(rays));
}

}  // namespace

void bounding_volume(const Studio& studio, Sheet& sheet) {
    const Scene scene = load_scene("chair");
    const Geometry bound = bounding_sphere(scene);
    const std::vector<Ray> rays = rays_of(scene, studio.edge);
    const auto all = build(studio.catalogue, "brute_force", {scene.geometry});
    const Walk without = nearest_hits(*all, rays);
    const Walk sphere = nearest_hits(*build(studio.catalogue, "brute_force", {bound}), rays);
    std::vector<Ray> remaining;
    std::vector<Hit> expected;
    bool lost = false;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (sphere.hits[i].primitive == no_primitive) {
            lost |= without.hits[i].primitive != no_primitive;
            continue;
        }
        remaining.push_back(rays[i]);
        expected.push_back(without.hits[i]);
    }
    const Walk inside = nearest_hits(*all, remaining);
    const Walk boxes = nearest_hits(*build(studio.catalogue, "bvh", {scene.geometry}), rays);
    const std::uint64_t objects = without.counters[Event::object_test];
    const std::uint64_t with_sphere =
        sphere.counters[Event::object_test] + inside.counters[Event::object_test];

    RenderSettings settings;
    settings.format = {studio.edge, studio.edge, 1, Raster::centres, 0};
    settings.threads = studio.threads;
    sheet.add(Picture{"chair", "The chair of 96 objects"}, render(scene, *all, settings).image);
    Table table{{"", "tests per ray"}, {}};
    table.rows = {
        {"every object", per_ray(objects, rays.size())},
        {"bounding sphere, then every object", per_ray(with_sphere, rays.size())},
        {"bvh: boxes within boxes",
         per_ray(boxes.counters[Event::object_test] + boxes.counters[Event::bounding_volume_test],
                 rays.size())}};
    sheet.add(CaptionedTable{"Intersection tests of camera rays, of bounds and of objects, " +
                                 std::to_string(rays.size() - remaining.size()) + " of " +
                                 std::to_string(rays.size()) + " rays missing the sphere",
                             table});
    const std::uint64_t missing = rays.size() - remaining.size();
    sheet.add(Check{"tests of a ray that misses, without a bound", "96",
                    per_ray(objects, rays.size()), agrees_if(objects == 96 * rays.size())});
    const std::uint64_t for_missing = with_sphere - 97 * remaining.size();
    sheet.add(Check{"tests of a ray that misses the bounding volume", "1",
                    per_ray(for_missing, missing),
                    agrees_if(missing > 0 && for_missing == missing)});
    sheet.add(Check{"rays that hit the chair and miss its bound; hits that the bound changes", "",
                    lost || inside.hits != expected ? "some" : "none",
                    agrees_if(!lost && inside.hits == expected && boxes.hits == without.hits)});
}

}  // namespace rayshoot::textbook
