#include "tests/contract/rays.h"

namespace rayshoot::contract {
namespace {

vec3 scene_centre(const Geometry& geometry) {
    return geometry.size() > 0 ? geometry.bounds().centre() : vec3(0);
}

/// A ray through both points, `to` at some t that is a power of two.
Ray through(const vec3& from, const vec3& to, float time, Random& random) {
    Ray ray;
    ray.origin = from;
    ray.direction = (to - from) * random.power_of_two(-6, 6);
    if (ray.direction == vec3(0)) ray.direction = random.direction();
    ray.time = time;
    return ray;
}

/// From a place up to three scene sizes away from the target.
Ray aimed_at(const vec3& target, const Geometry& geometry, float time, Random& random) {
    const float distance = scene_size(geometry) * random.between(0.01f, 3);
    return through(target + distance * random.direction(), target, time, random);
}

Ray chord(const Geometry& geometry, Random& random) {
    const vec3 reach(scene_size(geometry));
    const vec3 centre = scene_centre(geometry);
    const Box around{centre - reach, centre + reach};
    const vec3 from = random.inside(around);
    const vec3 to = random.inside(around);
    return through(from, to, random.unit(), random);
}

Ray at_a_vertex(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    return aimed_at(face.corners[0], geometry, face.time, random);
}

Ray at_an_edge(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    return aimed_at(face.point(random.unit(), 0), geometry, face.time, random);
}

Ray at_a_face(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    return aimed_at(face.random_point(random), geometry, face.time, random);
}

Ray along_an_edge(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const float start = random.coin() ? -1.0f : random.unit();
    const vec3 from = face.point(start, 0);
    return through(from, face.corners[1], face.time, random);
}

/// In the plane of a face, from outside the face, its border or its inside.
Ray in_a_face(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const float u = random.between(-2, 2);
    const vec3 from = random.coin() ? face.point(u, random.between(-2, 2)) : face.corners[0];
    return through(from, face.random_point(random), face.time, random);
}

/// From within 1e-5 of a face's plane to a point of the face, or as far from it.
Ray grazing(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const vec3 off = face.normal() * (1e-5f * scene_size(geometry));
    const float u = random.between(-3, 3);
    const vec3 foot = face.point(u, random.between(-3, 3));
    const vec3 from = foot + off * random.between(-1, 1);
    const vec3 to = face.random_point(random);
    return through(from, random.coin() ? to : to + off * random.between(-1, 1), face.time, random);
}

Ray from_a_face(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const vec3 from = face.random_point(random);
    return through(from, from + scene_size(geometry) * random.direction(), face.time, random);
}

/// From one primitive's corner to another's: both ends are ties among neighbours.
Ray from_vertex_to_vertex(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const vec3 to = random_face(geometry, random).corners[1];
    return through(face.corners[0], to, face.time, random);
}

Ray from_the_centre(const Geometry& geometry, Random& random) {
    const vec3 from = scene_centre(geometry);
    const vec3 to = from + scene_size(geometry) * random.direction();
    return through(from, to, random.unit(), random);
}

}  // namespace

std::vector<RayFamily> aimed_families() {
    return {{"chord", chord},
            {"at_a_vertex", at_a_vertex},
            {"at_an_edge", at_an_edge},
            {"at_a_face", at_a_face},
            {"along_an_edge", along_an_edge},
            {"in_a_face", in_a_face},
            {"grazing", grazing},
            {"from_a_face", from_a_face},
            {"from_vertex_to_vertex", from_vertex_to_vertex},
            {"from_the_centre", from_the_centre}};
}

}  // namespace rayshoot::contract
