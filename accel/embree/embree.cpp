#include "accel/embree/embree.h"

#include "accel/core/options.h"
#include "accel/embree/accel.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace embree {
namespace {

constexpr OptionInfo known_options[] = {
    {"kernel", "auto|single|packet|stream", "auto",
     "Embree's public path; auto: the fastest for each question and kind of ray"},
    {"quality", "low|medium|high", "medium", "RTC_BUILD_QUALITY of the scene"},
};

constexpr std::string_view configurations[] = {
    "embree",
    "embree:kernel=single",
    "embree:kernel=packet",
#if RTC_VERSION_MAJOR < 4
    "embree:kernel=stream",
#endif
    "embree:quality=low",
    "embree:quality=high",
};

Choice chosen_kernel(const Options& options) {
    const auto choice = options.choice<Choice>("kernel", {{"auto", Choice::automatic},
                                                          {"single", Choice::single},
                                                          {"packet", Choice::packet},
                                                          {"stream", Choice::stream}});
    if (choice == Choice::stream && !has_streams)
        throw std::invalid_argument("embree: kernel=stream: this build has Embree " +
                                    std::to_string(RTC_VERSION_MAJOR) +
                                    ", which has no streams; use kernel=packet");
    return choice;
}

RTCBuildQuality chosen_quality(const Options& options) {
    return options.choice<RTCBuildQuality>("quality", {{"low", RTC_BUILD_QUALITY_LOW},
                                                       {"medium", RTC_BUILD_QUALITY_MEDIUM},
                                                       {"high", RTC_BUILD_QUALITY_HIGH}});
}

std::unique_ptr<Accel> build(const BuildInput& input, const Options& options, std::string spec) {
    return std::make_unique<EmbreeAccel>(input.geometry, chosen_quality(options),
                                         chosen_kernel(options), std::move(spec));
}

std::string refuses(const Geometry& geometry) {
    const Box& box = geometry.bounds();
    for (int axis = 0; axis < 3 && geometry.size() > 0; ++axis)
        if (!(box.lo[axis] > -largest_coordinate && box.hi[axis] < largest_coordinate))
            return "Embree leaves out primitives with coordinates beyond 1.8e18; scale the scene";
    return {};
}

}  // namespace
}  // namespace embree

StructureEntry embree_entry() {
    return {.name = "embree",
            .agreement = Agreement::tolerance,
            .complete = true,
            .remembers = false,
            .options = embree::known_options,
            .configurations = embree::configurations,
            .summary =
                "Intel Embree: triangles and spheres natively, other primitives and Movers "
                "as user geometry through our own test",
            .build = embree::build,
            .refuses = embree::refuses};
}

std::string embree_description() { return embree::Device().description(); }

std::string embree_remark(const Geometry& geometry) {
    std::uint32_t others = 0;
    for (std::uint32_t i = 0; i < geometry.size(); ++i)
        others += embree::is_native(geometry.ref(i)) ? 0u : 1u;
    if (others == 0) return {};
    return std::to_string(others) + " of " + std::to_string(geometry.size()) +
           " primitives by our own test";
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
