#include "data/scenes.h"

#include "data/mesh_catalogue.h"
#include "tests/data/messages.h"

#include <chrono>

#include <sys/resource.h>

/// The files of data/nasty: each is read with the right count, or refused with place and remedy.
namespace rayshoot {
namespace {

struct Nasty {
    std::string file;
    std::uint32_t primitives;   ///< when it is read
    std::string where, remedy;  ///< parts of the message when it is refused
};

std::ostream& operator<<(std::ostream& out, const Nasty& nasty) { return out << nasty.file; }

class NastyFile : public testing::TestWithParam<Nasty> {};

/// Bytes that the process has had in memory at most, so far.
std::uint64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

TEST_P(NastyFile, is_read_or_refused_quickly_and_in_little_memory) {
    const Nasty& nasty = GetParam();
    const std::string path = (data_folder() / "nasty" / nasty.file).string();
    const std::uint64_t memory_before = peak_memory();
    const auto start = std::chrono::steady_clock::now();
    Scene scene;
    const std::string message = message_of([&] { scene = load_scene(path); });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

    if (nasty.where.empty()) {
        EXPECT_EQ(message, "");
        EXPECT_EQ(scene.geometry.size(), nasty.primitives);
        EXPECT_EQ(scene.material_of.size(), nasty.primitives);
        EXPECT_TRUE(finite(scene.geometry.bounds().lo) && finite(scene.geometry.bounds().hi));
    } else {
        EXPECT_TRUE(contains(message, nasty.file + nasty.where));
        EXPECT_TRUE(contains(message, nasty.remedy));
    }
    EXPECT_LT(seconds.count(), 20);
    EXPECT_LT(peak_memory() - memory_before, 200u << 20);
}

INSTANTIATE_TEST_SUITE_P(
    All, NastyFile,
    testing::Values(
        Nasty{"degenerate.obj", 5, "", ""},
        Nasty{"nan_inf_vertices.obj", 0, ":4: ", "repair this vertex"},
        Nasty{"coplanar_xy.obj", 2048, "", ""}, Nasty{"duplicates_x64.obj", 8192, "", ""},
        Nasty{"one_triangle.obj", 1, "", ""},
        Nasty{"zero_triangles.obj", 0, ":3: ", "without a face"},
        Nasty{"empty.obj", 0, ":1: ", "without a face"},
        Nasty{"empty.nff", 0, ":1: ", "there is no view"},
        Nasty{"index_out_of_range.obj", 0, ":21: ", "vertex 99, but the file has 8"},
        Nasty{"negative_indices_ngon.obj", 6, "", ""}, Nasty{"crlf.obj", 12, "", ""},
        Nasty{"big_endian.ply", 12, "", ""}, Nasty{"truncated.ply", 0, ": face ", "fetch it again"},
        Nasty{"lying_count.ply", 0, ": the header declares 2000000000", "fetch it again"},
        Nasty{"offset_1e8.obj", 128, "", ""}, Nasty{"tiny_1e-20.obj", 12, "", ""},
        Nasty{"skinny_fan.obj", 2000, "", ""},
        Nasty{"bad_lines.nff", 0, ":12: ", "sphere: s x y z radius"},
        Nasty{"cone_one_line.nff", 3, "", ""}, Nasty{"teapot_in_stadium.obj", 7408, "", ""}),
    [](const auto& test) {
        std::string name = test.param.file;
        for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
        return name;
    });

}  // namespace
}  // namespace rayshoot
