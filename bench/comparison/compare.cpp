#include "bench/comparison/compare.h"

#include "bench/comparison/adaptor_cost.h"
#include "bench/comparison/stream_comparison.h"
#include "bench/streams/ray_file.h"
#include "bench/streams/record.h"
#include "data/scenes.h"

#include <algorithm>

namespace rayshoot {
namespace {

class Run {
public:
    Run(const Catalogue& catalogue, const ComparisonPlan& plan)
        : catalogue_(catalogue),
          plan_(plan),
          progress_(plan.scenes.size() * plan.structures.size() *
                    (1 + streams_per_scene() * (1 + static_cast<std::size_t>(plan.repetitions)))) {}

    Comparison result() {
        for (const std::string& name : plan_.scenes) {
            const Scene scene = load_scene(name);
            comparison_.scenes.push_back({scene.name, digest(scene), scene.geometry.size()});
            if (plan_.ray_files.empty()) {
                compare_on(scene, plan_.format,
                           record_streams(catalogue_, scene, plan_.kinds, plan_.format));
            }
            for (const auto& path : plan_.ray_files) {
                RayStream stream = read_ray_file(path);
                const ImageFormat format = format_of(stream, plan_.format);
                std::vector<RayStream> streams;
                streams.push_back(std::move(stream));
                compare_on(scene, format, std::move(streams));
            }
        }
        return std::move(comparison_);
    }

private:
    std::size_t streams_per_scene() const {
        return plan_.ray_files.empty() ? plan_.kinds.size() : plan_.ray_files.size();
    }

    void compare_on(const Scene& scene, const ImageFormat& format, std::vector<RayStream> streams) {
        const BuildInput input = build_input(scene, format);
        std::vector<Candidate> candidates;
        for (const std::string& spec : plan_.structures) {
            progress_.advance("build/" + scene.name + "/" + spec);
            candidates.push_back(
                make_candidate(catalogue_, spec, input, plan_.threads, plan_.repetitions));
        }
        for (RayStream& stream : streams) {
            stream.scene = scene.name;
            compare_on_stream(input, candidates, stream);
        }
    }

    void compare_on_stream(const BuildInput& input, const std::vector<Candidate>& candidates,
                           const RayStream& stream) {
        const StreamContext context{catalogue_, plan_, input, stream};
        StreamResult result = compare_stream(context, candidates, control_, progress_);
        comparison_.streams.push_back(result.summary);
        if (plan_.adaptor_cost && std::ranges::any_of(candidates, [](const Candidate& candidate) {
                return candidate.is_embree() && candidate.accel;
            })) {
            for (auto& row : adaptor_cost(input.geometry, stream, plan_.repetitions)) {
                comparison_.adaptor.push_back(std::move(row));
            }
        }
        std::ranges::move(result.rows, std::back_inserter(comparison_.rows));
        std::ranges::move(result.control_samples, std::back_inserter(comparison_.control_samples));
    }

    const Catalogue& catalogue_;
    const ComparisonPlan& plan_;
    Progress progress_;
    ControlKernel control_;
    Comparison comparison_;
};

}  // namespace

bool Comparison::failed() const {
    return std::ranges::any_of(rows, [](const Row& row) { return !row.error.empty(); });
}

Comparison compare(const Catalogue& catalogue, const ComparisonPlan& plan) {
    require_valid(catalogue, plan);
    return Run(catalogue, plan).result();
}

}  // namespace rayshoot
