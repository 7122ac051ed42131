#include "tracer/colour_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace rayshoot {
namespace {

/// Glyphs of 3 x 5 dots, a row in three bits, the top row first.
struct Glyph {
    char character;
    std::array<std::uint8_t, 5> rows;
};
constexpr std::array glyphs{
    Glyph{'0', {7, 5, 5, 5, 7}}, Glyph{'1', {2, 6, 2, 2, 7}}, Glyph{'2', {7, 1, 7, 4, 7}},
    Glyph{'3', {7, 1, 7, 1, 7}}, Glyph{'4', {5, 5, 7, 1, 1}}, Glyph{'5', {7, 4, 7, 1, 7}},
    Glyph{'6', {7, 4, 7, 5, 7}}, Glyph{'7', {7, 1, 2, 2, 2}}, Glyph{'8', {7, 5, 7, 5, 7}},
    Glyph{'9', {7, 5, 7, 1, 7}}, Glyph{'.', {0, 0, 0, 0, 2}}, Glyph{'-', {0, 0, 7, 0, 0}},
    Glyph{'+', {0, 2, 7, 2, 0}}, Glyph{'e', {0, 7, 7, 4, 7}}};
constexpr int glyph_width = 3, glyph_height = 5, advance = 4;  // dots
constexpr int dot = 2;                                         // pixels
constexpr int bar_height = 24, tick_height = 6, margin = 4;    // pixels
constexpr int text_height = glyph_height * dot;
constexpr int least_width = 96;  // pixels: the longest label fits

int text_width(std::string_view text) {
    return (static_cast<int>(text.size()) * advance - (advance - glyph_width)) * dot;
}

void fill(Image& image, int x, int y, int width, int height, const vec3& colour) {
    for (int row = y; row < y + height; ++row) {
        for (int column = x; column < x + width; ++column) image.at(column, row) = colour;
    }
}

void draw_glyph(Image& image, int x, int y, const Glyph& glyph) {
    for (int row = 0; row < glyph_height; ++row) {
        for (int column = 0; column < glyph_width; ++column) {
            const bool set = glyph.rows[static_cast<std::size_t>(row)] >> (2 - column) & 1;
            if (set) fill(image, x + column * dot, y + row * dot, dot, dot, vec3(0));
        }
    }
}

void draw_text(Image& image, int x, int y, std::string_view text) {
    for (const char character : text) {
        const auto glyph = std::ranges::find(glyphs, character, &Glyph::character);
        if (glyph != glyphs.end()) draw_glyph(image, x, y, *glyph);
        x += advance * dot;
    }
}

std::string label(double value) {
    char text[32];
    // Three digits, and no exponent where whole numbers are as short.
    std::snprintf(text, sizeof text, value >= 100 && value < 1e6 ? "%.0f" : "%.3g", value);
    return text;
}

/// As many ticks as their labels have room for, the ends among them.
int tick_count(const ColourScale& scale, int width) {
    const int widest = std::max(
        {text_width(label(scale.low)), text_width(label(scale.high)), text_width("-0.00")});
    return std::clamp(2 * width / (3 * widest), 2, 6);
}

}  // namespace

Image colour_bar(const ColourScale& scale, int width) {
    width = std::max(width, least_width);
    Image bar(width, bar_height + tick_height + text_height + 2 * margin);
    fill(bar, 0, 0, width, bar.height(), vec3(1));
    for (int x = 0; x < width; ++x) {
        fill(bar, x, 0, 1, bar_height, map_colour((x + 0.5) / width));
    }
    const int ticks = tick_count(scale, width);
    for (int tick = 0; tick < ticks; ++tick) {
        const double place = static_cast<double>(tick) / (ticks - 1);
        const int x = std::min(static_cast<int>(std::lround(place * width)), width - 1);
        fill(bar, x, bar_height, 1, tick_height, vec3(0));
        const std::string text = label(scale.value(place));
        const int left =
            std::clamp(x - text_width(text) / 2, 0, std::max(0, width - text_width(text)));
        draw_text(bar, left, bar_height + tick_height + margin, text);
    }
    return bar;
}

}  // namespace rayshoot
