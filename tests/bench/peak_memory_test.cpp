#include "bench/timing/peak_memory.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

namespace rayshoot {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

/// Memory that was touched, so that the system has to provide it.
std::unique_ptr<char[]> touched(std::size_t bytes) {
    std::unique_ptr<char[]> memory(new char[bytes]);
    for (std::size_t i = 0; i < bytes; i += 4096)
        const_cast<volatile char*>(memory.get())[i] = static_cast<char>(i);
    return memory;
}

/// Nothing where the kernel keeps no mark: the test has nothing to say there.
std::optional<double> megabytes_while(auto&& work) {
    const PeakMemory memory;
    work();
    const auto risen = memory.risen();
    if (!risen) return std::nullopt;
    return static_cast<double>(*risen) / static_cast<double>(megabyte);
}

TEST(PeakMemory, is_the_most_that_was_held_at_once_even_if_freed_since) {
    const auto risen = megabytes_while([] {
        { const auto large = touched(64 * megabyte); }
        const auto small = touched(8 * megabyte);
    });
    if (!risen) GTEST_SKIP() << "this kernel does not reset VmHWM";
    EXPECT_NEAR(*risen, 64, 6);
}

TEST(PeakMemory, does_not_count_what_was_there_before) {
    const auto before = touched(64 * megabyte);
    const auto risen = megabytes_while([] { const auto own = touched(16 * megabyte); });
    if (!risen) GTEST_SKIP() << "this kernel does not reset VmHWM";
    EXPECT_NEAR(*risen, 16, 4);
}

TEST(PeakMemory, counts_memory_that_was_freed_before_and_is_used_again) {
    std::vector<std::unique_ptr<char[]>> pieces;  // small enough for the heap, not mapped apart
    for (int i = 0; i < 320; ++i) pieces.push_back(touched(100000));
    pieces.clear();
    const auto risen = megabytes_while([&] {
        for (int i = 0; i < 320; ++i) pieces.push_back(touched(100000));
    });
    if (!risen) GTEST_SKIP() << "this kernel does not reset VmHWM";
    EXPECT_NEAR(*risen, 30.5, 4);
}

TEST(PeakMemory, of_next_to_nothing_is_not_measured) {
    EXPECT_FALSE(megabytes_while([] {}).has_value());
}

}  // namespace
}  // namespace rayshoot
