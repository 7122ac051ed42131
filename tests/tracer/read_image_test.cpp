#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "tests/data/temporary_folder.h"
#include "tracer/image.h"
#include "tracer/random.h"

namespace rayshoot {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class ReadImage : public testing::Test {
protected:
    fs::path path(const std::string& name) const { return folder_.path() / name; }
    fs::path write(const std::string& name, std::string_view bytes) const {
        return folder_.write(name, bytes);
    }
    /// What read_image says about the file; "" when it takes it.
    std::string refusal(const fs::path& file) const {
        try {
            read_image(file);
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos)
                << error.what();
            return error.what();
        }
        return "";
    }
    void expect_refusal(const fs::path& file, const std::string& part) const {
        const std::string said = refusal(file);
        EXPECT_NE(said.find(part), std::string::npos) << file << ": \"" << said << '"';
    }

    TemporaryFolder folder_;
};

/// Wide enough that its files can be broken off anywhere.
Image ramps() {
    Image image(64, 16);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto t = static_cast<float>(y * image.width() + x) / 1024;
            image.at(x, y) = {t, 1 - t, t * t};
        }
    }
    return image;
}

/// A PNG as libpng writes it in this format.
void write_foreign_png(const fs::path& path, png_uint_32 format, int width, int height) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(width);
    header.height = static_cast<png_uint_32>(height);
    header.format = format;
    const std::vector<png_byte> bytes(PNG_IMAGE_SIZE(header), 77);
    ASSERT_TRUE(png_image_write_to_file(&header, path.c_str(), 0, bytes.data(), 0, nullptr));
}

TEST_F(ReadImage, exr_gives_every_float_back) {
    Image image = ramps();
    image.at(3, 1) = {-1, 1e20f, 1e-40f};
    image.at(4, 1) = {std::numeric_limits<float>::infinity(), -0.0f, 3};
    write_image(image, path("a.exr"));
    EXPECT_EQ(digest(read_image(path("a.exr"))), digest(image));
}

TEST_F(ReadImage, png_written_again_is_the_same_file) {
    Image all_bytes(256, 3);
    for (int byte = 0; byte < 256; ++byte) {
        // Anywhere near the middle of what rounds to `byte`.
        const double encoded = byte / 255.0;
        const double linear =
            encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        for (int y = 0; y < 3; ++y) {
            all_bytes.at(byte, y) = vec3(0);
            all_bytes.at(byte, y)[y] = static_cast<float>(linear);
        }
    }
    write_image(all_bytes, path("a.png"));
    const Image read = read_image(path("a.png"));
    write_image(read, path("b.png"));
    EXPECT_EQ(bytes_of(path("a.png")), bytes_of(path("b.png")));
    for (int byte = 1; byte < 256; ++byte)
        EXPECT_GT(read.at(byte, 1).y, read.at(byte - 1, 1).y) << byte;
    EXPECT_EQ(read.at(255, 2), vec3(0, 0, 1));
    EXPECT_NEAR(read.at(188, 0).x, 0.5, 0.003);  // the middle grey of sRGB
}

