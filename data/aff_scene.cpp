#include "data/aff.h"
#include "data/aff_poses.h"
#include "data/nff.h"

#include <stdexcept>
#include <unordered_map>

namespace rayshoot {
namespace {

[[noreturn]] void refuse_beyond(const std::string& what, const std::string& name) {
    throw std::invalid_argument(name + ": key frames or transforms put " + what +
                                " beyond single precision; check their numbers");
}

bool placed_somewhere(const Camera& camera) {
    const bool moves_somewhere = !camera.motion || (finite(camera.motion->translation[1]) &&
                                                    std::isfinite(camera.motion->rotation[1][3]));
    return moves_somewhere && finite(camera.from) && finite(camera.at) && finite(camera.up);
}

Exposure exposure_of(const AffAnimation& animation, const Frame& frame, const std::string& name) {
    constexpr double usual_shutter = 0.5;  // the half turn of a film camera's shutter
    const int frames = frames_of(frame, animation.frames, name);
    const double step = (animation.end - animation.start) / (frames > 1 ? frames - 1 : 1);
    const double open = animation.start + frame.number * step;
    return {open, open + frame.shutter.value_or(usual_shutter) * step};
}

/// Adds the model's items to geometry, as they stand where the shutter opens.
class Baker {
public:
    Baker(const AffModel& model, const AffPoses& poses, double middle, Scene& scene)
        : model_(model), poses_(poses), middle_(middle), scene_(scene) {}

    Geometry bake(Precision precision) {
        for (const AffItem& item : model_.items) {
            if (!poses_.visible(item.transform)) continue;
            pose_ = &poses_.pose(item.transform);
            try {
                motion_ = motion_of(item.transform);
                std::visit([this](const auto& shape) { add(shape); }, item.shape);
            } catch (const std::invalid_argument& error) {
                throw std::invalid_argument(item.where + ": " + error.what());
            }
            scene_.material_of.resize(builder_.size(), item.material);
        }
        return std::move(builder_).build(precision);
    }

private:
    std::uint32_t motion_of(std::uint32_t transform) {
        const auto source = poses_.mover(transform);
        if (!source) return no_motion;
        const auto [place, is_new] = motions_.try_emplace(*source, no_motion);
        if (is_new) place->second = builder_.add_motion(poses_.motion(*source));
        return place->second;
    }

    std::vector<vec3> placed(const std::vector<vec3>& points) const {
        std::vector<vec3> moved;
        for (const vec3& point : points) moved.push_back(pose_->point(point));
        return moved;
    }
    std::vector<vec3> turned(const std::vector<vec3>& normals) const {
        std::vector<vec3> moved;
        for (const vec3& normal : normals) moved.push_back(pose_->normal(normal));
        return moved;
    }

    void add(const AffMesh& mesh);
    void add(const Outline& outline) {
        builder_.add_polygon(placed(outline.corners), turned(outline.normals), motion_);
    }
    void add(const AffDeforming& triangle);
    void add(const Sphere& sphere) {
        builder_.add_sphere({pose_->point(sphere.centre), sphere.radius * pose_->even_scale()},
                            motion_);
    }
    void add(const Frustum& f) {
        const float scale = pose_->even_scale();
        builder_.add_frustum({pose_->point(f.base), scale * f.base_radius, pose_->point(f.apex),
                              scale * f.apex_radius},
                             motion_);
    }

    const AffModel& model_;
    const AffPoses& poses_;
    double middle_;
    Scene& scene_;
    GeometryBuilder builder_;
    std::unordered_map<std::uint32_t, std::uint32_t> motions_;  ///< by the transform that moves
    const AffPose* pose_ = nullptr;                             ///< of the item being added
    std::uint32_t motion_ = no_motion;
};

/// A corner is a pair of a vertex and a normal; each pair becomes one vertex of the geometry.
void Baker::add(const AffMesh& mesh) {
    const std::vector<vec3> points = placed(mesh.vertices), normals = turned(mesh.normals);
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    const auto corner = [&](std::uint32_t vertex, std::uint32_t normal) {
        const auto [place, is_new] =
            known.try_emplace(std::uint64_t{vertex} << 32 | normal, std::uint32_t{0});
        if (is_new)
            place->second = normals.empty() ? builder_.add_vertex(points[vertex])
                                            : builder_.add_vertex(points[vertex], normals[normal]);
        return place->second;
    };
    for (const AffMesh::Triangle& triangle : mesh.triangles) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = corner(triangle.vertices[i], triangle.normals[i]);
        builder_.add_triangle(corners, motion_);
    }
}

/// As it is in the middle of the exposure.
void Baker::add(const AffDeforming& triangle) {
    const std::vector<Key<Outline>>& keys = triangle.keys;
    std::size_t next = 0;
    while (next + 1 < keys.size() && keys[next].time < middle_) ++next;
    const std::size_t last = next > 0 ? next - 1 : 0;
    const double step = keys[next].time - keys[last].time;
    const double share = step > 0 ? std::clamp((middle_ - keys[last].time) / step, 0.0, 1.0) : 0.0;
    Outline outline;
    const auto between = [share](const vec3& a, const vec3& b) {
        return vec3((1 - share) * dvec3(a) + share * dvec3(b));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Outline &a = keys[last].value, &b = keys[next].value;
        outline.corners.push_back(between(a.corners[i], b.corners[i]));
        outline.normals.push_back(between(a.normals[i], b.normals[i]));
    }
    add(outline);
}

void add_lights(const AffModel& model, const AffPoses& poses, double middle,
                const std::string& name, Scene& scene) {
    for (const AffLight& given : model.lights) {
        vec3 position = given.position;
        const auto frames = model.key_frames.find(given.key_frames);
        if (frames != model.key_frames.end() && frames->second.translation)
            position = vec3(frames->second.translation->at(middle));
        Light light;
        light.position = poses.pose(given.transform).point(position);
        if (!finite(light.position)) refuse_beyond("a light", name);
        light.samples.include(light.position);
        light.intensity = given.colour.value_or(vec3(nff_light_intensity(model.lights.size())));
        scene.lights.push_back(light);
    }
}

}  // namespace

Scene aff_scene(const AffModel& model, const std::string& name, Precision precision,
                const Frame& frame) {
    if (!model.camera)
        throw std::invalid_argument(name +
                                    ": there is no view; AFF wants one: v from x y z at x y "
                                    "z up x y z angle degrees hither distance resolution x y");
    const Exposure exposure = exposure_of(model.animation, frame, name);
    const AffPoses poses(model, exposure);
    Scene scene;
    scene.materials = model.materials;
    scene.geometry = Baker(model, poses, exposure.middle(), scene).bake(precision);
    add_lights(model, poses, exposure.middle(), name, scene);
    scene.camera = poses.camera();
    if (!placed_somewhere(scene.camera)) refuse_beyond("the camera", name);
    scene.background = model.background;
    scene.notes.assign(model.left_out.begin(), model.left_out.end());
    return scene;
}

}  // namespace rayshoot
