#include "tests/contract/checks/checks.h"
#include "tests/contract/contract.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>

/// Scenes and rays that nobody thought of. A counterexample is shrunk before it is shown.
namespace rayshoot::contract {
namespace {

/// Coordinates from a coarse lattice: ties, planes and degenerate shapes come by themselves.
rc::Gen<vec3> lattice_point() {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::inRange(-4, 5), rc::gen::inRange(-4, 5), rc::gen::inRange(-4, 5)),
        [](const std::tuple<int, int, int>& p) {
            return vec3(std::get<0>(p), std::get<1>(p), std::get<2>(p)) * 0.5f;
        });
}

/// Any float that has a value, from the smallest to about 1e18.
rc::Gen<float> any_float() {
    return rc::gen::suchThat(
        rc::gen::map(rc::gen::arbitrary<std::uint32_t>(),
                     [](std::uint32_t bits) { return std::bit_cast<float>(bits); }),
        [](float x) { return std::abs(x) < 1e18f; });
}

rc::Gen<vec3> any_point() {
    return rc::gen::map(rc::gen::tuple(any_float(), any_float(), any_float()),
                        [](const std::tuple<float, float, float>& p) {
                            return vec3(std::get<0>(p), std::get<1>(p), std::get<2>(p));
                        });
}

Geometry mesh_of(const std::vector<vec3>& points, Precision precision) {
    GeometryBuilder builder;
    for (std::size_t i = 0; i + 2 < points.size(); i += 3)
        builder.add_triangle(points[i], points[i + 1], points[i + 2]);
    for (std::size_t i = 0; i + 1 < points.size(); i += 5) builder.add_sphere({points[i], 0.5f});
    return std::move(builder).build(precision);
}

Stream rays_between(const std::vector<vec3>& points) {
    Stream stream{.name = "rays between points"};
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        Ray ray;
        ray.origin = points[i];
        ray.direction = points[i + 1] - points[i];
        stream.rays.push_back(ray);
    }
    stream.families.assign(stream.size(), "property");
    return stream;
}

void assert_answers_like_brute_force(const std::vector<vec3>& corners,
                                     const std::vector<vec3>& ends) {
    const Catalogue catalogue = built_in_catalogue();
    const Precision precision = corners.size() % 2 ? Precision::watertight : Precision::standard;
    const Geometry geometry = mesh_of(corners, precision);
    Stream stream = rays_between(ends);
    answer_truly(geometry, stream);
    Report report;
    for (const std::string& spec : exact_configurations(catalogue)) {
        const auto accel = build(catalogue, spec, {geometry});
        const auto session = accel->open(Mode::timing);
        compare(stream, ask(*session, stream, default_batch, report, spec), report, spec);
    }
    std::string messages;
    for (const std::string& message : report.messages) messages += message + "\n";
    RC_ASSERT(messages == "");
}

RC_GTEST_PROP(Property, scenes_on_a_lattice_are_answered_like_brute_force, ()) {
    assert_answers_like_brute_force(*rc::gen::container<std::vector<vec3>>(lattice_point()),
                                    *rc::gen::container<std::vector<vec3>>(lattice_point()));
}

RC_GTEST_PROP(Property, scenes_of_any_floats_are_answered_like_brute_force, ()) {
    assert_answers_like_brute_force(*rc::gen::container<std::vector<vec3>>(any_point()),
                                    *rc::gen::container<std::vector<vec3>>(any_point()));
}

}  // namespace
}  // namespace rayshoot::contract
