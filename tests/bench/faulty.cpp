#include "tests/bench/faulty.h"

#include <tbb/global_control.h>

#include <cmath>

namespace rayshoot {
namespace {

class FaultySession final : public Session {
public:
    FaultySession(std::unique_ptr<Session> inner, Fault fault)
        : inner_(std::move(inner)), fault_(fault) {}

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        const auto declined = inner_->closest(batch, hits);
        for (std::size_t i = 0; i < batch.rays.size(); ++i) spoil(hits[i]);
        return declined;
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        const auto declined = inner_->occluded(batch, occluded);
        if (fault_ == Fault::missed_hit) {
            for (std::size_t i = 0; i < batch.rays.size(); ++i) {
                if (occluded[i] != 0 && ++hits_ % every == 0) occluded[i] = 0;
            }
        }
        return declined;
    }
    const Counters* counters(RayKind kind) const override { return inner_->counters(kind); }

private:
    static constexpr int every = 50;  ///< hits that one is spoilt of

    void spoil(Hit& hit) {
        if (hit.primitive == no_primitive || fault_ == Fault::none || ++hits_ % every != 0) return;
        if (fault_ == Fault::wrong_t) hit.t = std::nextafter(hit.t, infinity);
        if (fault_ == Fault::missed_hit) hit = {};
        if (fault_ == Fault::wrong_primitive) ++hit.primitive;
    }

    std::unique_ptr<Session> inner_;
    Fault fault_;
    int hits_ = 0;
};

class FaultyAccel final : public Accel {
public:
    FaultyAccel(const BuildInput& input, Fault fault, std::string spec)
        : inner_(build(built_in_catalogue(), "bvh", input)),
          fault_(fault),
          spec_(std::move(spec)) {}

    std::unique_ptr<Session> open(Mode mode) const override {
        return std::make_unique<FaultySession>(inner_->open(mode), fault_);
    }
    Footprint footprint() const override { return inner_->footprint(); }
    bool serves(Query, RayKind) const override { return true; }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return true; }
    bool remembers() const override { return false; }

private:
    std::unique_ptr<Accel> inner_;
    Fault fault_;
    std::string spec_;
};

template <Fault Planted>
StructureEntry entry(std::string_view name, Agreement agreement) {
    return {.name = name,
            .agreement = agreement,
            .complete = true,
            .remembers = false,
            .options = {},
            .configurations = {},
            .summary = "a bvh with a planted fault",
            .build = [](const BuildInput& input, const Options&,
                        std::string spec) -> std::unique_ptr<Accel> {
                return std::make_unique<FaultyAccel>(input, Planted, std::move(spec));
            },
            .refuses = [](const Geometry&) { return std::string(); }};
}

class LanesAccel final : public Accel {
public:
    LanesAccel(const BuildInput& input, std::string spec)
        : inner_(build(built_in_catalogue(), "bvh", input)),
          lanes_(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)),
          spec_(std::move(spec)) {}

    std::unique_ptr<Session> open(Mode mode) const override { return inner_->open(mode); }
    Footprint footprint() const override { return {.bytes = lanes_}; }
    bool serves(Query, RayKind) const override { return true; }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return true; }
    bool remembers() const override { return false; }

private:
    std::unique_ptr<Accel> inner_;
    std::size_t lanes_;
    std::string spec_;
};

std::unique_ptr<Accel> build_lanes(const BuildInput& input, const Options&, std::string spec) {
    return std::make_unique<LanesAccel>(input, std::move(spec));
}

}  // namespace

Catalogue faulty_catalogue() {
    Catalogue catalogue = built_in_catalogue();
    catalogue.push_back(entry<Fault::none>("sound", Agreement::exact));
    catalogue.push_back(entry<Fault::wrong_t>("wrong", Agreement::exact));
    catalogue.push_back(entry<Fault::wrong_primitive>("mistaken", Agreement::exact));
    catalogue.push_back(entry<Fault::missed_hit>("blind", Agreement::exact));
    catalogue.push_back(entry<Fault::missed_hit>("off", Agreement::tolerance));
    catalogue.push_back(entry<Fault::wrong_t>("tolerant", Agreement::tolerance));
    StructureEntry lanes = entry<Fault::none>("lanes", Agreement::exact);
    lanes.build = build_lanes;
    catalogue.push_back(lanes);
    return catalogue;
}

}  // namespace rayshoot
