// periodic_scenes.h: clouds across the sides of a domain, and its repeats.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/gpu/scenes.h"

namespace neph::test {

/// Of the march; a sun at 35 degrees, one phase function, for which paths have little noise.
inline render::FrameInputs periodicFrame(const SpeciesVolume& volume, Transport transport,
                                         DomainSides sides, const CameraPose& pose,
                                         glm::ivec2 sizePx) {
    Look look = lookOf(kModes[1]);
    look.transport = transport;
    look.domainSides = sides;
    look.phaseDisplay = PhaseDisplay::physical;
    look.sunAzimuthDeg = 255.0f;
    look.sunElevationDeg = 35.0f;
    render::FrameInputs inputs = frame(volume, look, pose, sizePx, 0);
    inputs.look.engine = Engine::march;
    return inputs;
}

/// Clouds some of which lie across the sides, in 6.4 x 5.6 x 1.8 km; so many cells for each 400 x
/// 400 x 300 m along an axis.
inline SpeciesVolume brokenClouds(int perCell = 1) {
    SpeciesVolume volume = uniformVolume(perCell * glm::ivec3(16, 14, 6), 1.0, 0.0f);
    volume.grid.spacingM = glm::dvec3(400.0, 400.0, 300.0) / static_cast<double>(perCell);
    Array3f& content = volume.contentKgPerM3[0];
    const double turn = 2.0 * std::numbers::pi;
    for (int z = perCell; z < 5 * perCell; ++z)
        for (int y = 0; y < content.size.y; ++y)
            for (int x = 0; x < content.size.x; ++x) {
                const double east = static_cast<double>(x) / content.size.x;
                const double north = static_cast<double>(y) / content.size.y;
                const double wave = std::cos(turn * east) + std::cos(turn * (2.0 * north + east));
                content.at(x, y, z) = static_cast<float>(1.5e-5 * std::max(0.0, wave - 0.4));
            }
    return volume;
}

/// The volume and its eight neighbours, in the same place.
inline SpeciesVolume nineOf(const SpeciesVolume& one) {
    SpeciesVolume nine;
    nine.grid = one.grid;
    nine.grid.size = one.grid.size * glm::ivec3(3, 3, 1);
    nine.grid.originM -= glm::dvec3(glm::dvec2(one.grid.extentM()), 0.0);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const Array3f& from = one.contentKgPerM3[s];
        if (from.values.empty()) continue;
        Array3f& to = nine.contentKgPerM3[s];
        to = Array3f(nine.grid.size);
        for (int z = 0; z < to.size.z; ++z)
            for (int y = 0; y < to.size.y; ++y)
                for (int x = 0; x < to.size.x; ++x) {
                    to.at(x, y, z) = from.at(x % from.size.x, y % from.size.y, z);
                }
    }
    return nine;
}

/// The clouds so many voxels further east and north; what leaves enters on the other side.
inline SpeciesVolume rolled(const SpeciesVolume& one, glm::ivec2 voxels) {
    SpeciesVolume moved = one;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const Array3f& from = one.contentKgPerM3[s];
        if (from.values.empty()) continue;
        for (int z = 0; z < from.size.z; ++z)
            for (int y = 0; y < from.size.y; ++y)
                for (int x = 0; x < from.size.x; ++x) {
                    moved.contentKgPerM3[s].at((x + voxels.x) % from.size.x,
                                               (y + voxels.y) % from.size.y, z) = from.at(x, y, z);
                }
    }
    return moved;
}

}  // namespace neph::test
