#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tracer/image.h"

namespace rayshoot {
namespace {

namespace fs = std::filesystem;

/// An empty folder that goes away with the test.
class ImageFile : public testing::Test {
protected:
    void SetUp() override {
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / (std::string("rayshoot_image_") + test.name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

Image test_image() {
    Image image(3, 2);
    image.at(0, 0) = {0, 0.5f, 1};
    image.at(1, 0) = {-1, 2, 0.0031308f};
    image.at(2, 0) = {1e-20f, 1e20f, std::numeric_limits<float>::quiet_NaN()};
    image.at(0, 1) = {0.2140411f, 0.001f, 0.9f};
    return image;
}

TEST_F(ImageFile, exr_gives_every_float_back) {
    const fs::path path = folder_ / "image.exr";
    const Image image = test_image();
    write_image(image, path);

    std::vector<vec3> pixels(6);
    Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().channels().findChannel("R")->type, Imf::FLOAT);
    Imf::FrameBuffer frame;
    for (int channel = 0; channel < 3; ++channel) {
        const char* const names[] = {"R", "G", "B"};
        frame.insert(names[channel],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixels[0][channel]),
                                sizeof(vec3), 3 * sizeof(vec3)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_EQ(std::memcmp(pixels.data(), image.pixels().data(), 6 * sizeof(vec3)), 0);
    EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFile, png_holds_srgb_bytes) {
    const fs::path path = folder_ / "image.png";
    write_image(test_image(), path);

    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&header, path.c_str()));
    EXPECT_EQ(header.width, 3u);
    EXPECT_EQ(header.height, 2u);
    header.format = PNG_FORMAT_RGB;
    std::vector<int> expected{0, 188, 255, 0, 255, 10, 0, 255, 0, 127, 3, 243, 0, 0, 0, 0, 0, 0};
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(header));
    ASSERT_TRUE(png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr));
    EXPECT_EQ(std::vector<int>(bytes.begin(), bytes.end()), expected);
    EXPECT_EQ(files(), 1u);
}

std::string failure(const Image& image, const fs::path& path) {
    try {
        write_image(image, path);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST_F(ImageFile, refusals_name_the_file_and_leave_nothing_behind) {
    const Image image = test_image();
    for (const char* name : {"image.jpg", "image", ""}) {
        EXPECT_NE(failure(image, folder_ / name).find(".png and .exr"), std::string::npos) << name;
    }
    fs::create_directory(folder_ / "folder.png");
    EXPECT_NE(failure(image, folder_ / "folder.png").find("directory"), std::string::npos);
    for (const char* name : {"missing/image.png", "missing/image.exr"}) {
        EXPECT_NE(failure(image, folder_ / name).find(name), std::string::npos) << name;
    }
    EXPECT_THROW(write_image(Image(), folder_ / "image.png"), std::invalid_argument);
    EXPECT_THROW(require_writable(folder_ / "missing/image.png"), std::runtime_error);
    EXPECT_EQ(files(), 1u);  // the folder
}

TEST_F(ImageFile, an_older_image_is_replaced_as_a_whole) {
    const fs::path path = folder_ / "image.png";
    std::ofstream(path) << "old";
    require_writable(path);
    EXPECT_EQ(fs::file_size(path), 3u);
    write_image(test_image(), path);
    EXPECT_GT(fs::file_size(path), 50u);
    EXPECT_EQ(files(), 1u);
}

TEST(Image, digest_sees_every_bit_and_the_shape) {
    Image image(2, 3);
    const std::string black = digest(image);
    EXPECT_EQ(black.size(), 64u);
    EXPECT_NE(digest(Image(3, 2)), black);
    image.at(1, 2).z = -0.0f;
    EXPECT_NE(digest(image), black);
}

}  // namespace
}  // namespace rayshoot
