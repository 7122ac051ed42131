#include "tracer/ray_counts.h"

namespace rayshoot {

RayCount RayCounts::of(RayKind kind) const {
    const RayCounts& all = *this;
    if (kind == RayKind::camera) return all[Cause::camera];
    if (kind == RayKind::shadow) return all[Cause::shadow];
    return {all[Cause::reflection].rays + all[Cause::refraction].rays,
            all[Cause::reflection].hits + all[Cause::refraction].hits};
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    for (std::size_t i = 0; i < by_cause.size(); ++i) {
        by_cause[i].rays += other.by_cause[i].rays;
        by_cause[i].hits += other.by_cause[i].hits;
    }
    totally_reflected += other.totally_reflected;
    return *this;
}

}  // namespace rayshoot
