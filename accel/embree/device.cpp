#include "accel/embree/device.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA::embree {
namespace {

/// Embree's name of the same instruction set; left alone, it would take the machine's best.
constexpr std::string_view pinned_isa() {
#if defined(__aarch64__)
    return "neon";
#else
    if (our_isa == "avx512") return "avx512";
    if (our_isa == "avx2") return "avx2";
    if (our_isa == "fma") return "avx";
    return "sse2";
#endif
}

/// No `threads=`: Embree would cap the whole process for as long as any device lives. It builds on
/// oneTBB, so the caller's tbb::global_control bounds it as it bounds everything else.
std::string configuration() {
    return "set_affinity=0,start_threads=0,isa=" + std::string(pinned_isa());
}

}  // namespace

Device::Device() : device_(rtcNewDevice(configuration().c_str())) {
    if (device_ == nullptr)
        throw std::runtime_error("embree: no device for \"" + configuration() + "\" (error " +
                                 std::to_string(rtcGetDeviceError(nullptr)) +
                                 "): does this machine have the instruction set that the build "
                                 "is for? Build with the preset `portable` if not");
    rtcSetDeviceErrorFunction(device_, on_error, this);
    rtcSetDeviceMemoryMonitorFunction(device_, on_memory, this);
}

Device::~Device() { rtcReleaseDevice(device_); }

void Device::require_success() const {
    if (!error_.empty()) throw std::runtime_error("embree: " + error_);
}

std::string Device::description() const {
    const auto property = [&](RTCDeviceProperty name) {
        return std::to_string(rtcGetDeviceProperty(device_, name));
    };
    const bool wide = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED);
    const bool middle = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED);
    return "Embree " + property(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." +
           property(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
           property(RTC_DEVICE_PROPERTY_VERSION_PATCH) + ", isa=" + std::string(pinned_isa()) +
           " (native packets of " +
           (wide     ? "16"
            : middle ? "8"
                     : "4") +
           "; ours: " + std::string(our_isa) + ")";
}

void Device::on_error(void* self, RTCError code, const char* text) {
    std::string& error = static_cast<Device*>(self)->error_;
    if (error.empty()) error = std::string(text) + " (error " + std::to_string(code) + ")";
}

bool Device::on_memory(void* self, ssize_t bytes, bool) {
    static_cast<Device*>(self)->bytes_ += bytes;
    return true;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
