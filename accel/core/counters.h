#pragma once

#include "accel/core/isa.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>

/// What is counted, defined once. Havran's (1999) names stand in brackets.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class Event : std::uint8_t {
    ray,                   ///< a ray answered (not declined)
    hit,                   ///< a ray answered with a hit
    object_test,           ///< [N_IT] a ray enters the shared test of one primitive
    object_hit,            ///< an object test that found a hit inside its primitive
    bounding_volume_test,  ///< one ray against one existing child or bound
    step,                  ///< [N_TS] a traversal step: one interior node or cell left behind
    cell,                  ///< [N_ETS] a leaf or elementary cell visited
    empty_cell,            ///< [N_EETS] of those, one without objects
    mailbox_skip,          ///< an object test saved because the ray had tested it before
    cache_hit,             ///< a ray answered by a remembered occluder or candidate set
    candidate_set,         ///< a candidate set built while tracing
    declined,              ///< a ray that a partial structure passed on
};
inline constexpr int event_count = 12;
inline constexpr std::array<std::string_view, event_count> event_names{
    "rays",  "hits",        "object_tests",  "object_hits", "bounding_volume_tests", "steps",
    "cells", "empty_cells", "mailbox_skips", "cache_hits",  "candidate_sets",        "declined"};

struct Counters {
    std::array<std::uint64_t, event_count> totals{};

    std::uint64_t operator[](Event e) const { return totals[static_cast<std::size_t>(e)]; }
    std::uint64_t& operator[](Event e) { return totals[static_cast<std::size_t>(e)]; }
    Counters& operator+=(const Counters& other) {
        for (std::size_t i = 0; i < totals.size(); ++i) totals[i] += other.totals[i];
        return *this;
    }
    bool operator==(const Counters&) const = default;
};

/// A counting policy. Work done only to count sits under `if constexpr (C::counts)`.
template <class C>
concept Counter = requires(C& count, Event e, std::uint64_t n) {
    { C::counts } -> std::convertible_to<bool>;
    count(e);
    count(e, n);
};

/// Counts into a Counters.
struct Tally {
    static constexpr bool counts = true;
    Counters* into;
    void operator()(Event e, std::uint64_t n = 1) const { (*into)[e] += n; }
};

/// Leaves no trace in the code.
struct Silent {
    static constexpr bool counts = false;
    constexpr void operator()(Event, std::uint64_t = 1) const {}
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
