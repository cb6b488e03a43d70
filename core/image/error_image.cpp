// error_image.cpp: two colour maps, a font of 5 by 7 pixels, and a colour bar.
#include "core/image/error_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/quantile.h"
#include "core/image/image_error.h"

namespace neph {
namespace {

using Map = std::array<glm::ivec3, 9>;  // 8-bit sRGB, evenly spaced

/// [SmithVdWalt15]
constexpr Map kMagma{{{0, 0, 4},
                      {29, 17, 71},
                      {81, 18, 124},
                      {130, 38, 129},
                      {182, 54, 121},
                      {230, 81, 100},
                      {251, 136, 97},
                      {254, 194, 135},
                      {252, 253, 191}}};

/// [Moreland09]
constexpr Map kCoolWarm{{{59, 76, 192},
                         {98, 130, 234},
                         {141, 176, 254},
                         {184, 208, 249},
                         {221, 221, 221},
                         {245, 196, 173},
                         {244, 154, 123},
                         {222, 96, 77},
                         {180, 4, 38}}};

constexpr double kLeastEnd = 1e-3;
constexpr double kShareWithin = 0.99;  // of the errors that the bar covers

// The legend, in units of one pixel of the font, which grows with the image.
constexpr int kWidthPerUnit = 480, kLeastWidth = 240;
constexpr int kHeight = 26, kMargin = 4, kBarHeight = 8, kTickHeight = 2, kLabelTop = 15;
constexpr int kAdvance = 6, kGlyphWidth = 5, kGlyphHeight = 7;
constexpr int kTicks = 5;
constexpr glm::ivec3 kPaper{24, 24, 24}, kInk{230, 230, 230};

/// One letter of the font, which is built in so that legends need no font file.
struct Glyph {
    char letter;
    std::array<std::uint8_t, kGlyphHeight> rows;  // from the top, the left pixel is bit 4
};

constexpr std::array<Glyph, 26> kGlyphs{{
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {'-', {0, 0, 0, 31, 0, 0, 0}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'%', {24, 25, 2, 4, 8, 19, 3}},
    {'<', {2, 4, 8, 16, 8, 4, 2}},       {'>', {8, 4, 2, 1, 2, 4, 8}},
    {'(', {2, 4, 8, 8, 8, 4, 2}},        {')', {8, 4, 2, 2, 2, 4, 8}},
    {'/', {0, 1, 2, 4, 8, 16, 0}},       {'|', {4, 4, 4, 4, 4, 4, 4}},
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}},
    {'F', {31, 16, 16, 30, 16, 16, 16}}, {'I', {14, 4, 4, 4, 4, 4, 14}},
    {'L', {16, 16, 16, 16, 16, 16, 31}}, {'P', {30, 17, 17, 30, 16, 16, 16}},
}};

/// Linear between the points of the map; `share` in [0, 1].
glm::vec3 along(const Map& map, double share) {
    const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(map.size() - 1);
    const auto from = std::min(static_cast<std::size_t>(at), map.size() - 2);
    const auto mixed = static_cast<float>(at - static_cast<double>(from));
    return glm::mix(glm::vec3(map[from]), glm::vec3(map[from + 1]), mixed) / 255.0f;
}

/// Pixels outside the image are ignored, so that text may be clipped.
void put(Image8& image, int x, int y, const glm::ivec3& colour) {
    if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) return;
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
             static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c) {
        image.rgba[at + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(colour[c]);
    }
    image.rgba[at + 3] = 255;
}

void fill(Image8& image, glm::ivec2 from, glm::ivec2 size, const glm::ivec3& colour) {
    for (int y = from.y; y < from.y + size.y; ++y) {
        for (int x = from.x; x < from.x + size.x; ++x) put(image, x, y, colour);
    }
}

int widthOf(std::string_view text, int unit) {
    return (static_cast<int>(text.size()) * kAdvance - 1) * unit;
}

void write(Image8& image, glm::ivec2 at, int unit, std::string_view text) {
    for (const char letter : text) {
        const auto glyph = std::ranges::find(kGlyphs, letter, &Glyph::letter);
        assert(glyph != kGlyphs.end());
        for (int y = 0; y < kGlyphHeight; ++y) {
            for (int x = 0; x < kGlyphWidth; ++x) {
                if (((glyph->rows[static_cast<std::size_t>(y)] >> (kGlyphWidth - 1 - x)) & 1) ==
                    0) {
                    continue;
                }
                fill(image, at + unit * glm::ivec2(x, y), glm::ivec2(unit), kInk);
            }
        }
        at.x += kAdvance * unit;
    }
}

