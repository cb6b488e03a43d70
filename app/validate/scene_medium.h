// scene_medium.h: the medium of a scene file: layers, columns or a grid, on one regular grid.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/render/engines/reference/trace_meter.h"

namespace neph::validate {

/// A box of one medium, infinite in y, and in x if its width is 0.
struct Slab {
    double leftM = 0.0, rightM = 0.0;
    double baseM = 0.0, topM = 0.0;
    double extinctionPerM = 0.0;
    double albedo = 1.0;
    PhaseSpec phase;
};

/// A medium on a grid, as the meter needs it.
struct Medium {
    glm::ivec3 size{1};
    glm::dvec3 spacingM{1.0};
    std::vector<render::MeterField> fields;
};

/// The slabs on the coarsest grid of 16 levels or more that contains all of their edges.
/// Overlapping slabs add up. Throws Error if that grid is too fine or there are too many media.
Medium rasterise(const std::vector<Slab>& slabs, const std::string& where);

/// Throws Error if a grid has more cells than a scene may have.
void checkCellCount(glm::ivec3 size, const std::string& where);

/// Reads numbers separated by commas, spaces or line ends; # starts a comment. Throws Error unless
/// there are `count` of them, none negative.
std::vector<float> readCsv(const std::filesystem::path& file, std::size_t count);

/// Reads little-endian float32. Throws Error unless there are `count` of them, none negative.
std::vector<float> readRaw(const std::filesystem::path& file, std::size_t count);

/// Throws Error unless there are `count` values, none negative.
void checkExtinction(const std::vector<float>& values, std::size_t count, const std::string& where);

}  // namespace neph::validate
