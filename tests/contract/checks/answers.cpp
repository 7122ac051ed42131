#include "tests/contract/checks/checks.h"

#include <algorithm>

namespace rayshoot::contract {
namespace {

constexpr Hit rubbish{-123.0f, 77, 7, 7};
constexpr std::uint8_t rubbish_bit = 0xaa;
constexpr std::size_t fence = 3;  // answers behind the batch that must stay rubbish

void require_none_declined(std::span<const std::uint32_t> declined, Report& report,
                           const std::string& where) {
    if (!declined.empty())
        report.fail(where + ": " + std::to_string(declined.size()) + " rays declined, the first " +
                    std::to_string(declined.front()) + " of its batch");
}

std::string described(const Stream& stream, std::size_t i, const std::string& where) {
    return where + ", " + stream.name + ", ray " + std::to_string(i) + " (" +
           std::string(stream.families[i]) + ") " + printed(stream.rays[i]);
}

}  // namespace

Answered ask(Session& session, const Stream& stream, std::size_t batch_size, Report& report,
             const std::string& where) {
    Answered answered;
    std::vector<Hit> hits;
    std::vector<std::uint8_t> bits;
    for (std::size_t first = 0; first < stream.size(); first += batch_size) {
        const std::size_t count = std::min(batch_size, stream.size() - first);
        const auto inside = static_cast<std::ptrdiff_t>(count);
        hits.assign(count + fence, rubbish);
        bits.assign(count + fence, rubbish_bit);
        const RayBatch batch = stream.batch(first, count);
        require_none_declined(session.closest(batch, std::span(hits).first(count)), report, where);
        require_none_declined(session.occluded(batch, std::span(bits).first(count)), report, where);
        if (std::count(hits.begin() + inside, hits.end(), rubbish) != fence ||
            std::count(bits.begin() + inside, bits.end(), rubbish_bit) != fence)
            report.fail(where + ": writes beyond its batch");
        answered.hits.insert(answered.hits.end(), hits.begin(), hits.begin() + inside);
        answered.occluded.insert(answered.occluded.end(), bits.begin(), bits.begin() + inside);
    }
    return answered;
}

void compare(const Stream& stream, const Answered& answered, Report& report,
             const std::string& where) {
    report.answers += 2 * stream.size();
    for (std::size_t i = 0; i < stream.size(); ++i) {
        const Hit& truth = stream.truth[i];
        if (!same_bits(answered.hits[i], truth))
            report.fail(described(stream, i, where) + ": closest gives " +
                        printed(answered.hits[i]) + ", brute force " + printed(truth));
        const std::uint8_t occluded = truth.primitive != no_primitive;
        if (answered.occluded[i] != occluded)
            report.fail(described(stream, i, where) + ": occluded gives " +
                        std::to_string(answered.occluded[i]) + ", brute force " + printed(truth));
    }
}

void check_answers(const Accel& accel, const Case& tested, Report& report) {
    const std::string where = accel.spec() + " on " + tested.name();
    const auto timing = accel.open(Mode::timing), counting = accel.open(Mode::counting);
    for (const Stream& stream : tested.streams)
        for (const auto& [session, mode] :
             {std::pair(timing.get(), ", timing"), std::pair(counting.get(), ", counting")})
            compare(stream, ask(*session, stream, default_batch, report, where + mode), report,
                    where + mode);
    // `timing` is warm now: asked again, in other sizes, it must not have learnt anything wrong.
    const auto check_batches = [&](const Stream& stream, std::size_t batch_size) {
        const std::string how = where + ", batches of " + std::to_string(batch_size);
        compare(stream, ask(*timing, stream, batch_size, report, how), report, how);
    };
    check_batches(tested.hard_rays(), 1);
    check_batches(tested.hard_rays(), 7);
    check_batches(repeated(tested.hard_rays(), max_batch + 3), max_batch);
    check_batches(tested.streams[1], 67);
    if (!timing->closest({}, {}).empty() || !timing->occluded({}, {}).empty())
        report.fail(where + ": declines rays of an empty batch");
}

}  // namespace rayshoot::contract
