#pragma once

#include "data/key_frames.h"
#include "data/nff_shapes.h"
#include "data/scene.h"

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

/// What AFF files say, before any moment of the animation is chosen.
namespace rayshoot {

/// A transform of what it holds and of the transforms inside it.
struct AffTransform {
    std::uint32_t parent = 0;                                  ///< the root is its own
    std::variant<glm::dmat4, std::string> own{glm::dmat4(1)};  ///< static; or the key frames' name
    std::string where;                                         ///< file:line
};

/// An indexed mesh; corners of triangles index `vertices` and, where there are any, `normals`.
struct AffMesh {
    struct Triangle {
        std::array<std::uint32_t, 3> vertices{}, normals{};
    };
    std::vector<vec3> vertices, normals;
    std::vector<Triangle> triangles;
};

/// A triangle that is deformed: its corners at several times, linear between them.
struct AffDeforming {
    std::vector<Key<Outline>> keys;  ///< times strictly ascending, three corners each
};

using AffShape = std::variant<AffMesh, Outline, AffDeforming, Sphere, Frustum>;

struct AffItem {
    std::uint32_t transform = 0, material = 0;
    AffShape shape;
    std::string where;  ///< file:line
};

struct AffLight {
    vec3 position{0};
    std::optional<vec3> colour;
    std::string key_frames;  ///< the name of those that place it; empty: it stands still
    std::uint32_t transform = 0;
};

/// When the first and the last frame are, and how many there are.
struct AffAnimation {
    double start = 0, end = 1;
    int frames = 1;
};

/// How much there is in all files, each taken once however often it is included.
struct AffCounts {
    int files = 0, meshes = 0, static_transforms = 0, animated_transforms = 0;
    int key_frames = 0;  ///< named ones: objects and the camera
    int lights = 0;
    bool operator==(const AffCounts&) const = default;
};

struct AffModel {
    std::vector<AffTransform> transforms{1};  ///< parents before children; the first is the root
    std::vector<AffItem> items;
    std::vector<Material> materials;
    std::vector<AffLight> lights;
    std::map<std::string, KeyFrames> key_frames;
    std::optional<Camera> camera;
    vec3 background{0};
    AffAnimation animation;
    AffCounts counts;
    std::set<std::string> left_out;  ///< for Scene::notes
};

}  // namespace rayshoot