TEST_F(ReadImage, png_of_greys_and_palettes_is_read_as_colours) {
    write_foreign_png(path("grey.png"), PNG_FORMAT_GRAY, 5, 2);
    const Image read = read_image(path("grey.png"));
    EXPECT_EQ(read.width(), 5);
    EXPECT_EQ(read.height(), 2);
    EXPECT_NEAR(read.at(4, 1).x, std::pow((77 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(read.at(4, 1).x, read.at(0, 0).z);
}

TEST_F(ReadImage, what_would_lose_something_is_refused_with_the_remedy) {
    write_foreign_png(path("deep.png"), PNG_FORMAT_LINEAR_RGB, 3, 3);
    expect_refusal(path("deep.png"), "16 bits");
    write_foreign_png(path("clear.png"), PNG_FORMAT_RGBA, 3, 3);
    expect_refusal(path("clear.png"), "transparent");
}

TEST_F(ReadImage, a_file_that_is_not_there_or_is_none_is_named) {
    expect_refusal(path("none.png"), "no such file");
    expect_refusal(path("none.exr"), "no such file");
    fs::create_directory(path("folder.exr"));
    expect_refusal(path("folder.exr"), "no regular file");
    expect_refusal(path("image.jpg"), ".png and .exr");
    expect_refusal(write("empty.png", ""), "cannot read");
    expect_refusal(write("empty.exr", ""), "cannot read");
    expect_refusal(write("text.png", "no image at all"), "cannot read");
    expect_refusal(write("text.exr", "no image at all"), "cannot read");
    write_image(ramps(), path("a.png"));
    expect_refusal(write("liar.exr", bytes_of(path("a.png"))), "cannot read");
}

TEST_F(ReadImage, a_file_broken_off_anywhere_is_refused) {
    for (const char* extension : {".png", ".exr"}) {
        const fs::path whole = path(std::string("whole") + extension);
        write_image(ramps(), whole);
        const std::string bytes = bytes_of(whole);
        // A PNG's pixels may be complete without its last chunk, of twelve bytes.
        for (std::size_t length = 0; length + 13 < bytes.size(); length += 31) {
            const fs::path part =
                write(std::string("part") + extension, std::string_view(bytes).substr(0, length));
            EXPECT_NE(refusal(part), "") << extension << " of " << length << " bytes";
        }
    }
}

/// Either an image comes out, of a size that may be, or a refusal; never anything else.
TEST_F(ReadImage, a_file_with_wrong_bytes_gives_an_image_or_a_refusal) {
    constexpr std::uint32_t files = 200;
    for (const char* extension : {".png", ".exr"}) {
        const fs::path whole = path(std::string("whole") + extension);
        write_image(ramps(), whole);
        const std::string bytes = bytes_of(whole);
        for (std::uint32_t file = 0; file < files; ++file) {
            const RandomSequence random(20, file, 0);
            std::string wrong = bytes;
            for (std::uint32_t change = 0; change <= file % 4; ++change) {
                // Two in three in what describes the image, at the front of the file.
                const std::size_t range = random.bits(3 * change) % 3 ? 400 : wrong.size();
                const std::size_t at = random.bits(3 * change + 1) % std::min(range, wrong.size());
                wrong[at] = static_cast<char>(random.bits(3 * change + 2));
            }
            const fs::path changed = write(std::string("wrong") + extension, wrong);
            try {
                const Image image = read_image(changed);
                EXPECT_GT(image.pixels().size(), 0u) << file;
            } catch (const std::invalid_argument&) {
            }
        }
    }
}

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t sum = 0xffffffff;
    for (const char byte : bytes) {
        sum ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    return ~sum;
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

TEST_F(ReadImage, png_that_claims_an_absurd_size_is_refused_before_memory_is_taken) {
    write_image(ramps(), path("a.png"));
    std::string bytes = bytes_of(path("a.png"));
    for (const std::uint32_t size : {100000u, 1000000u, 0x7fffffffu}) {
        // Behind eight bytes of signature and four of length: "IHDR", width, height, 5 more, CRC.
        const std::string header =
            "IHDR" + big_endian(size) + big_endian(size) + bytes.substr(24, 5);
        std::string lie = bytes;
        lie.replace(12, header.size(), header).replace(29, 4, big_endian(crc32(header)));
        EXPECT_NE(refusal(write("lie.png", lie)), "") << size;
    }
}

TEST_F(ReadImage, exr_that_claims_an_absurd_size_is_refused_before_memory_is_taken) {
    write_image(ramps(), path("a.exr"));
    const std::string bytes = bytes_of(path("a.exr"));
    const std::string name = std::string("dataWindow") + '\0' + "box2i" + '\0';
    const std::size_t at = bytes.find(name) + name.size() + 4;  // then four int32, little-endian
    for (const std::int32_t far : {40000, 1 << 20, std::numeric_limits<std::int32_t>::max()}) {
        std::string lie = bytes;
        std::memcpy(lie.data() + at + 8, &far, sizeof far);
        std::memcpy(lie.data() + at + 12, &far, sizeof far);
        EXPECT_NE(refusal(write("lie.exr", lie)), "") << far;
    }
}

TEST_F(ReadImage, exr_may_lie_anywhere_in_the_plane) {
    const Imath::Box2i window({-5, 1000}, {-2, 1001});
    std::vector<float> red{1, 2, 3, 4, 5, 6, 7, 8};
    Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), window);
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B", "A"}) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, red.data(), window));
    }
    {
        Imf::OutputFile file(path("far.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    const Image read = read_image(path("far.exr"));
    ASSERT_EQ(read.width(), 4);
    ASSERT_EQ(read.height(), 2);
    EXPECT_EQ(read.at(0, 0), vec3(1));
    EXPECT_EQ(read.at(3, 1), vec3(8));
}

TEST_F(ReadImage, exr_without_colours_is_refused) {
    Imf::Header header(2, 2);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    const std::vector<float> depth(4);
    Imf::FrameBuffer frame;
    frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, depth.data(), header.dataWindow()));
    {
        Imf::OutputFile file(path("depth.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    expect_refusal(path("depth.exr"), "no channel R");
}

}  // namespace
}  // namespace rayshoot
