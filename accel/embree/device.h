#pragma once

#include "accel/embree/rtc.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

/// An Embree device: pinned to our instruction set, errors turned into exceptions, memory counted.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

#define RAYSHOOT_TEXT_OF(name) #name
#define RAYSHOOT_TEXT(macro) RAYSHOOT_TEXT_OF(macro)
inline constexpr std::string_view our_isa = RAYSHOOT_TEXT(RAYSHOOT_ISA);
#undef RAYSHOOT_TEXT
#undef RAYSHOOT_TEXT_OF

/// Rays per packet: as many as our instruction set's registers hold.
inline constexpr int packet_width = our_isa == "avx512" ? 16 : our_isa == "baseline" ? 4 : 8;

class Device {
public:
    /// Throws std::runtime_error when this machine lacks the instruction set.
    Device();
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    RTCDevice handle() const { return device_; }
    /// Bytes that Embree holds now for everything made with this device.
    std::int64_t bytes() const { return bytes_; }
    /// Throws std::runtime_error with Embree's own words if any call since construction failed.
    void require_success() const;
    /// Embree's version and the instruction set asked for, next to ours.
    std::string description() const;

private:
    static void on_error(void* self, RTCError code, const char* text);
    static bool on_memory(void* self, ssize_t bytes, bool after);

    RTCDevice device_ = nullptr;
    std::atomic<std::int64_t> bytes_ = 0;
    std::string error_;  ///< the first one
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
