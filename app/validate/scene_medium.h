// scene_medium.h: the medium of a scene file: layers, columns or a grid, on one regular grid.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/render/engines/reference/trace_meter.h"

namespace neph::validate {

/// A box of one medium that is endless in y, and in x unless it has a width.
struct Slab {
    double leftM = 0.0, rightM = 0.0;
    double baseM = 0.0, topM = 0.0;
    double extinctionPerM = 0.0;
    double albedo = 1.0;
    PhaseSpec phase;
};

struct Medium {
    glm::ivec3 size{1};
    glm::dvec3 spacingM{1.0};
    std::vector<render::MeterField> fields;
};

/// The slabs on the coarsest grid of 16 levels or more that their edges lie on; what overlaps adds
/// up. Throws Error
/// where that grid is too fine or there are too many media.
Medium rasterise(const std::vector<Slab>& slabs, const std::string& where);

/// Throws Error where a grid has no cells or more than a scene may have.
void checkCellCount(glm::ivec3 size, const std::string& where);

/// Numbers between commas, spaces or line ends; # opens a comment. Throws Error unless there are
/// `count`, none negative.
std::vector<float> readCsv(const std::filesystem::path& file, std::size_t count);

/// Little-endian float32. Throws Error unless there are `count`, none negative.
std::vector<float> readRaw(const std::filesystem::path& file, std::size_t count);

/// Throws Error unless there are `count` values, none negative.
void checkExtinction(const std::vector<float>& values, std::size_t count, const std::string& where);

}  // namespace neph::validate
