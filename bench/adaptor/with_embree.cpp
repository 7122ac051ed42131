#include "accel/embree/direct.h"
#include "bench/comparison/adaptor_cost.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rayshoot {
namespace {

constexpr std::size_t most_rays = 16384;  // half a second of measuring

}  // namespace

nlohmann::ordered_json adaptor_cost(const Geometry& geometry, const RayStream& stream,
                                    int repetitions) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    const auto rays = std::span(stream.rays).first(std::min(stream.size(), most_rays));
    for (const DirectRow& row : measure_direct(geometry, stream.batch_kind, rays, repetitions)) {
        if (row.query != stream.question) continue;
        rows.push_back(
            {{"scene", stream.scene},
             {"kind", name_of(stream.kind)},
             {"path", row.path},
             {"question", row.query == Query::closest ? "closest" : "occluded"},
             {"direct_mrays_per_second", row.direct_mrays},
             {"adaptor_mrays_per_second", row.adaptor_mrays},
             {"adaptor_to_direct",
              {{"median", row.ratio.median}, {"low", row.ratio.low}, {"high", row.ratio.high}}},
             {"differences", row.differences}});
    }
    return rows;
}

}  // namespace rayshoot
