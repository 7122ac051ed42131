#pragma once

#include "accel/embree/conversion.h"
#include "accel/simd/transpose.h"

/// Packets of rays, transposed: one array per component.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

/// The ray's part of a packet, which is all of it in the occluded question.
template <class Packet>
auto& ray_part(Packet& packet) {
    if constexpr (requires { packet.ray; }) return packet.ray;
    else return packet;
}

template <int Width, class Packet>
void prepare(Packet& packet) {
    auto& ray = ray_part(packet);
    for (int i = 0; i < Width; ++i) {
        ray.mask[i] = 0xffffffff;
        ray.id[i] = ray.flags[i] = 0;
    }
}

template <int Width, class Packet>
void load(const Ray* rays, Ends ends, Packet& packet) {
    auto& to = ray_part(packet);
    static_assert(offsetof(Ray, origin) == 0 && offsetof(Ray, t_min) == 12 &&
                  offsetof(Ray, direction) == 16 && offsetof(Ray, t_max) == 28);
    if constexpr (Width % 8 == 0) {
        for (int i = 0; i < Width; i += 8)
            transpose_8x8(reinterpret_cast<const std::byte*>(rays + i), sizeof(Ray),
                          {to.org_x + i, to.org_y + i, to.org_z + i, to.tnear + i, to.dir_x + i,
                           to.dir_y + i, to.dir_z + i, to.tfar + i});
    } else {
        for (int i = 0; i < Width; ++i) {
            to.org_x[i] = rays[i].origin.x;
            to.org_y[i] = rays[i].origin.y;
            to.org_z[i] = rays[i].origin.z;
            to.tnear[i] = rays[i].t_min;
            to.dir_x[i] = rays[i].direction.x;
            to.dir_y[i] = rays[i].direction.y;
            to.dir_z[i] = rays[i].direction.z;
            to.tfar[i] = rays[i].t_max;
        }
    }
    for (int i = 0; i < Width; ++i) to.time[i] = rays[i].time;
    for (int i = 0; i < Width; ++i) to.tnear[i] = ends.near(to.tnear[i]);
    for (int i = 0; i < Width; ++i) to.tfar[i] = Ends::far(to.tfar[i]);
    if constexpr (requires { packet.hit; })
        for (int i = 0; i < Width; ++i) packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
}

template <int Width, class Packet>
void answer(const Scene&, const Packet& packet, std::uint8_t* occluded) {
    for (int i = 0; i < Width; ++i) occluded[i] = packet.tfar[i] == -infinity;
}
template <int Width, class Packet>
void answer(const Scene& scene, const Packet& packet, Hit* hits) {
    const auto& hit = packet.hit;
    // Two words at once, which compilers interleave better than four.
    const auto pair = [](std::uint32_t low, std::uint32_t high) {
        return low | static_cast<std::uint64_t>(high) << 32;
    };
    std::array<std::uint64_t, 2 * Width> words;
    for (int i = 0; i < Width; ++i) {
        const Hit one =
            hit_of(packet.ray.tfar[i], hit.geomID[i], hit.primID[i], hit.u[i], hit.v[i]);
        words[static_cast<std::size_t>(2 * i)] =
            pair(std::bit_cast<std::uint32_t>(one.t), one.primitive);
        words[static_cast<std::size_t>(2 * i + 1)] =
            pair(std::bit_cast<std::uint32_t>(one.u), std::bit_cast<std::uint32_t>(one.v));
    }
    std::memcpy(static_cast<void*>(hits), words.data(), sizeof words);
    if (scene.same_numbers()) return;
    for (int i = 0; i < Width; ++i)
        if (hits[i].primitive != no_primitive)
            hits[i].primitive = scene.primitive(hit.geomID[i], hits[i].primitive);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
