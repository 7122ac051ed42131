#include "accel/core/catalogue.h"

#include "accel/core/options.h"
#include "accel/core/overlay.h"

#include <algorithm>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// "bvh:leaf=4" in its two parts.
struct SpecPart {
    std::string_view name, options;
};

std::vector<SpecPart> parts(std::string_view spec) {
    std::vector<SpecPart> parts;
    for (std::size_t from = 0; from <= spec.size();) {
        const std::size_t plus = std::min(spec.find('+', from), spec.size());
        const std::string_view part = spec.substr(from, plus - from);
        const std::size_t colon = part.find(':');
        if (colon + 1 == part.size())
            throw std::invalid_argument("structure '" + std::string(spec) +
                                        "': no options after ':'");
        parts.push_back({part.substr(0, colon), colon == std::string_view::npos
                                                    ? std::string_view{}
                                                    : part.substr(colon + 1)});
        from = plus + 1;
    }
    return parts;
}

const StructureEntry& find(const Catalogue& catalogue, std::string_view name) {
    std::string names;
    for (const StructureEntry& entry : catalogue) {
        if (entry.name == name) return entry;
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw std::invalid_argument("no structure '" + std::string(name) + "'; there are " + names);
}

/// The last member answers everything, the others something.
void require_composable(std::string_view spec, const std::vector<const StructureEntry*>& members) {
    for (const StructureEntry* member : members) {
        const bool last = member == members.back();
        if (last && !member->complete)
            throw std::invalid_argument(
                "structure '" + std::string(spec) + "': " + std::string(member->name) +
                " answers only some rays; compose it with a complete one, as " + std::string(spec) +
                "+bvh");
        if (!last && member->complete)
            throw std::invalid_argument("structure '" + std::string(spec) +
                                        "': " + std::string(member->name) +
                                        " answers every ray, so nothing can follow it");
    }
}

}  // namespace

std::vector<const StructureEntry*> entries(const Catalogue& catalogue, std::string_view spec) {
    std::vector<const StructureEntry*> members;
    for (const SpecPart& part : parts(spec)) {
        members.push_back(&find(catalogue, part.name));
        Options(part.name, members.back()->options, part.options);
    }
    for (std::size_t i = 0; i + 1 < members.size(); ++i)
        if (std::count(members.begin(), members.end(), members[i]) > 1)
            throw std::invalid_argument("structure '" + std::string(spec) + "': " +
                                        std::string(members[i]->name) + " stands in it twice");
    require_composable(spec, members);
    return members;
}

std::unique_ptr<Accel> build(const Catalogue& catalogue, std::string_view spec,
                             const BuildInput& input) {
    const std::vector<const StructureEntry*> members = entries(catalogue, spec);
    const std::vector<SpecPart> texts = parts(spec);
    std::vector<std::unique_ptr<Accel>> accels;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (const std::string reason = members[i]->refuses(input.geometry); !reason.empty())
            throw std::invalid_argument("structure " + std::string(members[i]->name) + ": " +
                                        reason);
        const Options options(texts[i].name, members[i]->options, texts[i].options);
        accels.push_back(members[i]->build(input, options, options.canonical()));
    }
    return accels.size() == 1 ? std::move(accels.front()) : overlay(std::move(accels));
}

Agreement agreement(const Catalogue& catalogue, std::string_view spec) {
    const auto members = entries(catalogue, spec);
    const bool exact = std::all_of(
        members.begin(), members.end(),
        [](const StructureEntry* member) { return member->agreement == Agreement::exact; });
    return exact ? Agreement::exact : Agreement::tolerance;
}

std::string refusal(const Catalogue& catalogue, std::string_view spec, const Geometry& geometry) {
    for (const StructureEntry* member : entries(catalogue, spec))
        if (std::string reason = member->refuses(geometry); !reason.empty()) return reason;
    return {};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
