#include "data/aff.h"
#include "data/file.h"
#include "data/mesh_catalogue.h"
#include "data/nff.h"
#include "data/obj.h"

#include "tests/data/messages.h"

#include <random>

#include <sys/resource.h>

/// Files with bytes changed at random: each is read or refused, in little memory, and what is read
/// is sound. Seeds are constants.
namespace rayshoot {
namespace {

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::string operator()(std::string text) {
        const int changes = 1 + below(4);
        for (int i = 0; i < changes && !text.empty(); ++i) change(text);
        return text;
    }

private:
    int below(std::size_t end) { return static_cast<int>(random_() % end); }
    std::size_t place(const std::string& text) { return random_() % text.size(); }

    void change(std::string& text) {
        static constexpr std::array<const char*, 12> words{
            "-1", "0", "4294967295", "2147483648", "99999999999999999999", "nan", "1e999",
            "\n", " ", "#",          "/",          "\xff\xff\xff\x7f"};
        const std::size_t at = place(text), length = random_() % 16;
        switch (below(6)) {
            case 0:
                text[at] = static_cast<char>(random_());
                break;
            case 1:
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                break;
            case 2:
                text.erase(at, length);
                break;
            case 3:
                text.insert(at, text.substr(place(text), length));
                break;
            case 4:
                text.replace(at, 1, words[random_() % words.size()]);
                break;
            case 5:
                text.resize(below(4) == 0 ? at : text.size());
                break;
        }
    }

    std::mt19937 random_;
};

void expect_sound(const Scene& scene) {
    EXPECT_EQ(scene.material_of.size(), scene.geometry.size());
    for (const std::uint32_t material : scene.material_of)
        EXPECT_LT(material, scene.materials.size());
    for (std::uint32_t i = 0; i < scene.geometry.size(); ++i)
        EXPECT_FALSE(scene.geometry.bounds(i).empty());
}

/// Reads `count` mutations; anything thrown but std::invalid_argument fails the test.
template <class Read>
void fuzz(const std::string& text, unsigned seed, int count, Read&& read) {
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    Mutator mutated(seed);
    int sound = 0;
    for (int i = 0; i < count; ++i) {
        const std::string bytes = mutated(text);
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", mutation " << i);
        const std::string refused = message_of([&] { expect_sound(read(bytes)); });
        if (refused.empty()) ++sound;
        else EXPECT_TRUE(contains(refused, "test"));
    }
    EXPECT_GT(sound, 0);
    EXPECT_LT(sound, count);
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 300 << 10) << "kilobytes";
}

std::string nasty(const std::string& name) { return read_file(data_folder() / "nasty" / name); }

void fuzz_mesh(const std::string& text, const std::string& format, unsigned seed) {
    fuzz(text, seed, 3000, [&](const std::string& bytes) {
        return mesh_scene(read_mesh(bytes, format, "test"), Precision::standard, "test");
    });
}

TEST(Fuzz, nff) {
    const std::string text =
        nasty("cone_one_line.nff") +
        "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n";
    fuzz(text, 1, 3000, [](const std::string& bytes) { return read_nff(bytes, "test"); });
}

TEST(Fuzz, nff_extension) {
    const std::string text =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 32\n"
        "shutter 0 0.5\nlens focal 0.5 stop 2.8 focus 5 blades 6\nvmove 0 0 0 1 0 0\n"
        "light spot 0 0 0 0 0 1 20 30 1 1 1\nlight rectangle 0 2 0 1 0 0 0 0 2 7 7 7 visible\n"
        "light sphere 5 5 5 2 1 2 3 strata 2 2\nsurface conductor roughness 0.25 eta 1 2 3\n"
        "move 0 0 0 1 1 1\nturn 0 0 0 0 0 1 0 90\ns 0 0 0 1\nrest\n"
        "surface lambert emission 1 1 1\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\ns 1 1 1 1\n";
    fuzz(text, 9, 3000, [](const std::string& bytes) { return read_nff(bytes, "test"); });
}

TEST(Fuzz, aff) {
    const std::string text =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 32\n"
        "a 0 10 11\nla b 1 1 1\ni 0 test.part\nxs 1 2 1 0 0 1 30 1 0 0 {\nx a { x b {\n"
        "i 0 test.part\np 3 0 0 0 1 0 0 0 1 0\n} s 0 0 0 0 }}\n"
        "k a { transl 4\n-1 0 0 0 0 0 0\n0 0 0 0 0 0 0\n9 1 0 0 0 0 0\n19 1 0 0 0 0 0\n}\n"
        "k b { rot 4\n-1 0 1 0 0 0 0 0\n0 0 1 0 0 0 0 0\n9 0 1 0 90 0 0 0\n19 0 1 0 90 0 0 0\n"
        "visibility 2\n0 1\n5 0\n}\n";
    const std::string part =
        "fm 0 0 0 0.5 0.25 0 0.3 0.3 0.3 20 0 0\nm vertices 3\n0 0 0\n1 0 0\n0 1 0\n"
        "normals 1\n0 0 1\ntexturecoords 1 a.ppm\n0 0\ntriangles 1\n0 1 2\n0 0 0\n0 0 0\n";
    Mutator mutated_part(11);
    const AffFiles files = [&](const std::string& path) {
        if (path != "test.part") throw std::invalid_argument(path + ": there is no such file");
        return mutated_part(part);
    };
    fuzz(text, 10, 3000, [&](const std::string& bytes) {
        return aff_scene(read_aff_model(bytes, "test", files), "test", Precision::standard,
                         {.number = 3});
    });
}

TEST(Fuzz, obj) {
    const std::string text = "mtllib m.mtl\nusemtl a\n" + nasty("negative_indices_ngon.obj");
    const std::string library =
        "newmtl a\nKd 0.1 0.2 0.3\nKs 1 1 1\nNs 10\nd 0.5\nNi 1.5\nillum 4\n";
    Mutator mutated_library(7);
    fuzz(text, 2, 3000, [&](const std::string& bytes) {
        return mesh_scene(
            read_obj(bytes, "test", [&](const std::string&) { return mutated_library(library); }),
            Precision::standard, "test");
    });
}

TEST(Fuzz, binary_ply) { fuzz_mesh(nasty("big_endian.ply"), ".ply", 3); }

TEST(Fuzz, text_ply) {
    fuzz_mesh(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n3 0 1 2\n4 0 1 3 2\n",
        ".ply", 4);
}

TEST(Fuzz, off) {
    fuzz_mesh(
        "COFF\n4 2 0\n0 0 0 255 0 0\n1 0 0 0 0 0\n0 1 0 1 1 1\n1 1 0 2 2 2\n3 0 1 2\n"
        "4 0 1 3 2 0.5 0.5 0.5\n",
        ".off", 5);
}

TEST(Fuzz, text_stl) {
    const std::string facet =
        "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
        "  vertex 0 1 0\n endloop\nendfacet\n";
    fuzz_mesh("solid s\n" + facet + facet + "endsolid s\n", ".stl", 6);
}

TEST(Fuzz, binary_stl) {
    std::string text(80, ' ');
    text += std::string("\2\0\0\0", 4);
    for (int i = 0; i < 100; ++i) text += static_cast<char>(i % 50 < 12 ? 0 : i);
    fuzz_mesh(text, ".stl", 8);
}

}  // namespace
}  // namespace rayshoot
