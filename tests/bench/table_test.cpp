#include "bench/output/table.h"

#include "bench/output/machine.h"
#include "bench/output/progress.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace rayshoot {
namespace {

TEST(NumberCell, has_the_significant_digits_asked_for) {
    EXPECT_EQ(number_cell(3.14159, 3), "3.14");
    EXPECT_EQ(number_cell(0.00123456, 3), "0.00123");
    EXPECT_EQ(number_cell(123456.0, 3), "123456");
    EXPECT_EQ(number_cell(0.0, 3), "0");
    EXPECT_EQ(number_cell(-2.5, 2), "-2.5");
}

TEST(ShortNumber, has_no_idle_zeros_and_shows_what_is_tiny) {
    EXPECT_EQ(short_number(96), "96");
    EXPECT_EQ(short_number(16777217, 9), "16777217");
    EXPECT_EQ(short_number(2.75, 3), "2.75");
    EXPECT_EQ(short_number(1.26e-14, 2), "1.3e-14");
    EXPECT_EQ(short_number(std::numeric_limits<double>::infinity()), "n/a");
}

TEST(NumberCell, what_was_not_measured_is_not_zero) {
    EXPECT_EQ(number_cell(std::nullopt), "n/a");
    EXPECT_EQ(number_cell(std::numeric_limits<double>::quiet_NaN()), "n/a");
}

TEST(Table, text_sets_numbers_to_the_right) {
    EXPECT_EQ(to_text({{"name", "n"}, {{"a", "1"}, {"bb", "100"}}}),
              "name    n\n"
              "----  ---\n"
              "a       1\n"
              "bb    100\n");
}

TEST(Table, markdown_escapes_pipes) {
    EXPECT_EQ(to_markdown({{"a|b"}, {{"x"}}}), "| a\\|b |\n|---|\n| x |\n");
}

TEST(Table, csv_quotes_commas_quotes_and_line_breaks) {
    EXPECT_EQ(to_csv({{"a", "b"}, {{"grid:density=3,mailbox=on", "say \"hi\""}}}),
              "a,b\r\n\"grid:density=3,mailbox=on\",\"say \"\"hi\"\"\"\r\n");
}

TEST(Slug, keeps_letters_and_digits) {
    EXPECT_EQ(slug("AMD EPYC 7763 64-Core Processor"), "amd-epyc-7763-64-core-processor");
    EXPECT_EQ(slug(" (R) "), "r");
    EXPECT_EQ(slug("..."), "unknown");
}

TEST(Progress, is_silent_where_it_is_not_seen) {
    std::ostringstream out;
    {
        Progress progress(2, out, false);
        progress.advance("one");
    }
    EXPECT_EQ(out.str(), "");
}

TEST(Progress, shows_the_share_done_and_wipes_its_line) {
    std::ostringstream out;
    {
        Progress progress(2, out, true);
        progress.advance("one");
        progress.advance("two");
    }
    EXPECT_NE(out.str().find("0 %: one"), std::string::npos);
    EXPECT_NE(out.str().find("50 %"), std::string::npos);
    EXPECT_EQ(out.str().back(), '\r');
}

}  // namespace
}  // namespace rayshoot
