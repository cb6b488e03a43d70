// map_image.cpp: cells as squares of pixels, ticks at round numbers, the bar to the right.
#include "core/image/map_image.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/image/error_image.h"
#include "core/image/pixel_font.h"

namespace neph {
namespace {

// In pixels, tuned by eye. A letter is 7 units high.
constexpr int kUnit = 2, kEdgePx = 8, kTick = 6, kBarWidth = 18, kBarGap = 24;
constexpr int kLetter = kLetterHeight * kUnit;
constexpr int kLeastHeightPx = 160;
constexpr int kTicksAlong = 6;
constexpr glm::ivec3 kPaperColour{24, 24, 24}, kInkColour{230, 230, 230}, kUnknown{96, 96, 96};

/// The round step, 1, 2 or 5 times a power of ten, that gives `count` ticks at most.
double tickStep(double extent, int count) {
    const double least = extent / count;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
    }
    return 10.0 * decade;
}

struct Axis {
    double from = 0.0, to = 1.0;
    int lowPx = 0, highPx = 0;  // of the ends
    int at(double value) const {
        return lowPx +
               static_cast<int>(std::lround((value - from) / (to - from) * (highPx - lowPx)));
    }
    template <typename Tick>
    void ticks(Tick tick) const {
        const double step = tickStep(to - from, kTicksAlong);
        const double slack = 1e-6 * step;
        for (double i = std::ceil((from - slack) / step); i * step <= to + slack; ++i) {
            tick(at(i * step), i == 0.0 ? "0" : numberText(i * step, 6));
        }
    }
};

/// Pixels per cell in x and y, so that the map is to scale and not tiny.
glm::ivec2 pixelsPerCell(const MapField& field) {
    const double finest = std::min(field.cellKm.x, field.cellKm.y);
    const glm::ivec2 shape = glm::max(glm::ivec2(glm::round(field.cellKm / finest)), glm::ivec2(1));
    return shape * std::max(1, field.widthPx / (field.size.x * shape.x));
}

glm::ivec3 colourOf(double value, double most) {
    if (std::isnan(value)) return kUnknown;
    const ErrorScale scale{.most = most};
    return glm::ivec3(glm::round(errorColour(std::max(value, 0.0), scale) * 255.0f));
}

void drawCells(Image8& image, const MapField& field, glm::ivec2 corner, glm::ivec2 cellPx) {
    for (int y = 0; y < field.size.y; ++y) {
        for (int x = 0; x < field.size.x; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(field.size.x) +
                static_cast<std::size_t>(x);
            const glm::ivec2 at = corner + glm::ivec2(x, field.size.y - 1 - y) * cellPx;
            fillPixels(image, at, cellPx,
                       colourOf(static_cast<double>(field.values[i]), field.most));
        }
    }
}

void drawBar(Image8& image, const MapField& field, int left, int top, int height) {
    for (int y = 0; y < height; ++y) {
        const double value = field.most * (height - y - 0.5) / height;
        fillPixels(image, {left, top + y}, {kBarWidth, 1}, colourOf(value, field.most));
    }
    const Axis axis{0.0, field.most, top + height, top};
    axis.ticks([&](int y, const std::string& text) {
        fillPixels(image, {left + kBarWidth, y - 1}, {kTick, 2}, kInkColour);
        writePixels(image, {left + kBarWidth + 2 * kTick, y - kLetter / 2}, kUnit, text,
                    kInkColour);
    });
    const int x = std::min(left, image.size.x - kEdgePx - pixelWidthOf(field.label, kUnit));
    writePixels(image, {x, top - kLetter - 5 * kUnit}, kUnit, field.label, kInkColour);
}

void drawAxes(Image8& image, const Axis& x, const Axis& y) {
    const int bottom = y.lowPx, left = x.lowPx;
    x.ticks([&](int at, const std::string& text) {
        fillPixels(image, {at - 1, bottom}, {2, kTick}, kInkColour);
        writePixels(image, {at - pixelWidthOf(text, kUnit) / 2, bottom + kTick + 4}, kUnit, text,
                    kInkColour);
    });
    y.ticks([&](int at, const std::string& text) {
        fillPixels(image, {left - kTick, at - 1}, {kTick, 2}, kInkColour);
        writePixels(image, {left - kTick - 4 - pixelWidthOf(text, kUnit), at - kLetter / 2}, kUnit,
                    text, kInkColour);
    });
    const std::string east = "x / km";
    writePixels(
        image, {(x.lowPx + x.highPx - pixelWidthOf(east, kUnit)) / 2, bottom + kTick + 2 * kLetter},
        kUnit, east, kInkColour);
    writePixels(image, {kEdgePx, y.highPx - kLetter - 5 * kUnit}, kUnit, "y / km", kInkColour);
}

}  // namespace

glm::ivec2 MapImage::columnAt(glm::dvec2 pixel, glm::ivec2 size) const {
    const glm::dvec2 share = (pixel - glm::dvec2(mapAtPx)) / glm::dvec2(mapSizePx);
    if (share.x < 0.0 || share.y < 0.0 || share.x >= 1.0 || share.y >= 1.0) return glm::ivec2(-1);
    return {static_cast<int>(share.x * size.x), size.y - 1 - static_cast<int>(share.y * size.y)};
}

MapImage drawMap(const MapField& field) {
    const glm::ivec2 cellPx = pixelsPerCell(field);
    const glm::ivec2 mapPx = field.size * cellPx;
    const int left = kEdgePx + pixelWidthOf("10000", kUnit) + kTick + 4;
    const int top = kEdgePx + 5 * kLetter;
    const int right = kBarGap + kBarWidth + 2 * kTick + pixelWidthOf("0.0001", kUnit) + kEdgePx;
    const int below = kTick + 4 * kLetter;
    MapImage drawn;
    drawn.mapAtPx = {left, top};
    drawn.mapSizePx = mapPx;
    drawn.image.size = {left + mapPx.x + right, std::max(top + mapPx.y + below, kLeastHeightPx)};
    drawn.image.rgba.resize(4 * static_cast<std::size_t>(drawn.image.size.x) *
                            static_cast<std::size_t>(drawn.image.size.y));
    fillPixels(drawn.image, {0, 0}, drawn.image.size, kPaperColour);
    drawCells(drawn.image, field, {left, top}, cellPx);
    const glm::dvec2 upperKm = field.originKm + glm::dvec2(field.size) * field.cellKm;
    drawAxes(drawn.image, {field.originKm.x, upperKm.x, left, left + mapPx.x},
             {field.originKm.y, upperKm.y, top + mapPx.y, top});
    drawBar(drawn.image, field, left + mapPx.x + kBarGap, top, mapPx.y);
    writePixels(drawn.image, {kEdgePx, kEdgePx}, kUnit, field.title, kInkColour);
    writePixels(drawn.image, {kEdgePx, kEdgePx + kLetter + kUnit * 2}, kUnit, field.subtitle,
                kInkColour);
    return drawn;
}

double roundMost(std::span<const float> values) {
    double most = 0.0;
    for (const float value : values) {
        if (!std::isnan(value)) most = std::max(most, static_cast<double>(value));
    }
    if (most <= 0.0) return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    for (const double end : {decade, 2.0 * decade, 5.0 * decade}) {
        if (most <= end * (1.0 + 1e-6)) return end;
    }
    return 10.0 * decade;
}

}  // namespace neph
