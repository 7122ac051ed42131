#pragma once

#include "accel/core/catalogue.h"
#include "tests/contract/case.h"
#include "tests/contract/report.h"

/// What the contract demands, one function for each demand. Each writes what it finds into a
/// report.
namespace rayshoot::contract {

/// What a session made of a stream.
struct Answered {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> occluded;
};

/// Asks both questions about a whole stream, `batch_size` rays at a time. Answers are written into
/// memory full of rubbish; a write beyond the batch, or a ray declined, is a failure.
Answered ask(Session& session, const Stream& stream, std::size_t batch_size, Report& report,
             const std::string& where);

/// Every answer against the truth, bit for bit.
void compare(const Stream& stream, const Answered& answered, Report& report,
             const std::string& where);

/// Right in every mode and batch size, and on a session that has answered before.
void check_answers(const Accel& accel, const Case& tested, Report& report);

/// Counts add up, repeat, and stay with the kind of ray they belong to; invalid rays cost no test.
void check_counters(const Accel& accel, const Case& tested, Report& report);

/// Two sessions on two threads at once answer like one.
void check_threads(const Accel& accel, const Case& tested, Report& report);

/// Right as well when view, lights and hierarchy are absent.
void check_bare_input(const Catalogue& catalogue, const std::string& spec, const Case& tested,
                      Report& report);

/// The row name builds the same again, and what is said of the whole fits what is said of its
/// parts.
void check_description(const Catalogue& catalogue, const Accel& accel, const Case& tested,
                       Report& report);

}  // namespace rayshoot::contract
