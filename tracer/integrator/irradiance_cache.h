#pragma once

#include "accel/core/vec.h"

#include <memory>
#include <optional>
#include <span>

/// Irradiance at scattered points, interpolated in between: Ward, Rubinstein & Clear 1988.
namespace rayshoot {

struct IrradianceRecord {
    vec3 position{0};
    vec3 normal{0, 0, 1};  ///< unit, on the lit side
    vec3 irradiance{0};    ///< indirect: of light that another surface sent
    float distance = 1;    ///< harmonic mean of the distances to those surfaces, scene units
};

class IrradianceCache {
public:
    /// `error`: what an interpolated irradiance may be off by, as a share, by Ward's estimate; more
    /// than 0, at most 1.
    explicit IrradianceCache(float error);
    ~IrradianceCache();
    IrradianceCache(IrradianceCache&&) noexcept;
    IrradianceCache& operator=(IrradianceCache&&) noexcept;

    void insert(const IrradianceRecord& record);
    /// The mean of the records that are good for this point, weighed by the inverse of their
    /// estimated error |x - x_i| / R_i + sqrt(1 - n n_i); empty when there is none.
    std::optional<vec3> irradiance(const vec3& position, const vec3& normal) const;

    std::size_t size() const;
    std::span<const IrradianceRecord> records() const;

private:
    class Places;
    std::unique_ptr<Places> places_;
};

}  // namespace rayshoot
