#include "bench/textbook/figures.h"

namespace rayshoot::textbook {
namespace {

constexpr Figure in_order[]{
    {"bounding_volume",
     "A chair of 96 objects: a ray that misses its bounding volume needs one test",
     bounding_volume},
    {"shadow_share", "How much of the work shadow rays are, by the number of lights", shadow_share},
    {"aliases", "A high-frequency and a low-frequency signal with the same samples", aliases},
    {"test_function", "(1 + sin x) |sinc(x / 20)|: finely sampled, point-sampled, filtered",
     test_function},
    {"moire", "What is left of frequencies that pixels cannot show, filter by filter", moire},
    {"antialiasing", "No antialiasing against 3 x 3 supersampling, and close-ups", antialiasing},
    {"equal_volume", "The raised cosine cut into regions of equal volume", equal_volume},
    {"footprint", "The footprint of the raised cosine of radius 1.7", footprint},
    {"sample_sums", "Variation of the sum of a sample's weights with its place in the pixel",
     sample_sums},
    {"wagon_wheel", "Frames of a turning wheel, with an instant and with an open shutter",
     wagon_wheel},
    {"motion_blur", "Motion blur before and after, and the profile of a moving edge", motion_blur},
    {"depth_of_field", "Depth of field before and after, and the circle of confusion",
     depth_of_field},
    {"soft_shadow", "Soft shadows before and after, and the profile of a penumbra", soft_shadow},
    {"blurred_reflection", "Blurred reflection before and after, and the width of a mirrored edge",
     blurred_reflection},
};

}  // namespace

std::span<const Figure> figures() { return in_order; }

}  // namespace rayshoot::textbook
