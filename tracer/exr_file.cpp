#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <array>
#include <stdexcept>
#include <string>

#include "tracer/camera.h"
#include "tracer/image_file.h"

namespace rayshoot {
namespace {

constexpr std::array<const char*, 3> channel_names{"R", "G", "B"};

/// `pixels`: of the window, row by row.
Imf::FrameBuffer frame_of(vec3* pixels, const Imath::Box2i& window) {
    Imf::FrameBuffer frame;
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    for (int channel = 0; channel < 3; ++channel) {
        frame.insert(channel_names[static_cast<std::size_t>(channel)],
                     Imf::Slice::Make(Imf::FLOAT, &(*pixels)[channel], window, sizeof(vec3),
                                      sizeof(vec3) * width));
    }
    return frame;
}

void require_colours(const Imf::Header& header) {
    for (const char* name : channel_names) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (!channel) {
            throw std::invalid_argument(std::string("it has no channel ") + name +
                                        "; R, G and B are read");
        }
        if (channel->xSampling != 1 || channel->ySampling != 1) {
            throw std::invalid_argument(std::string("its channel ") + name +
                                        " is sampled more coarsely than its pixels");
        }
    }
}

}  // namespace

void write_exr(const Image& image, const std::filesystem::path& path) {
    std::vector<vec3> pixels = image.pixels();
    Imf::Header header(image.width(), image.height());
    for (const char* name : channel_names) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame_of(pixels.data(), header.dataWindow()));
    file.writePixels(image.height());
}

Image read_exr(const std::filesystem::path& path) {
    // Of the whole process, and asked before the library allocates its tables of lines.
    Imf::Header::setMaxImageSize(largest_image, largest_image);
    Imf::InputFile file(path.c_str());
    require_colours(file.header());
    if (!file.isComplete()) throw std::invalid_argument("it is broken off");
    const Imath::Box2i window = file.header().dataWindow();
    Image image = image_of_claimed_size(std::int64_t{window.max.x} - window.min.x + 1,
                                        std::int64_t{window.max.y} - window.min.y + 1);
    file.setFrameBuffer(frame_of(&image.at(0, 0), window));
    file.readPixels(window.min.y, window.max.y);
    return image;
}

}  // namespace rayshoot
