#include "bench/gate/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rayshoot {
namespace {

float largest_coordinate(const Geometry& geometry, const Ray& ray) {
    float largest = 0;
    const Box& box = geometry.bounds();
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max(
            {largest, std::abs(box.lo[axis]), std::abs(box.hi[axis]), std::abs(ray.origin[axis])});
    }
    return largest;
}

/// A unit vector across `direction`.
vec3 across(const vec3& direction) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < std::abs(direction[least])) least = axis;
    }
    vec3 axis{0};
    axis[least] = 1;
    return normalised(cross(direction, axis));
}

/// The ray moved sideways, tilted, pushed along itself, and with its limits moved.
std::vector<Ray> neighbours(const Ray& ray, float shift) {
    const float size = length(ray.direction);
    const vec3 right = across(ray.direction / size);
    const vec3 up = cross(ray.direction / size, right);
    std::vector<Ray> rays;
    for (const vec3& side :
         std::array{right, -right, up, -up, normalised(right + up), normalised(right - up),
                    -normalised(right + up), normalised(up - right)}) {
        Ray moved = ray;
        moved.origin += shift * side;
        rays.push_back(moved);
        moved = ray;
        moved.direction += ambiguous_shift * size * side;
        rays.push_back(moved);
    }
    for (const float way : {-1.0f, 1.0f}) {
        Ray moved = ray;
        moved.origin += way * shift * (ray.direction / size);
        rays.push_back(moved);
        moved = ray;
        moved.t_min += way * (shift / size + ambiguous_shift * std::abs(ray.t_min));
        moved.t_max += way * -(shift / size + ambiguous_shift * std::abs(ray.t_max));
        if (!std::isfinite(ray.t_max)) moved.t_max = ray.t_max;
        rays.push_back(moved);
    }
    return rays;
}

bool same_place(const Hit& a, const Hit& b, float least) {
    if ((a.primitive == no_primitive) != (b.primitive == no_primitive)) return false;
    if (a.primitive == no_primitive) return true;
    const float larger = std::max(std::abs(a.t), std::abs(b.t));
    return std::abs(a.t - b.t) <= std::max(least, t_tolerance * larger);
}

class Judge {
public:
    Judge(const Accel& reference, const Geometry& geometry, const RayStream& stream)
        : session_(reference.open(Mode::timing)), geometry_(geometry), stream_(stream) {}

    bool agrees(const Ray& ray, const StreamAnswers& expected, std::size_t i,
                const StreamAnswers& found, std::size_t j) const {
        if (found.hits.empty()) return expected.occluded[i] == found.occluded[j];
        return same_place(expected.hits[i], found.hits[j], least_t(ray));
    }

    /// Whether the reference gives the found answer for a neighbour of ray j.
    bool ambiguous(const StreamAnswers& found, std::size_t j) {
        const Ray& ray = stream_.rays[j];
        if (!answerable(ray)) return false;
        const auto rays = neighbours(ray, ambiguous_shift * largest_coordinate(geometry_, ray));
        const RayBatch batch{RayKind::secondary, stream_.depth, rays, {}};
        if (found.hits.empty()) {
            std::vector<std::uint8_t> bits(rays.size());
            session_->occluded(batch, bits);
            return std::count(bits.begin(), bits.end(), found.occluded[j]) > 0;
        }
        std::vector<Hit> hits(rays.size());
        session_->closest(batch, hits);
        return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
            return same_place(hit, found.hits[j], least_t(ray));
        });
    }

private:
    float least_t(const Ray& ray) const {
        return ambiguous_shift * largest_coordinate(geometry_, ray) / length(ray.direction);
    }

    std::unique_ptr<Session> session_;
    const Geometry& geometry_;
    const RayStream& stream_;
};

}  // namespace

ToleranceResult tolerance_differences(const Accel& reference, const Geometry& geometry,
                                      const RayStream& stream, const StreamAnswers& expected,
                                      const StreamAnswers& found,
                                      const std::vector<std::size_t>& chosen) {
    Judge judge(reference, geometry, stream);
    ToleranceResult result;
    for (std::size_t j = 0; j < stream.size(); ++j) {
        const std::size_t i = chosen.empty() ? j : chosen[j];
        if (judge.agrees(stream.rays[j], expected, i, found, j)) continue;
        if (judge.ambiguous(found, j)) {
            ++result.ambiguous;
        } else if (result.unexplained.count++ == 0) {
            result.unexplained.first =
                difference_at(stream, j, describe_answer(expected, i), describe_answer(found, j));
            result.unexplained.first->ray = i;
        }
    }
    return result;
}

}  // namespace rayshoot
