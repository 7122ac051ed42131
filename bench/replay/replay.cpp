#include "bench/replay/replay.h"

#include "bench/comparison/specimen.h"
#include "bench/streams/record.h"
#include "data/scenes.h"
#include "tracer/render.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rayshoot {
namespace {

/// Recorded numbers have six digits.
constexpr double recorded_accuracy = 1e-5;

void add(const Footprint& footprint, CountedByName& counted) {
    const auto put = [&](const char* name, const std::optional<std::uint64_t>& value) {
        counted[name] = value ? static_cast<double>(*value) : std::nan("");
    };
    put("interior", footprint.interior);
    put("leaves", footprint.leaves);
    put("empty_leaves", footprint.empty_leaves);
    put("references", footprint.references);
    put("depth", footprint.depth);
    put("bytes", footprint.bytes);
}

void add(const Counters& counters, CountedByName& counted) {
    for (std::size_t i = 0; i < event_count; ++i)
        counted[std::string(event_names[i])] += static_cast<double>(counters.totals[i]);
}

/// The names there are, so that measures can be checked before anything is counted.
const CountedByName& names() {
    static const CountedByName known = [] {
        CountedByName all;
        add(Footprint{}, all);
        add(Counters{}, all);
        return all;
    }();
    return known;
}

CountedByName count(const Scene& scene, const Accel& accel) {
    RenderSettings settings;
    settings.format = spd_format;
    settings.transport.rules = Rules::havran;
    settings.mode = Mode::counting;
    const RenderResult result = render(scene, accel, settings);
    CountedByName counted;
    for (int kind = 0; kind < ray_kinds; ++kind)
        if (const Counters* counters = result.session->counters(static_cast<RayKind>(kind)))
            add(*counters, counted);
    // A refracted ray that is totally reflected is a ray of his, though none is traced.
    counted["rays"] += static_cast<double>(result.counts.totally_reflected);
    add(accel.footprint(), counted);
    return counted;
}

ReplayVerdict judge(const PublishedNumber& published, double ours) {
    if (published.tolerance) {
        if (ours == published.value) return ReplayVerdict::exact;
        const double difference = std::abs(ours - published.value);
        return difference <= *published.tolerance * published.value ? ReplayVerdict::within
                                                                    : ReplayVerdict::off;
    }
    if (!published.ours) return ReplayVerdict::open;
    const bool same = std::abs(ours - *published.ours) <= recorded_accuracy * *published.ours;
    return same ? ReplayVerdict::pinned : ReplayVerdict::changed;
}

/// Calls `task`; what it throws for bad input is said to be wrong with a line of the table.
template <class Task>
auto blaming(const PublishedTable& table, std::size_t line, Task&& task) {
    try {
        return task();
    } catch (const std::invalid_argument& wrong) {
        refuse_line(table.path, line, wrong.what());
    }
}

/// Before anything is counted, which takes minutes.
void require_known(const Catalogue& catalogue, const PublishedTable& table) {
    for (const PublishedNumber& number : table.numbers)
        blaming(table, number.line, [&] {
            require_spec(catalogue, number.spec);
            return Measure(number.measure, names());
        });
}

}  // namespace

std::string_view verdict_name(ReplayVerdict verdict) {
    switch (verdict) {
        case ReplayVerdict::exact:
            return "exact";
        case ReplayVerdict::within:
            return "within";
        case ReplayVerdict::pinned:
            return "pinned";
        case ReplayVerdict::open:
            return "open";
        case ReplayVerdict::off:
            return "OFF";
        case ReplayVerdict::changed:
            break;
    }
    return "CHANGED";
}

std::size_t rebuilds(const PublishedTable& table) {
    std::set<std::pair<std::string, std::string>> different;
    for (const PublishedNumber& number : table.numbers)
        different.emplace(number.scene, number.spec);
    return different.size();
}

std::vector<ReplayedNumber> replay(const Catalogue& catalogue, const PublishedTable& table,
                                   const ReplayProgress& progress) {
    require_known(catalogue, table);
    std::map<std::string, Scene> scenes;
    std::map<std::pair<std::string, std::string>, CountedByName> counts;
    std::vector<ReplayedNumber> replayed;
    for (const PublishedNumber& number : table.numbers) {
        auto [counted, is_new] = counts.try_emplace({number.scene, number.spec});
        if (is_new) {
            if (progress) progress(number.scene, number.spec);
            counted->second = blaming(table, number.line, [&] {
                auto scene = scenes.find(number.scene);
                if (scene == scenes.end())
                    scene = scenes.emplace(number.scene, load_scene(number.scene)).first;
                const BuildInput input = build_input(scene->second, spd_format);
                return count(scene->second, *build(catalogue, number.spec, input));
            });
        }
        const double ours = Measure(number.measure, names()).of(counted->second);
        replayed.push_back({number, ours, judge(number, ours)});
    }
    return replayed;
}

}  // namespace rayshoot
