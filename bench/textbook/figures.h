#pragma once

#include "accel/core/catalogue.h"
#include "bench/textbook/sheet.h"

#include <span>
#include <string_view>

/// The figures and tables of the textbook, each made by one function. A new one is a declaration
/// here, a line in figures.cpp and a file.
namespace rayshoot::textbook {

inline constexpr int smallest_edge = 32, largest_edge = 2048;  ///< pixels

/// What figures are made with.
struct Studio {
    const Catalogue& catalogue;
    int edge = 256;   ///< pixels along a picture, smallest_edge to largest_edge
    int threads = 1;  ///< for what is not timed
};

struct Figure {
    std::string_view name;
    std::string_view shows;  ///< a line
    void (*make)(const Studio&, Sheet&);
};

/// In the order of the book.
std::span<const Figure> figures();

void bounding_volume(const Studio& studio, Sheet& sheet);
void shadow_share(const Studio& studio, Sheet& sheet);
void aliases(const Studio& studio, Sheet& sheet);
void test_function(const Studio& studio, Sheet& sheet);
void moire(const Studio& studio, Sheet& sheet);
void antialiasing(const Studio& studio, Sheet& sheet);
void equal_volume(const Studio& studio, Sheet& sheet);
void footprint(const Studio& studio, Sheet& sheet);
void sample_sums(const Studio& studio, Sheet& sheet);
void wagon_wheel(const Studio& studio, Sheet& sheet);
void motion_blur(const Studio& studio, Sheet& sheet);
void depth_of_field(const Studio& studio, Sheet& sheet);
void soft_shadow(const Studio& studio, Sheet& sheet);
void blurred_reflection(const Studio& studio, Sheet& sheet);

}  // namespace rayshoot::textbook
