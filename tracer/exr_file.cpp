#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include "tracer/image_file.h"

namespace rayshoot {

void write_exr(const Image& image, const std::filesystem::path& path) {
    // OpenEXR's frame buffers take char*, also for writing.
    std::vector<vec3> pixels = image.pixels();
    Imf::Header header(image.width(), image.height());
    Imf::FrameBuffer frame;
    const char* const names[] = {"R", "G", "B"};
    for (int channel = 0; channel < 3; ++channel) {
        header.channels().insert(names[channel], Imf::Channel(Imf::FLOAT));
        frame.insert(
            names[channel],
            Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixels.front()[channel]), sizeof(vec3),
                       sizeof(vec3) * static_cast<std::size_t>(image.width())));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height());
}

}  // namespace rayshoot
