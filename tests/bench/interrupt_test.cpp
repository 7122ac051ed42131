#include "bench/output/interrupt.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rayshoot {
namespace {

volatile std::sig_atomic_t seen = 0;
void see(int) { seen = seen + 1; }

TEST(Interrupt, the_first_is_remembered_and_does_not_end_the_program) {
    const InterruptGuard guard;
    EXPECT_FALSE(guard.interrupted());
    std::raise(SIGINT);
    EXPECT_TRUE(guard.interrupted());
}

TEST(Interrupt, the_second_does_what_it_did_before) {
    std::signal(SIGINT, see);
    seen = 0;
    {
        const InterruptGuard guard;
        std::raise(SIGINT);
        EXPECT_EQ(seen, 0);
        std::raise(SIGINT);
        EXPECT_EQ(seen, 1);
    }
    std::raise(SIGINT);
    EXPECT_EQ(seen, 2);
    std::signal(SIGINT, SIG_DFL);
}

TEST(InterruptDeathTest, the_second_ends_a_program_that_never_asked) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            std::raise(SIGINT);
            std::raise(SIGINT);
            std::exit(0);
        },
        testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, a_new_guard_knows_nothing_of_the_last) {
    {
        const InterruptGuard guard;
        std::raise(SIGINT);
    }
    const InterruptGuard guard;
    EXPECT_FALSE(guard.interrupted());
}

TEST(Interrupt, there_is_one_at_a_time) {
    const InterruptGuard guard;
    EXPECT_THROW(InterruptGuard(), std::logic_error);
    std::raise(SIGINT);
    EXPECT_TRUE(guard.interrupted());
}

}  // namespace
}  // namespace rayshoot
