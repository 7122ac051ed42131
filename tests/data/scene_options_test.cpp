#include "data/scene_options.h"

#include "tests/data/messages.h"

namespace rayshoot {
namespace {

TEST(SceneOptions, gives_values_and_fallbacks) {
    const SceneOptions options("s", "size=8,length=0.5,name=x");
    EXPECT_EQ(options.integer("size", 1, 1, 10), 8);
    EXPECT_EQ(options.integer("other", 3, 1, 10), 3);
    EXPECT_EQ(options.number("length", 1, 0, 1), 0.5);
    EXPECT_EQ(options.text("name", "y"), "x");
    EXPECT_EQ(options.text("other", "y"), "y");
    EXPECT_TRUE(options.contains("size"));
    EXPECT_FALSE(options.without("size").contains("size"));
    EXPECT_TRUE(SceneOptions("s", "").empty());
}

TEST(SceneOptions, refuses_what_is_no_pair) {
    for (const char* text : {"size", "=4", "size=", ",", "a=1,,b=2", "a=1,a=2"})
        EXPECT_TRUE(contains(message_of([&] { SceneOptions("s", text); }), "s: option")) << text;
}

TEST(SceneOptions, refuses_absurd_values_and_says_what_is_accepted) {
    for (const char* value :
         {"0", "11", "-1", "4x", "1e3", "99999999999999999999", "0x8", "nan", " 4"})
        EXPECT_TRUE(
            contains(message_of([&] {
                         SceneOptions("s", std::string("size=") + value).integer("size", 1, 1, 10);
                     }),
                     "a whole number from 1 to 10"))
            << value;
    for (const char* value : {"nan", "inf", "-inf", "2", "1e999", "x"})
        EXPECT_TRUE(contains(
            message_of([&] {
                SceneOptions("s", std::string("length=") + value).number("length", 0, 0, 1);
            }),
            "a number from 0 to 1"))
            << value;
}

TEST(SceneOptions, lists_what_exists_for_an_unknown_key) {
    const std::string message = message_of([] {
        SceneOptions("s", "sise=1").require_known({"size", "seed"});
    });
    EXPECT_TRUE(contains(message, "unknown option 'sise'"));
    EXPECT_TRUE(contains(message, "precision, size, seed"));
}

}  // namespace
}  // namespace rayshoot
