// upsample.cpp: computes rows of the finer grid from interpolated rows of the coarser one, layer by
// layer.
#include "core/volume/upsample.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/parallel.h"

namespace neph {
namespace {

constexpr std::size_t kMostWorkers = 16;

/// The two coarse cells between whose centres the centre of a fine cell lies.
struct Place {
    int below = 0, above = 0;
    float share = 0.0f;  ///< weight of `above`
};

Place placeOf(int cell, int cells, int coarseCells) {
    const double position =
        (cell + 0.5) * static_cast<double>(coarseCells) / static_cast<double>(cells) - 0.5;
    const double clamped = std::clamp(position, 0.0, coarseCells - 1.0);
    const int below = static_cast<int>(std::floor(clamped));
    return {below, std::min(below + 1, coarseCells - 1), static_cast<float>(clamped - below)};
}

float mix(float a, float b, float share) {
    return a + share * (b - a);
}

/// The row of coarse cells interpolated to (y, z).
void blendRows(const Array3f& coarse, const Place& y, const Place& z, std::vector<float>& row) {
    const std::array rows{&coarse.at(0, y.below, z.below), &coarse.at(0, y.above, z.below),
                          &coarse.at(0, y.below, z.above), &coarse.at(0, y.above, z.above)};
    for (std::size_t x = 0; x < row.size(); ++x) {
        row[x] = mix(mix(rows[0][x], rows[1][x], y.share), mix(rows[2][x], rows[3][x], y.share),
                     z.share);
    }
}

Array3f upsampled(const Array3f& coarse, glm::ivec3 size) {
    Array3f fine(size);
    std::vector<Place> across;
    for (int x = 0; x < size.x; ++x) across.push_back(placeOf(x, size.x, coarse.size.x));
    const auto layers = static_cast<std::size_t>(size.z);
    shareOut(layers, workerCount(kMostWorkers),
             [&](std::size_t layer, std::size_t, const Progress&) {
                 std::vector<float> row(static_cast<std::size_t>(coarse.size.x));
                 const int z = static_cast<int>(layer);
                 const Place placeZ = placeOf(z, size.z, coarse.size.z);
                 for (int y = 0; y < size.y; ++y) {
                     blendRows(coarse, placeOf(y, size.y, coarse.size.y), placeZ, row);
                     float* out = &fine.at(0, y, z);
                     for (const Place& x : across) {
                         *out++ = mix(row[static_cast<std::size_t>(x.below)],
                                      row[static_cast<std::size_t>(x.above)], x.share);
                     }
                 }
             });
    return fine;
}

}  // namespace

void upsample(SpeciesVolume& volume, glm::ivec3 size) {
    RegularGrid& grid = volume.grid;
    assert(glm::all(glm::greaterThanEqual(size, grid.size)));
    if (size == grid.size) return;
    for (auto* held : {&volume.contentKgPerM3, &volume.extinctionPerM}) {
        for (Array3f& values : *held) {
            if (!values.empty()) values = upsampled(values, size);
        }
    }
    grid.spacingM = grid.extentM() / glm::dvec3(size);
    grid.size = size;
}

}  // namespace neph
