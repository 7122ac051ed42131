#include "tests/contract/contract.h"
#include "tests/contract/oracle/closed_meshes.h"

#include <gtest/gtest.h>

/// precision=watertight: nothing gets out of a closed mesh, not through an edge, not through a
/// corner.
namespace rayshoot::contract {
namespace {

/// Corners, edges (a few points of each) and insides of all triangles.
std::vector<vec3> places(const Geometry& geometry, Random& random) {
    std::vector<vec3> places;
    for (std::uint32_t i = 0; i < geometry.size(); ++i) {
        const Triangle t = geometry.triangle(geometry.ref(i).index);
        const Face face{{t.a, t.b, t.c}, 0};
        for (const vec3& corner : face.corners) places.push_back(corner);
        for (const float share : {0.5f, 0.25f, random.unit()}) {
            places.push_back(face.point(share, 0));
            places.push_back(face.point(0, share));
            places.push_back(face.point(share, 1 - share));
        }
        places.push_back(face.random_point(random));
    }
    return places;
}

void expect_all_hit(const Accel& accel, std::span<const Ray> rays, const std::string& where) {
    const auto session = accel.open(Mode::timing);
    std::vector<Hit> hits(max_batch);
    std::vector<std::uint8_t> occluded(max_batch);
    for (std::size_t first = 0; first < rays.size(); first += max_batch) {
        const auto part = rays.subspan(first, std::min(max_batch, rays.size() - first));
        session->closest({RayKind::secondary, 1, part, {}}, hits);
        session->occluded({RayKind::secondary, 1, part, {}}, occluded);
        for (std::size_t i = 0; i < part.size(); ++i)
            ASSERT_TRUE(hits[i].primitive != no_primitive && occluded[i] == 1)
                << where << ": " << printed(part[i]) << " leaks";
    }
}

void expect_tight(const std::vector<Ray>& rays, const ClosedMesh& mesh, const std::string& what) {
    const Catalogue catalogue = built_in_catalogue();
    for (const std::string& spec : exact_configurations(catalogue)) {
        const auto accel = build(catalogue, spec, {mesh.geometry});
        expect_all_hit(*accel, rays, spec + " on " + mesh.name + ", " + what);
    }
}

TEST(Watertight, rays_from_inside_never_leak) {
    Random random(0x1ea6);
    for (const ClosedMesh& mesh : closed_meshes(Precision::watertight)) {
        std::vector<Ray> rays;
        for (const vec3& place : places(mesh.geometry, random)) {
            Ray ray;
            ray.origin = mesh.inside;
            ray.direction = (place - mesh.inside) * random.power_of_two(-20, 20);
            rays.push_back(ray);
        }
        expect_tight(rays, mesh, "from inside");
    }
}

/// A ray from outside that ends inside goes in somewhere; one that began there and goes on gets
/// out.
TEST(Watertight, rays_from_outside_go_in_and_out) {
    Random random(0x1ea7);
    for (const ClosedMesh& mesh : closed_meshes(Precision::watertight)) {
        std::vector<Ray> in, out;
        for (const vec3& place : places(mesh.geometry, random)) {
            Ray ray;  // at t = 1 it is inside; before or after that it has passed the place
            ray.origin = mesh.inside + random.between(3, 9) * (place - mesh.inside);
            ray.direction = mesh.inside - ray.origin;
            in.push_back(ray);
            in.back().t_max = 1;
            out.push_back(ray);
            out.back().t_min = 1;
        }
        expect_tight(in, mesh, "going in");
        expect_tight(out, mesh, "going out");
    }
}

}  // namespace
}  // namespace rayshoot::contract
