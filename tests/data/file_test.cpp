#include "data/file.h"

#include "tests/data/messages.h"
#include "tests/data/temporary_folder.h"

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <sstream>

#include <sys/stat.h>

namespace rayshoot {
namespace {

namespace io = boost::iostreams;

template <class Filter>
std::string packed(const std::string& text, const Filter& filter) {
    std::ostringstream bytes;
    io::filtering_ostream out;
    out.push(filter);
    out.push(bytes);
    out << text;
    out.reset();
    return bytes.str();
}

std::string xz(const std::string& text) { return packed(text, io::lzma_compressor()); }
std::string gz(const std::string& text) { return packed(text, io::gzip_compressor()); }

std::string long_text() {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += std::to_string(i * 7919 % 10007) + "\n";
    return text;
}

TEST(File, is_unpacked_by_the_end_of_its_name) {
    const TemporaryFolder folder;
    const std::string text = long_text();
    EXPECT_EQ(read_file(folder.write("a.nff", text)), text);
    EXPECT_EQ(read_file(folder.write("a.nff.xz", xz(text))), text);
    EXPECT_EQ(read_file(folder.write("a.nff.gz", gz(text))), text);
    EXPECT_EQ(read_file(folder.write("b.nff.gz", gz(text) + gz(text))), text + text);
    EXPECT_EQ(read_file(folder.write("empty.nff", "")), "");
    EXPECT_EQ(format_of("x/a.b.PLY.gz"), ".ply");
    EXPECT_EQ(format_of("x/a.nff"), ".nff");
    EXPECT_EQ(format_of("x.nff/a"), "");
}

TEST(File, that_is_damaged_is_refused) {
    const TemporaryFolder folder;
    const std::string text = long_text();
    for (std::string bytes : {xz(text), gz(text)}) {
        const std::string end = bytes[0] == '\x1f' ? ".gz" : ".xz";
        const std::string cut = bytes.substr(0, bytes.size() / 2);
        bytes[bytes.size() / 2] ^= 0x55;
        for (const std::string& bad : {cut, bytes, std::string("hello"), std::string()})
            EXPECT_TRUE(contains(message_of([&] { read_file(folder.write("a" + end, bad)); }),
                                 "a" + end + ": is damaged"))
                << bad.size();
    }
}

TEST(File, that_unpacks_to_far_more_than_it_is_is_refused) {
    const TemporaryFolder folder;
    const std::string zeros(1 << 20, '\0');
    std::ostringstream bytes;
    io::filtering_ostream out;
    out.push(io::gzip_compressor(io::gzip::best_speed));
    out.push(bytes);
    for (int i = 0; i < 100; ++i) out << zeros;
    out.reset();
    EXPECT_TRUE(contains(message_of([&] { read_file(folder.write("bomb.gz", bytes.str())); }),
                         "unpacks to more than"));
}

TEST(File, that_is_none_is_refused) {
    const TemporaryFolder folder;
    const std::string pipe = (folder.path() / "pipe").string();
    const std::string dangling = (folder.path() / "dangling").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink(folder.path() / "nowhere", dangling);
    EXPECT_TRUE(contains(message_of([] { read_file(""); }), "empty"));
    EXPECT_TRUE(contains(message_of([&] { read_file(folder.path()); }), "is a directory"));
    EXPECT_TRUE(contains(message_of([&] { read_file(pipe); }), "not a regular file"));
    EXPECT_TRUE(contains(message_of([] { read_file("/dev/zero"); }), "not a regular file"));
    EXPECT_TRUE(contains(message_of([&] { read_file(dangling); }), "no such file"));
    EXPECT_TRUE(contains(message_of([] { read_file("no/such/file.nff"); }), "no such file"));
    EXPECT_TRUE(contains(message_of([] { read_file(std::string(10000, 'x')); }), "no such file"));
}

}  // namespace
}  // namespace rayshoot
