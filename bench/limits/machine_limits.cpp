#include "bench/limits/machine_limits.h"

#include "bench/limits/probe_memory.h"
#include "bench/output/machine.h"
#include "bench/statistics/random.h"
#include "bench/timing/clock.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <thread>

namespace rayshoot {
namespace {

constexpr std::size_t smallest_set = std::size_t{1} << 14;  // half of a small first-level cache
constexpr int loads = 1 << 20;
constexpr int tries = 3;  // what disturbs a try only slows it

/// The least of a few tries.
double least_seconds(auto&& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) least = std::min(least, work());
    return least;
}

/// Additions that wait for each other take a cycle each.
std::optional<double> cycles_per_ns() {
#if defined(__x86_64__) || defined(__aarch64__)
    constexpr int rounds = 1 << 18, additions = 64;
    const double seconds = least_seconds([] {
        std::uint64_t sum = 0;
        const std::uint64_t step = 3;
        const Stopwatch watch;
        for (int i = 0; i < rounds; ++i) {
#if defined(__x86_64__)
            asm volatile(".rept 64\n\tadd %1, %0\n\t.endr" : "+r"(sum) : "r"(step) : "cc");
#else
            asm volatile(".rept 64\n\tadd %0, %0, %1\n\t.endr" : "+r"(sum) : "r"(step));
#endif
        }
        return watch.seconds();
    });
    return 1e-9 * rounds * additions / seconds;
#else
    return std::nullopt;
#endif
}

/// A single cycle through all lines in random order (Sattolo 1986).
void link(std::span<CacheLine> lines) {
    std::vector<std::uint32_t> order(lines.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    Sequence random(1);
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i)]);
    for (std::size_t i = 0; i < order.size(); ++i) lines[i].next = &lines[order[i]];
}

double seconds_of_dependent_loads(const CacheLine* at) {
    const Stopwatch watch;
    for (int i = 0; i < loads; ++i) at = at->next;
    const double seconds = watch.seconds();
    asm volatile("" : : "r"(at));
    return seconds;
}

bool affordable(std::size_t bytes) { return 2 * bytes <= available_memory(); }

std::optional<double> latency_ns(std::size_t bytes, Pages pages) {
    if (!affordable(bytes)) return std::nullopt;
    const ProbeMemory memory(bytes / sizeof(CacheLine), pages);
    if (!memory.granted()) return std::nullopt;
    link(memory.lines());
    const CacheLine* start = memory.lines().data();
    return 1e9 / loads * least_seconds([&] { return seconds_of_dependent_loads(start); });
}

/// Random lines, none of which has to wait for another. `lines.size()` is a power of two.
void load_independently(std::span<const CacheLine> lines, std::uint64_t seed) {
    Sequence random(seed);
    std::uintptr_t sum = 0;
    for (int i = 0; i < loads; ++i) {
        const CacheLine& line = lines[random.next() & (lines.size() - 1)];
        sum += reinterpret_cast<std::uintptr_t>(line.next);
    }
    asm volatile("" : : "r"(sum));
}

double seconds_of_independent_loads(std::span<const CacheLine> lines, int threads) {
    std::atomic<int> waiting{threads};
    const auto lane = [&](int number) {
        --waiting;
        while (waiting > 0) {
        }
        load_independently(lines, static_cast<std::uint64_t>(number) + 1);
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(lane, i);
    while (waiting > 1) {
    }
    const Stopwatch watch;
    lane(0);
    for (std::thread& other : others) other.join();
    return watch.seconds();
}

std::optional<double> million_lines_per_second(std::size_t bytes, Pages pages, int threads) {
    if (!affordable(bytes) || threads > processor_count()) return std::nullopt;
    const ProbeMemory memory(bytes / sizeof(CacheLine), pages);
    if (!memory.granted()) return std::nullopt;
    const double seconds =
        least_seconds([&] { return seconds_of_independent_loads(memory.lines(), threads); });
    return 1e-6 * loads * threads / seconds;
}

}  // namespace

std::optional<double> MachineLimits::latency_at(std::size_t bytes) const {
    for (const Latency& row : latency) {
        if (row.bytes >= bytes) return row.large_pages ? row.large_pages : row.small_pages;
    }
    return std::nullopt;
}

MachineLimits measure_machine(std::size_t largest) {
    MachineLimits limits;
    limits.cycles_per_ns = cycles_per_ns();
    for (std::size_t bytes = smallest_set; bytes <= largest; bytes *= 4) {
        limits.latency.push_back(
            {bytes, latency_ns(bytes, Pages::small), latency_ns(bytes, Pages::large)});
        limits.throughput_bytes = bytes;
    }
    for (const int threads : {1, 2}) {
        if (limits.throughput_bytes == 0) break;
        limits.throughput.push_back(
            {threads, million_lines_per_second(limits.throughput_bytes, Pages::small, threads),
             million_lines_per_second(limits.throughput_bytes, Pages::large, threads)});
    }
    return limits;
}

}  // namespace rayshoot
