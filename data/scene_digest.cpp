#include "data/digest.h"
#include "data/scene.h"

namespace rayshoot {

namespace {

/// Adds values one after the other; sequences with their length in front.
class Writer {
public:
    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    template <class Sequence>
    void sequence(const Sequence& values) {
        put(static_cast<std::uint64_t>(values.size()));
        for (const auto& value : values) put(value);
    }
    /// A field that came later: nothing for its usual value, so that digests of scenes without it
    /// stay; else with its name, so that no other field or place can stand for it.
    template <class Value>
    void later(std::string_view name, std::size_t index, const Value& value, const Value& usual) {
        if (value == usual) return;
        digest_.add(name);
        put(static_cast<std::uint64_t>(index));
        put(value);
    }
    std::string hex() const { return digest_.hex(); }

private:
    template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
    void put(Number value) { digest_.add(value); }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void put(Enumeration value) { digest_.add(static_cast<std::uint32_t>(value)); }
    template <class Value, std::size_t size>
    void put(const std::array<Value, size>& values) {
        for (const Value& value : values) put(value);
    }
    void put(const vec3& v) { (*this)(v.x, v.y, v.z); }
    void put(const Box& box) { (*this)(box.lo, box.hi); }
    void put(const Sphere& sphere) { (*this)(sphere.centre, sphere.radius); }
    void put(const Motion& motion) { (*this)(motion.pivot, motion.translation, motion.rotation); }
    void put(const Lens& lens) {
        (*this)(lens.focal_length, lens.f_stop, lens.focus_distance, lens.blades, lens.blade_angle);
    }
    template <class Value>
    void put(const std::optional<Value>& value) {
        if (value) put(*value);
    }
    void put(std::monostate) {}

    Digest digest_;
};

void add_primitive(Writer& out, const Geometry& geometry, const PrimitiveRef& ref) {
    out(ref.kind);
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            out(geometry.triangles()[ref.index]);
            break;
        case PrimitiveKind::sphere:
            out(geometry.sphere(ref.index));
            break;
        case PrimitiveKind::frustum: {
            const Frustum& f = geometry.frustum(ref.index);
            out(f.base, f.base_radius, f.apex, f.apex_radius);
            break;
        }
        case PrimitiveKind::polygon: {
            const Polygon& p = geometry.polygon(ref.index);
            out.sequence(p.corners);
            out.sequence(p.normals);
            break;
        }
    }
    if (ref.motion != no_motion) out(geometry.motion(ref.motion));
}

void add_geometry(Writer& out, const Geometry& geometry) {
    out(geometry.precision());
    out.sequence(geometry.vertices());
    out.sequence(geometry.vertex_normals());
    out(geometry.size());
    for (std::uint32_t i = 0; i < geometry.size(); ++i)
        add_primitive(out, geometry, geometry.ref(i));
}

void add_material(Writer& out, const Material& m) {
    out(m.colour, m.diffuse, m.specular, m.shininess, m.transmittance, m.refraction_index);
}

void add_light(Writer& out, const Light& light) {
    out(light.kind, light.position, light.direction, light.edge_u, light.edge_v, light.radius,
        light.cos_inner, light.cos_outer, light.intensity, light.samples, light.strata_u,
        light.strata_v);
    out.sequence(light.primitives);
}

void add_hierarchy(Writer& out, const Hierarchy& hierarchy) {
    out(static_cast<std::uint64_t>(hierarchy.groups.size()));
    for (const Hierarchy::Group& group : hierarchy.groups) {
        out(static_cast<std::uint32_t>(group.bound.index()));
        std::visit([&out](const auto& bound) { out(bound); }, group.bound);
        out.sequence(group.groups);
        out.sequence(group.primitives);
    }
}

void add_later_fields(Writer& out, const std::vector<Material>& materials) {
    const Material usual;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const Material& m = materials[i];
        out.later("material.model", i, m.model, usual.model);
        out.later("material.roughness", i, m.roughness, usual.roughness);
        out.later("material.gloss", i, m.gloss, usual.gloss);
        out.later("material.eta", i, m.eta, usual.eta);
        out.later("material.absorption", i, m.absorption, usual.absorption);
        out.later("material.emission", i, m.emission, usual.emission);
    }
}

void add_later_fields(Writer& out, const std::vector<Light>& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i)
        out.later("light.falloff", i, lights[i].falloff, Light{}.falloff);
}

void add_later_fields(Writer& out, const Camera& camera) {
    const Camera usual;
    out.later("camera.lens", 0, camera.lens, usual.lens);
    out.later("camera.motion", 0, camera.motion, usual.motion);
    out.later("camera.shutter_open", 0, camera.shutter_open, usual.shutter_open);
    out.later("camera.shutter_close", 0, camera.shutter_close, usual.shutter_close);
}

}  // namespace

std::string digest(const Scene& scene) {
    Writer out;
    add_geometry(out, scene.geometry);
    for (const Material& material : scene.materials) add_material(out, material);
    out.sequence(scene.material_of);
    for (const Light& light : scene.lights) add_light(out, light);
    const Camera& c = scene.camera;
    out(c.from, c.at, c.up, c.angle, c.hither, c.width, c.height, scene.background);
    if (scene.hierarchy) add_hierarchy(out, *scene.hierarchy);
    // Last, so that they cannot be taken for what stands above. A hierarchy's first group has a
    // bound of kind 0 to 2, which is not how a name begins.
    add_later_fields(out, scene.materials);
    add_later_fields(out, scene.lights);
    add_later_fields(out, scene.camera);
    return out.hex();
}

}  // namespace rayshoot
