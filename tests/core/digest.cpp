#include "tests/core/digest.h"

#include <bit>

#include "accel/core/leaves.h"
#include "tests/core/cases.h"

namespace rayshoot {
namespace {

class Fnv {
public:
    void add(std::uint32_t word) {
        for (int byte = 0; byte < 4; ++byte) {
            hash_ ^= word >> (8 * byte) & 0xff;
            hash_ *= 0x100000001b3;
        }
    }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

template <class Make>
std::uint64_t digest_of(Make&& make, Precision precision) {
    cases::Random random(97);
    Fnv fnv;
    for (int hits = 0; hits < digested_hits;) {
        const auto shape = make(random);
        Geometry geometry;
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Triangle>)
            geometry = cases::alone(shape, precision);
        else geometry = cases::alone(shape);
        const double size = cases::diagonal(geometry.bounds());
        for (int i = 0; i < 20; ++i) {
            const Ray ray = cases::ray_at(cases::spot_on(shape, random), size, random);
            Hit hit = nothing_yet(ray);
            Silent silent;
            if (answerable(ray)) test_primitive<Query::closest>(geometry, 0, ray, hit, silent);
            if (hit.primitive == no_primitive) continue;
            ++hits;
            for (const float number : {hit.t, hit.u, hit.v})
                fnv.add(std::bit_cast<std::uint32_t>(number));
        }
    }
    return fnv.value();
}

}  // namespace

std::uint64_t hit_digest(PrimitiveKind kind, Precision precision) {
    switch (kind) {
        case PrimitiveKind::triangle:
            return digest_of(cases::triangle, precision);
        case PrimitiveKind::sphere:
            return digest_of(cases::sphere, precision);
        case PrimitiveKind::frustum:
            return digest_of(cases::frustum, precision);
        case PrimitiveKind::polygon:
            break;
    }
    return digest_of(cases::polygon, precision);
}

}  // namespace rayshoot