glm::ivec3 toBytes(const glm::vec3& colour) {
    return glm::ivec3(glm::round(colour * 255.0f));
}

/// The label of a tick; "<" and ">" at the ends, beyond which errors may lie.
std::string labelAt(double error, bool end, const ErrorScale& scale) {
    if (!scale.percent) return numberText(error, 3);
    const char* beyond = !end ? "" : error < 0.0 ? "<" : ">";
    return fmt::format("{}{}%", beyond, numberText(100.0 * error, 3));
}

/// Title, colour bar and tick labels below the image.
void drawLegend(Image8& image, int top, int unit, const ErrorScale& scale) {
    fill(image, {0, top}, {image.size.x, kHeight * unit}, kPaper);
    const int barTop = top + kMargin * unit;
    write(image, {kMargin * unit, barTop}, unit, scale.title);
    const int left = 3 * kMargin * unit + widthOf(scale.title, unit);
    const double lowest = scale.bothSigns ? -scale.most : 0.0;
    const std::string last = labelAt(scale.most, true, scale);
    const int right = image.size.x - kMargin * unit - widthOf(last, unit) / 2;
    const int width = std::max(right - left, 1);
    for (int x = 0; x < width; ++x) {
        const double error = lowest + (scale.most - lowest) * (x + 0.5) / width;
        fill(image, {left + x, barTop}, {1, kBarHeight * unit}, toBytes(errorColour(error, scale)));
    }
    for (int i = 0; i < kTicks; ++i) {
        const double share = static_cast<double>(i) / (kTicks - 1);
        const double error = lowest + (scale.most - lowest) * share;
        const bool end = i == kTicks - 1 || (i == 0 && scale.bothSigns);
        const std::string label = labelAt(error, end, scale);
        const int x = left + static_cast<int>(std::lround(share * width));
        fill(image, {x - unit / 2, barTop + kBarHeight * unit}, {unit, kTickHeight * unit}, kInk);
        write(image, {x - widthOf(label, unit) / 2, top + kLabelTop * unit}, unit, label);
    }
}

}  // namespace

glm::vec3 errorColour(double error, const ErrorScale& scale) {
    if (!scale.bothSigns) return along(kMagma, std::abs(error) / scale.most);
    return along(kCoolWarm, 0.5 + 0.5 * error / scale.most);
}

// The last per cent of the errors may be single bright pixels: they should not set the scale.
double roundEnd(std::span<const float> errors) {
    std::vector<float> magnitudes;
    for (const float error : errors) magnitudes.push_back(std::abs(error));
    const double most = std::max(quantile(magnitudes, kShareWithin), kLeastEnd);
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    for (const double end : {decade, 2.0 * decade, 5.0 * decade}) {
        if (most <= end) return end;
    }
    return 10.0 * decade;
}

Image8 errorColours(glm::ivec2 size, std::span<const float> errors, const ErrorScale& scale) {
    Image8 image;
    image.size = size;
    image.rgba.reserve(4 * errors.size());
    for (const float error : errors) {
        const glm::ivec3 colour = toBytes(errorColour(static_cast<double>(error), scale));
        for (int c = 0; c < 3; ++c) image.rgba.push_back(static_cast<std::uint8_t>(colour[c]));
        image.rgba.push_back(255);
    }
    return image;
}

Image8 errorImage(glm::ivec2 size, std::span<const float> errors, const ErrorScale& scale) {
    const int unit = std::max(1, size.x / kWidthPerUnit);
    Image8 image;
    image.size = {std::max(size.x, kLeastWidth), size.y + kHeight * unit};
    image.rgba.resize(4 * static_cast<std::size_t>(image.size.x) *
                      static_cast<std::size_t>(image.size.y));
    fill(image, {0, 0}, image.size, kPaper);
    const Image8 colours = errorColours(size, errors, scale);
    const auto from = 4 * static_cast<std::ptrdiff_t>(size.x);
    const auto to = 4 * static_cast<std::ptrdiff_t>(image.size.x);
    for (int y = 0; y < size.y; ++y) {
        std::copy_n(colours.rgba.begin() + y * from, from, image.rgba.begin() + y * to);
    }
    drawLegend(image, size.y, unit, scale);
    return image;
}

}  // namespace neph
