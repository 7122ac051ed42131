#pragma once

#include "accel/core/ray.h"

#if RAYSHOOT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstddef>
#include <type_traits>

/// The part of Embree's API that is spelled differently in its versions 3 and 4: asking.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

/// Version 4 has no streams.
inline constexpr bool has_streams = RTC_VERSION_MAJOR < 4;

/// A promise that Embree's kernels are tuned by: neighbouring rays take similar paths, or not.
enum class Coherence : std::uint8_t { incoherent, coherent };

/// The record of one ray: in the occluded question it has no room for a hit.
template <Query Q>
using Record = std::conditional_t<Q == Query::closest, RTCRayHit, RTCRay>;

template <int Width>
struct PacketTypes;
template <>
struct PacketTypes<4> {
    using Closest = RTCRayHit4;
    using Occluded = RTCRay4;
};
template <>
struct PacketTypes<8> {
    using Closest = RTCRayHit8;
    using Occluded = RTCRay8;
};
template <>
struct PacketTypes<16> {
    using Closest = RTCRayHit16;
    using Occluded = RTCRay16;
};
template <Query Q, int Width>
using Packet = std::conditional_t<Q == Query::closest, typename PacketTypes<Width>::Closest,
                                  typename PacketTypes<Width>::Occluded>;

/// Asks a committed scene. The type of the record is the question, as in Embree.
/// `valid`: aligned to the packet's size; -1 for the lanes that count, else 0.
class Asker {
public:
#if RTC_VERSION_MAJOR >= 4
    Asker(RTCScene scene, Coherence coherence) : scene_(scene) {
        const RTCRayQueryFlags flags = coherence == Coherence::coherent
                                           ? RTC_RAY_QUERY_FLAG_COHERENT
                                           : RTC_RAY_QUERY_FLAG_INCOHERENT;
        rtcInitIntersectArguments(&closest_);
        rtcInitOccludedArguments(&occluded_);
        closest_.flags = flags;
        occluded_.flags = flags;
    }
    void ask(RTCRayHit* ray) { rtcIntersect1(scene_, ray, &closest_); }
    void ask(RTCRay* ray) { rtcOccluded1(scene_, ray, &occluded_); }
    void ask(const int* valid, RTCRayHit4* rays) { rtcIntersect4(valid, scene_, rays, &closest_); }
    void ask(const int* valid, RTCRay4* rays) { rtcOccluded4(valid, scene_, rays, &occluded_); }
    void ask(const int* valid, RTCRayHit8* rays) { rtcIntersect8(valid, scene_, rays, &closest_); }
    void ask(const int* valid, RTCRay8* rays) { rtcOccluded8(valid, scene_, rays, &occluded_); }
    void ask(const int* valid, RTCRayHit16* rays) {
        rtcIntersect16(valid, scene_, rays, &closest_);
    }
    void ask(const int* valid, RTCRay16* rays) { rtcOccluded16(valid, scene_, rays, &occluded_); }

    /// Ray by ray: slower, not wrong. The option that asks for streams is refused.
    template <class Record>
    void ask_stream(Record* first, std::size_t count) {
        for (Record* record = first; record != first + count; ++record) ask(record);
    }

private:
    RTCScene scene_;
    RTCIntersectArguments closest_;
    RTCOccludedArguments occluded_;
#else
    Asker(RTCScene scene, Coherence coherence) : scene_(scene) {
        rtcInitIntersectContext(&context_);
        context_.flags = coherence == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                          : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    void ask(RTCRayHit* ray) { rtcIntersect1(scene_, &context_, ray); }
    void ask(RTCRay* ray) { rtcOccluded1(scene_, &context_, ray); }
    void ask(const int* valid, RTCRayHit4* rays) { rtcIntersect4(valid, scene_, &context_, rays); }
    void ask(const int* valid, RTCRay4* rays) { rtcOccluded4(valid, scene_, &context_, rays); }
    void ask(const int* valid, RTCRayHit8* rays) { rtcIntersect8(valid, scene_, &context_, rays); }
    void ask(const int* valid, RTCRay8* rays) { rtcOccluded8(valid, scene_, &context_, rays); }
    void ask(const int* valid, RTCRayHit16* rays) {
        rtcIntersect16(valid, scene_, &context_, rays);
    }
    void ask(const int* valid, RTCRay16* rays) { rtcOccluded16(valid, scene_, &context_, rays); }

    void ask_stream(RTCRayHit* first, std::size_t count) {
        rtcIntersect1M(scene_, &context_, first, static_cast<unsigned>(count), sizeof(RTCRayHit));
    }
    void ask_stream(RTCRay* first, std::size_t count) {
        rtcOccluded1M(scene_, &context_, first, static_cast<unsigned>(count), sizeof(RTCRay));
    }

private:
    RTCScene scene_;
    RTCIntersectContext context_;
#endif
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
