// grid.h: regular grids in metres and the arrays on them.
//
// World space: x east, y north, z up, metres; (0, 0) is the south-west corner of the model domain,
// z is height above sea level. It moves with a grid that moves over the ground. Arrays are
// cell-centred, x fastest, then y, then z.
#pragma once
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace neph {

/// Unit vector of a compass direction: azimuth clockwise from north, elevation above the horizon.
inline glm::dvec3 compassDirWorld(float azimuthDeg, float elevationDeg) {
    const double azimuth = glm::radians(static_cast<double>(azimuthDeg));
    const double elevation = glm::radians(static_cast<double>(elevationDeg));
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

/// Side of a square cell of the same area.
inline double meanCellM(const glm::dvec2& spacingM) {
    return spacingM.x == spacingM.y ? spacingM.x : std::sqrt(spacingM.x * spacingM.y);
}

/// A block of cells; `originM` is the lower corner of the first cell.
struct RegularGrid {
    glm::ivec3 size{0};
    glm::dvec3 originM{0.0};
    glm::dvec3 spacingM{1.0};
    /// How far world space has moved over the ground, in x and y, with a grid that moves.
    glm::dvec2 movedM{0.0};

    std::size_t cellCount() const {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
               static_cast<std::size_t>(size.z);
    }
    glm::dvec3 extentM() const { return glm::dvec3(size) * spacingM; }
    glm::dvec3 upperM() const { return originM + extentM(); }
    glm::dvec3 centreM(glm::ivec3 cell) const {
        return originM + (glm::dvec3(cell) + 0.5) * spacingM;
    }
    bool operator==(const RegularGrid&) const = default;
};

/// Values of type T on an nx·ny·nz block, x fastest.
template <typename T>
struct Array3 {
    glm::ivec3 size{0};
    std::vector<T> values;

    Array3() = default;
    explicit Array3(glm::ivec3 size_, T fill = T{})
        : size(size_),
          values(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                     static_cast<std::size_t>(size_.z),
                 fill) {}

    bool empty() const { return values.empty(); }
    /// Index into `values`.
    std::size_t index(int x, int y, int z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(size.x) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(size.y) * static_cast<std::size_t>(z));
    }
    T& at(int x, int y, int z) { return values[index(x, y, z)]; }
    const T& at(int x, int y, int z) const { return values[index(x, y, z)]; }
    bool operator==(const Array3&) const = default;
};

using Array3f = Array3<float>;

}  // namespace neph
