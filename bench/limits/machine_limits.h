#pragma once

#include <cstddef>
#include <optional>
#include <vector>

/// What this machine allows, whatever the structure: clock, memory latency, memory throughput.
namespace rayshoot {

struct Latency {
    std::size_t bytes = 0;                           ///< of the working set
    std::optional<double> small_pages, large_pages;  ///< ns per dependent load
};

struct Throughput {
    int threads = 1;
    std::optional<double> small_pages,
        large_pages;  ///< million independent random lines per second
};

struct MachineLimits {
    std::optional<double> cycles_per_ns;  ///< none on a processor whose addition is not known here
    std::vector<Latency> latency;         ///< by growing working set
    std::size_t throughput_bytes = 0;     ///< of the working set
    std::vector<Throughput> throughput;

    /// ns per dependent load in the smallest working set measured that holds `bytes`, on large
    /// pages where they were granted; nothing beyond the largest.
    std::optional<double> latency_at(std::size_t bytes) const;
};

/// Working sets of 16 KiB, 64 KiB, ... up to `largest` bytes; those for which there is no memory
/// are not measured. A few seconds with 1 GiB. Each number is the best of three.
MachineLimits measure_machine(std::size_t largest);

}  // namespace rayshoot
