#include "tests/contract/checks/checks.h"

#include <array>
#include <thread>

namespace rayshoot::contract {
namespace {

/// One lane's work: the stream in its own batch size, on its own session.
void run_lane(const Accel& accel, const Stream& stream, std::size_t batch_size, Report& report,
              const std::string& where) {
    const auto session = accel.open(Mode::timing);
    compare(stream, ask(*session, stream, batch_size, report, where), report, where);
}

}  // namespace

void check_threads(const Accel& accel, const Case& tested, Report& report) {
    const std::string where = accel.spec() + " on " + tested.name() + ", two threads";
    std::array<Report, 2> lanes;
    {
        std::jthread other([&] { run_lane(accel, tested.hard_rays(), 131, lanes[0], where); });
        run_lane(accel, tested.hard_rays(), 256, lanes[1], where);
    }
    for (const Report& lane : lanes) report += lane;
}

void check_bare_input(const Catalogue& catalogue, const std::string& spec, const Case& tested,
                      Report& report) {
    const std::string where = spec + " on " + tested.name() + ", without view, lights, hierarchy";
    const auto accel = build(catalogue, spec, {tested.scene.geometry});
    const auto session = accel->open(Mode::counting);
    for (const Stream& stream : tested.streams)
        compare(stream, ask(*session, stream, default_batch, report, where), report, where);
}

void check_description(const Catalogue& catalogue, const Accel& accel, const Case& tested,
                       Report& report) {
    const std::string where = accel.spec() + " on " + tested.scene.name;
    const auto again = build(catalogue, accel.spec(), tested.scene.input());
    if (again->spec() != accel.spec())
        report.fail(where + ": its spec builds '" + again->spec() + "'");
    if (!accel.complete()) report.fail(where + ": says it is not complete");
    for (const Query query : {Query::closest, Query::occluded})
        for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary})
            if (!accel.serves(query, kind))
                report.fail(where + ": does not serve every kind of ray");
    const Footprint footprint = accel.footprint(), repeated = again->footprint();
    if (footprint.bytes != repeated.bytes || footprint.references != repeated.references ||
        footprint.leaves != repeated.leaves || footprint.interior != repeated.interior)
        report.fail(where + ": built twice, it has two footprints");
    if (footprint.empty_leaves.value_or(0) > footprint.leaves.value_or(0))
        report.fail(where + ": more empty leaves than leaves");
}

}  // namespace rayshoot::contract
