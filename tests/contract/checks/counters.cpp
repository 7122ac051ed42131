#include "tests/contract/checks/checks.h"

#include <algorithm>

namespace rayshoot::contract {
namespace {

constexpr std::array<RayKind, ray_kinds> kinds{RayKind::camera, RayKind::shadow,
                                               RayKind::secondary};

struct Counted {
    std::unique_ptr<Session> session;
    Answered answered;
};

Counted count(const Accel& accel, const Stream& stream, Report& report, const std::string& where) {
    Counted counted{accel.open(Mode::counting), {}};
    counted.answered = ask(*counted.session, stream, default_batch, report, where);
    return counted;
}

void require(bool holds, const std::string& claim, const Counters& counters, Report& report) {
    if (holds) return;
    std::string values;
    for (std::size_t i = 0; i < counters.totals.size(); ++i)
        values.append(" ")
            .append(event_names[i])
            .append("=")
            .append(std::to_string(counters.totals[i]));
    report.fail(claim + " does not hold:" + values);
}

/// Both questions were asked about every ray of the stream.
void check_totals(const Counters& counters, const Stream& stream, Report& report,
                  const std::string& where) {
    const auto missed = [](const Hit& hit) { return hit.primitive == no_primitive; };
    const auto hits = stream.size() - static_cast<std::size_t>(std::count_if(
                                          stream.truth.begin(), stream.truth.end(), missed));
    const auto want = [&](bool holds, const char* claim) {
        require(holds, where + ": " + claim, counters, report);
    };
    want(counters[Event::ray] == 2 * stream.size(), "rays == rays asked");
    want(counters[Event::hit] == 2 * hits, "hits == rays that hit");
    want(counters[Event::declined] == 0, "declined == 0");
    want(counters[Event::object_hit] >= counters[Event::hit], "object_hits >= hits");
    want(counters[Event::object_test] >= counters[Event::object_hit],
         "object_tests >= object_hits");
    want(counters[Event::cell] >= counters[Event::empty_cell], "cells >= empty_cells");
}

/// `rays` means answered, so members add up to the whole; what one declines the next is asked.
void check_members(const Session& whole, RayKind kind, Report& report, const std::string& where) {
    if (whole.members().empty()) return;
    Counters sum;
    for (const auto& member : whole.members())
        if (const Counters* part = member->counters(kind)) sum += *part;
    Counters expected = *whole.counters(kind);
    sum[Event::declined] = expected[Event::declined] = 0;
    require(sum == expected, where + ": members add up to the whole", expected, report);
}

void check_invalid_rays(const Accel& accel, const Stream& hard, Report& report,
                        const std::string& where) {
    Stream invalid{.name = "invalid rays", .kind = hard.kind, .rays = invalid_rays()};
    invalid.families.assign(invalid.size(), "invalid");
    invalid.truth.assign(invalid.size(), Hit{});
    const Counted counted = count(accel, invalid, report, where);
    compare(invalid, counted.answered, report, where + ", invalid rays only");
    const Counters* counters = counted.session->counters(invalid.kind);
    if (counters == nullptr) return;
    require((*counters)[Event::object_test] == 0 && (*counters)[Event::bounding_volume_test] == 0,
            where + ": invalid rays cost no test", *counters, report);
}

}  // namespace

void check_counters(const Accel& accel, const Case& tested, Report& report) {
    const std::string where = accel.spec() + " on " + tested.name();
    if (accel.open(Mode::timing)->counters(RayKind::secondary) != nullptr)
        report.fail(where + ": has counters while timing");
    for (const Stream& stream : tested.streams) {
        const std::string what = where + ", " + stream.name;
        const Counted counted = count(accel, stream, report, what);
        const Counters* counters = counted.session->counters(stream.kind);
        if (counters == nullptr) continue;
        check_totals(*counters, stream, report, what);
        check_members(*counted.session, stream.kind, report, what);
        const Counted again = count(accel, stream, report, what);
        require(*again.session->counters(stream.kind) == *counters,
                what + ": a second session counts the same", *counters, report);
        for (const RayKind kind : kinds)
            if (kind != stream.kind)
                require(*counted.session->counters(kind) == Counters{},
                        what + ": other kinds of rays count nothing",
                        *counted.session->counters(kind), report);
    }
    check_invalid_rays(accel, tested.hard_rays(), report, where);
}

}  // namespace rayshoot::contract
