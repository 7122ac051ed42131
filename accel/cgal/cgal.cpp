#include "accel/cgal/cgal.h"

#include "accel/cgal/tree.h"
#include "accel/core/options.h"

#include <CGAL/version.h>

#include <cassert>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace cgal {
namespace {

class CgalSession final : public Session {
public:
    explicit CgalSession(const Tree& tree) : tree_(tree) {}

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        assert(hits.size() >= batch.rays.size());
        for (std::size_t i = 0; i < batch.rays.size(); ++i) hits[i] = tree_.closest(batch.rays[i]);
        return {};
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        assert(occluded.size() >= batch.rays.size());
        for (std::size_t i = 0; i < batch.rays.size(); ++i)
            occluded[i] = tree_.occluded(batch.rays[i]);
        return {};
    }
    const Counters* counters(RayKind) const override { return nullptr; }

private:
    const Tree& tree_;
};

class CgalAccel final : public Accel {
public:
    CgalAccel(const Geometry& geometry, std::string spec)
        : tree_(geometry), spec_(std::move(spec)) {}

    std::unique_ptr<Session> open(Mode) const override {
        return std::make_unique<CgalSession>(tree_);
    }
    Footprint footprint() const override {
        Footprint footprint;
        footprint.references = tree_.size();
        footprint.bytes = tree_.bytes();
        return footprint;
    }
    bool serves(Query, RayKind) const override { return true; }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return true; }
    bool remembers() const override { return false; }

private:
    Tree tree_;
    std::string spec_;
};

std::string refuses(const Geometry& geometry) {
    if (geometry.only_static_triangles()) return {};
    return "CGAL's AABB_tree takes triangles that stand still; this scene has other primitives or "
           "Movers";
}

std::unique_ptr<Accel> build(const BuildInput& input, const Options&, std::string spec) {
    const std::string reason = refuses(input.geometry);
    if (!reason.empty())
        throw std::invalid_argument("cgal: " + reason + "; use brute_force, bvh or embree");
    return std::make_unique<CgalAccel>(input.geometry, std::move(spec));
}

constexpr std::string_view configurations[] = {"cgal"};

}  // namespace
}  // namespace cgal

StructureEntry cgal_entry() {
    return {.name = "cgal",
            .agreement = Agreement::tolerance,
            .complete = true,
            .remembers = false,
            .options = {},
            .configurations = cgal::configurations,
            .summary = "CGAL AABB_tree in double; triangle scenes only (GPL-3 build)",
            .build = cgal::build,
            .refuses = cgal::refuses};
}

std::string cgal_description() {
    return "CGAL " CGAL_VERSION_STR ", AABB_tree, GPL-3 or later: this build is a GPL-3 whole";
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
