#include "tracer/integrator/irradiance_cache.h"

#include <algorithm>
#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayshoot {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<float, 3, bg::cs::cartesian>;
using Region = bg::model::box<Point>;

Point point(const vec3& p) { return {p.x, p.y, p.z}; }

/// A record in front of the point sees what the point does not: by how much, as a share of R_i,
/// the mean of both normals may say so before it is left out (Ward, Rubinstein & Clear 1988).
constexpr float in_front = -0.01f;

/// Ward's estimate of the relative error of using `record` at a point.
float estimated_error(const IrradianceRecord& record, const vec3& position, const vec3& normal) {
    const float turned = std::sqrt(std::max(0.0f, 1 - dot(normal, record.normal)));
    return length(position - record.position) / record.distance + turned;
}

bool is_in_front(const IrradianceRecord& record, const vec3& position, const vec3& normal) {
    const vec3 mean = 0.5f * (normal + record.normal);
    return dot(position - record.position, mean) < in_front * record.distance;
}

}  // namespace

/// Records by the region in which they may be good for something.
class IrradianceCache::Places {
public:
    explicit Places(float error) : error_(error) {}

    void insert(const IrradianceRecord& record) {
        const vec3 reach(error_ * record.distance);
        regions_.insert({Region(point(record.position - reach), point(record.position + reach)),
                         static_cast<std::uint32_t>(records_.size())});
        records_.push_back(record);
    }

    std::optional<vec3> irradiance(const vec3& position, const vec3& normal) const {
        // In the order of insertion, whatever the tree's: sums have the same bits.
        std::vector<std::uint32_t> near;
        for (auto found = regions_.qbegin(bg::index::covers(point(position)));
             found != regions_.qend(); ++found)
            near.push_back(found->second);
        std::ranges::sort(near);
        vec3 sum(0);
        float weights = 0;
        for (const std::uint32_t i : near) {
            const IrradianceRecord& record = records_[i];
            const float error = estimated_error(record, position, normal);
            if (!(error < error_) || is_in_front(record, position, normal)) continue;
            const float weight = 1 / std::max(error, least_error);
            sum += record.irradiance * weight;
            weights += weight;
        }
        if (!(weights > 0)) return std::nullopt;
        return sum / weights;
    }
    const std::vector<IrradianceRecord>& records() const { return records_; }

private:
    static constexpr float least_error = 1e-6f;  ///< at a record itself

    float error_;
    std::vector<IrradianceRecord> records_;
    bg::index::rtree<std::pair<Region, std::uint32_t>, bg::index::quadratic<16>> regions_;
};

IrradianceCache::IrradianceCache(float error) {
    if (!(error > 0 && error <= 1)) {
        throw std::invalid_argument("error of the irradiance cache " + std::to_string(error) +
                                    ": must be more than 0, at most 1");
    }
    places_ = std::make_unique<Places>(error);
}
IrradianceCache::~IrradianceCache() = default;
IrradianceCache::IrradianceCache(IrradianceCache&&) noexcept = default;
IrradianceCache& IrradianceCache::operator=(IrradianceCache&&) noexcept = default;

void IrradianceCache::insert(const IrradianceRecord& record) { places_->insert(record); }

std::optional<vec3> IrradianceCache::irradiance(const vec3& position, const vec3& normal) const {
    return places_->irradiance(position, normal);
}

std::size_t IrradianceCache::size() const { return places_->records().size(); }

std::span<const IrradianceRecord> IrradianceCache::records() const { return places_->records(); }

}  // namespace rayshoot
