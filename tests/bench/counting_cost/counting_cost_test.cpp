#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

/// The timing code has no trace of counting: as many instructions as with the calls deleted.
namespace {

constexpr double allowed = 0.005;

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return text;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), pipe)) text += part.data();
    pclose(pipe);
    return text;
}

/// Instructions of a whole run under callgrind; nothing where it did not run to its end.
std::optional<double> instructions(const std::string& program, int passes) {
    const std::string text =
        output_of("valgrind --tool=callgrind --callgrind-out-file=/dev/null '" + program + "' " +
                  std::to_string(passes));
    const std::string mark = "Collected : ";
    const std::size_t at = text.find(mark);
    if (at == std::string::npos || text.find("Process terminating") != std::string::npos)
        return std::nullopt;
    return std::strtod(text.c_str() + at + mark.size(), nullptr);
}

/// Of one more pass: building and starting cancel out.
std::optional<double> instructions_of_a_pass(const std::string& program) {
    const auto one = instructions(program, 1), two = instructions(program, 2);
    if (!one || !two) return std::nullopt;
    return *two - *one;
}

TEST(CountingCost, timing_code_runs_as_many_instructions_as_with_the_calls_deleted) {
#ifndef NDEBUG
    GTEST_SKIP() << "a build with assertions is not what is timed";
#endif
    if (output_of("valgrind --version").find("valgrind-") != 0)
        GTEST_SKIP() << "valgrind is not installed: apt-get install valgrind";
    const auto delivered = instructions_of_a_pass(RAYSHOOT_DELIVERED);
    const auto deleted = instructions_of_a_pass(RAYSHOOT_DELETED);
    if (!delivered || !deleted) GTEST_SKIP() << "valgrind cannot run this machine's instructions";
    ASSERT_GT(*deleted, 1e6);
    EXPECT_NEAR(*delivered / *deleted, 1, allowed) << *delivered << " against " << *deleted;
    RecordProperty("instructions", std::to_string(*delivered));
}

}  // namespace
