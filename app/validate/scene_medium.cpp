// scene_medium.cpp: puts slabs on a grid, and reads grids from files. Lengths are counted in whole
// micrometres, so that a common step can be found.
#include "app/validate/scene_medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

#include "core/base/error.h"

namespace neph::validate {
namespace {

constexpr double kStepsPerM = 1e6;
constexpr std::int64_t kMaxCells = std::int64_t{1} << 25;  // 128 MiB per field
constexpr int kMaxSide = 2048;                             // of a 3-D texture
constexpr std::size_t kMaxFields = kSpeciesCount;          // each stands in for a species
// Infinite layers are periodic cells; the wider they are, the fewer a path has to cross.
constexpr double kWidthOverHeight = 16.0;
// The tracer distributes its work by what it knows of each cell; with too few cells its results are
// still correct, but noisier.
constexpr int kMinLevels = 16;

/// A length in micrometres.
std::int64_t steps(double lengthM) {
    return std::llround(lengthM * kStepsPerM);
}

/// Cells of one axis: their size, in micrometres, and their number from 0 to the last edge.
struct Axis {
    std::int64_t cell = 0;
    int count = 0;
};

/// The largest cell of which all edges are multiples. Throws Error if there are too many cells.
Axis axisOf(const std::vector<double>& edgesM, std::string_view name, const std::string& where) {
    Axis axis;
    std::int64_t last = 0;
    for (const double edge : edgesM) {
        axis.cell = std::gcd(axis.cell, steps(edge));
        last = std::max(last, steps(edge));
    }
    if (axis.cell == 0 || last / axis.cell > kMaxSide) {
        throw Error({where, fmt::format("{} have no common step", name),
                     axis.cell == 0 ? "no extent" : fmt::format("{} cells", last / axis.cell),
                     fmt::format("1 to {} cells of one size", kMaxSide),
                     "make them multiples of one length"});
    }
    axis.count = static_cast<int>(last / axis.cell);
    return axis;
}

/// The field with the albedo and phase function of `slab`, added if there is none yet.
render::MeterField& fieldOf(Medium& medium, const Slab& slab, const std::string& where) {
    for (render::MeterField& field : medium.fields) {
        if (field.albedo == slab.albedo && field.phase == slab.phase) return field;
    }
    if (medium.fields.size() == kMaxFields) {
        throw Error({where, "has too many media", fmt::format("more than {}", kMaxFields),
                     fmt::format("at most {} pairs of albedo and phase", kMaxFields), ""});
    }
    medium.fields.push_back({Array3f(medium.size), slab.albedo, slab.phase});
    return medium.fields.back();
}

/// The first `most` + 1 bytes of a file, so that a longer file is noticed. Throws Error.
std::string contentOf(const std::filesystem::path& file, std::size_t most) {
    std::ifstream stream(file, std::ios::binary);
    std::error_code error;
    if (!stream || std::filesystem::is_directory(file, error)) {
        throw Error({file.string(), "cannot be read", std::strerror(errno), "", ""});
    }
    std::string content(most + 1, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    return content;
}

}  // namespace

void checkCellCount(glm::ivec3 size, const std::string& where) {
    const std::int64_t cells = std::int64_t{size.x} * std::int64_t{size.y} * std::int64_t{size.z};
    if (cells <= kMaxCells) return;
    throw Error({where, "has too many cells", fmt::format("{}", cells),
                 fmt::format("at most {}", kMaxCells), ""});
}

Medium rasterise(const std::vector<Slab>& slabs, const std::string& where) {
    std::vector<double> edgesX, edgesZ;
    for (const Slab& slab : slabs) {
        edgesX.insert(edgesX.end(), {slab.leftM, slab.rightM});
        edgesZ.insert(edgesZ.end(), {slab.baseM, slab.topM});
    }
    const Axis z = axisOf(edgesZ, "heights", where);
    const int parts = (kMinLevels + z.count - 1) / z.count;  // levels per cell
    const double heightM = static_cast<double>(z.cell) * z.count / kStepsPerM;
    const bool endless =
        std::ranges::all_of(slabs, [](const Slab& slab) { return slab.rightM == slab.leftM; });
    const Axis x =
        endless ? Axis{steps(kWidthOverHeight * heightM), 1} : axisOf(edgesX, "widths", where);
    Medium medium;
    medium.size = {x.count, 1, z.count * parts};
    checkCellCount(medium.size, where);
    medium.spacingM = {static_cast<double>(x.cell) / kStepsPerM, kWidthOverHeight * heightM,
                       heightM / medium.size.z};
    for (const Slab& slab : slabs) {
        Array3f& extinction = fieldOf(medium, slab, where).extinctionPerM;
        const auto left = static_cast<int>(steps(slab.leftM) / x.cell);
        const auto right = endless ? 1 : static_cast<int>(steps(slab.rightM) / x.cell);
        const int base = parts * static_cast<int>(steps(slab.baseM) / z.cell);
        const int top = parts * static_cast<int>(steps(slab.topM) / z.cell);
        for (int k = base; k < top; ++k) {
            for (int i = left; i < right; ++i) {
                extinction.at(i, 0, k) += static_cast<float>(slab.extinctionPerM);
            }
        }
    }
    return medium;
}

void checkExtinction(const std::vector<float>& values, std::size_t count,
                     const std::string& where) {
    if (values.size() != count) {
        throw Error({where, "contains the wrong number of values", fmt::format("{}", values.size()),
                     fmt::format("{}, the product of \"size\"", count), ""});
    }
    const auto wrong = std::ranges::find_if(
        values, [](float value) { return !(value >= 0.0f && std::isfinite(value)); });
    if (wrong == values.end()) return;
    throw Error({where, fmt::format("value {} is not an extinction", wrong - values.begin()),
                 fmt::format("{}", *wrong), "a finite number, 0 or more", ""});
}

std::vector<float> readCsv(const std::filesystem::path& file, std::size_t count) {
    constexpr std::size_t kMaxBytesPerValue = 64;  // with comments
    std::istringstream lines(contentOf(file, (count + 64) * kMaxBytesPerValue));
    std::vector<float> values;
    for (std::string line; std::getline(lines, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        std::ranges::replace(line, ',', ' ');
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            char* end = nullptr;
            values.push_back(std::strtof(word.c_str(), &end));
            if (*end == '\0') continue;
            throw Error({file.string(), fmt::format("value {} is not a number", values.size() - 1),
                         word.substr(0, 40), "numbers separated by commas, spaces or line ends",
                         ""});
        }
    }
    checkExtinction(values, count, file.string());
    return values;
}

std::vector<float> readRaw(const std::filesystem::path& file, std::size_t count) {
    static_assert(std::endian::native == std::endian::little);
    const std::string content = contentOf(file, count * sizeof(float));
    if (content.size() != count * sizeof(float)) {
        throw Error({file.string(), "has the wrong size",
                     content.size() > count * sizeof(float)
                         ? "more bytes"
                         : fmt::format("{} bytes", content.size()),
                     fmt::format("{} bytes, four per cell", count * sizeof(float)), ""});
    }
    std::vector<float> values(count);
    std::memcpy(values.data(), content.data(), content.size());
    checkExtinction(values, count, file.string());
    return values;
}

}  // namespace neph::validate
