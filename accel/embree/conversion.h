#pragma once

#include "accel/core/answers.h"
#include "accel/embree/scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>

/// Between our rays and hits and Embree's records. The loops have no branches and constant trip
/// counts, so that compilers turn them into SIMD.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

/// Turns our open interval into Embree's: t in [near(t_min), far(t_max)], for t_min >= 0.
struct Ends {
    std::uint32_t near_step;  ///< ulps
    float least_near;

    explicit Ends(const Scene& scene)
        : near_step(scene.takes_near_end() ? 1 : 0),
          least_near(scene.takes_near_end() ? std::numeric_limits<float>::min() : 0) {}

    float near(float t_min) const {
        const float next = std::bit_cast<float>(std::bit_cast<std::uint32_t>(t_min) + near_step);
        return least_near > next ? least_near : next;
    }
    static float far(float t_max) {
        return std::bit_cast<float>(std::bit_cast<std::uint32_t>(t_max) - 1);
    }
};

inline constexpr std::uint32_t bits_of_infinity = 0x7f800000;

/// Whether Embree can answer all these rays as they are: everything finite but t_max, t_min >= +0,
/// t_max no NaN. (Empty intervals and zero directions it answers rightly: no hit.)
inline bool all_plain(std::span<const Ray> rays) {
    // A ray is nine words, eight rays a whole number of SIMD registers. Each word is brought to a
    // form in which what is wrong is not below the bits of infinity.
    constexpr std::size_t group = 8, words = 9, t_min = 3, t_max = 7;
    static_assert(sizeof(Ray) == words * sizeof(std::uint32_t));
    using Words = std::array<std::uint32_t, group * words>;
    constexpr auto repeat = [](std::uint32_t usual, std::size_t special, std::uint32_t other) {
        Words all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i % words == special ? other : usual;
        return all;
    };
    constexpr Words mask =
        repeat(0x7fffffff, t_min, 0xffffffff);   // the sign matters in t_min alone
    constexpr Words less = repeat(0, t_max, 1);  // infinity is right in t_max alone
    Words largest{};
    const auto* bytes = reinterpret_cast<const std::byte*>(rays.data());
    const std::size_t whole = rays.size() - rays.size() % group;
    for (std::size_t first = 0; first < whole; first += group) {
        for (std::size_t i = 0; i < largest.size(); ++i) {
            std::uint32_t word;
            std::memcpy(&word, bytes + sizeof word * i, sizeof word);
            word = (word & mask[i]) - less[i];
            largest[i] = word > largest[i] ? word : largest[i];
        }
        bytes += group * sizeof(Ray);
    }
    std::uint32_t worst = 0;
    for (const std::uint32_t word : largest) worst = word > worst ? word : worst;
    for (const Ray& ray : rays.subspan(whole)) {
        const auto one = std::bit_cast<std::array<std::uint32_t, words>>(ray);
        for (std::size_t i = 0; i < words; ++i)
            worst = std::max(worst, (one[i] & mask[i]) - less[i]);
    }
    return worst < bits_of_infinity;
}

/// What never changes in a record: written once, when a session opens.
inline void prepare(RTCRay& ray) {
    ray.mask = 0xffffffff;
    ray.id = ray.flags = 0;
}
inline void prepare(RTCRayHit& record) {
    prepare(record.ray);
    record.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

/// Four words at a time where the layouts agree; what differs is written over.
inline void load(const Ray& ray, Ends ends, RTCRay& native) {
    static_assert(offsetof(Ray, t_min) == 12 && offsetof(RTCRay, tnear) == 12);
    static_assert(offsetof(Ray, direction) == 16 && offsetof(RTCRay, dir_x) == 16);
    std::memcpy(&native, &ray, 16);
    std::memcpy(reinterpret_cast<std::byte*>(&native) + 16,
                reinterpret_cast<const std::byte*>(&ray) + 16, 16);
    native.tnear = ends.near(ray.t_min);
    native.time = ray.time;
    native.tfar = Ends::far(ray.t_max);
}
inline void load(const Ray& ray, Ends ends, RTCRayHit& native) {
    load(ray, ends, native.ray);
    native.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

/// Embree marks an occluded ray by tfar = -infinity; far() never gives that.
inline void answer(const Scene&, std::span<const RTCRay> rays, std::uint8_t* occluded) {
    for (const RTCRay& ray : rays) *occluded++ = ray.tfar == -infinity;
}

/// A hit in Embree's numbers; what Embree leaves undefined on a miss is not taken over.
inline Hit hit_of(float t, unsigned geometry_id, unsigned primitive_id, float u, float v) {
    const bool missed = geometry_id == RTC_INVALID_GEOMETRY_ID;
    return {missed ? infinity : t, missed ? no_primitive : primitive_id, missed ? 0 : u,
            missed ? 0 : v};
}
inline void answer(const Scene& scene, std::span<const RTCRayHit> records, Hit* hits) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto& [ray, hit] = records[i];
        hits[i] = hit_of(ray.tfar, hit.geomID, hit.primID, hit.u, hit.v);
    }
    if (scene.same_numbers()) return;
    for (std::size_t i = 0; i < records.size(); ++i)
        if (hits[i].primitive != no_primitive)
            hits[i].primitive = scene.primitive(records[i].hit.geomID, hits[i].primitive);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
