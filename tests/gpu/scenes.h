// scenes.h: small volumes, looks and views that the GPU tests share.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "app/render/frame/frame_inputs.h"
#include "core/grid/species.h"

namespace neph::test {

/// A box of grid cells with every species' content the same everywhere, kg/m³; a negative content
/// leaves the species out.
inline SpeciesVolume uniformVolume(glm::ivec3 size, double cellM, float cloudKgPerM3) {
    SpeciesVolume volume;
    volume.grid = {size, glm::dvec3(0.0), glm::dvec3(cellM)};
    volume.contentKgPerM3[0] = Array3f(size, cloudKgPerM3);
    return volume;
}

/// Five soft blobs, one a species, beside and in one another, on 26 x 22 x 18 cells of 500 x 500 x
/// 400 m.
inline SpeciesVolume blobs() {
    SpeciesVolume volume;
    volume.grid = {{26, 22, 18}, glm::dvec3(0.0, 0.0, 200.0), glm::dvec3(500.0, 500.0, 400.0)};
    const glm::dvec3 centres[5] = {
        {0.4, 0.5, 0.35}, {0.6, 0.5, 0.8}, {0.45, 0.4, 0.15}, {0.55, 0.6, 0.6}, {0.35, 0.6, 0.5}};
    const double peaks[5] = {4e-6, 4e-4, 5e-4, 1e-4, 6e-4};
    const glm::dvec3 extentM = volume.grid.extentM();
    for (std::size_t s = 0; s < 5; ++s) {
        Array3f content(volume.grid.size);
        for (int z = 0; z < content.size.z; ++z)
            for (int y = 0; y < content.size.y; ++y)
                for (int x = 0; x < content.size.x; ++x) {
                    const glm::dvec3 at =
                        (volume.grid.centreM({x, y, z}) - volume.grid.originM) / extentM;
                    const glm::dvec3 d = (at - centres[s]) / 0.16;
                    const double value = peaks[s] * std::exp(-glm::dot(d, d));
                    content.at(x, y, z) =
                        value > 1e-3 * peaks[s] ? static_cast<float>(value) : 0.0f;
                }
        volume.contentKgPerM3[s] = content;
    }
    return volume;
}

struct View {
    std::string name;
    CameraPose pose;
};

/// Outside, inside, below, above, into the sun and away from it; the sun of the tests stands in the
/// south-west at 40°.
inline std::vector<View> views() {
    return {{"from the south", {{0.5f, 0.5f, 0.4f}, 1.3f, 180.0f, 15.0f, 40.0f}},
            {"into the sun", {{0.5f, 0.5f, 0.5f}, 1.3f, 45.0f, -10.0f, 40.0f}},
            {"straight into the sun", {{0.5f, 0.5f, 0.5f}, 1.2f, 45.0f, -40.0f, 30.0f}},
            {"straight away from the sun", {{0.5f, 0.5f, 0.5f}, 1.2f, 225.0f, 40.0f, 30.0f}},
            {"across the sun", {{0.5f, 0.5f, 0.4f}, 1.3f, 135.0f, 5.0f, 60.0f}},
            {"from inside", {{0.5f, 0.5f, 0.45f}, 0.05f, 300.0f, 5.0f, 70.0f}},
            {"from below", {{0.5f, 0.5f, 0.5f}, 0.28f, 200.0f, -85.0f, 70.0f}},
            {"from above", {{0.5f, 0.5f, 0.5f}, 1.5f, 0.0f, 90.0f, 40.0f}}};
}

/// One phase function, no noise, no skylight.
inline Look plainLook() {
    Look look;
    look.transport = Transport::translucent;
    look.noise = false;
    look.phaseMode = PhaseMode::uniform;
    look.phaseDisplay = PhaseDisplay::logarithmic;
    look.skylight = 0.0f;
    return look;
}

struct Mode {
    const char* name;
    Transport transport;
    PhaseMode phase;
    bool noise;
    ExtinctionMode extinction;
    ColourMode colour;
    LightForm form;
};

/// The first four are those of [Riley03] table 4.
inline constexpr Mode kModes[] = {
    {"uniform low-albedo", Transport::lowAlbedo, PhaseMode::uniform, false,
     ExtinctionMode::physical, ColourMode::natural, LightForm::printed},
    {"uniform translucent", Transport::translucent, PhaseMode::uniform, false,
     ExtinctionMode::physical, ColourMode::natural, LightForm::printed},
    {"per-field translucent", Transport::translucent, PhaseMode::perField, false,
     ExtinctionMode::physical, ColourMode::natural, LightForm::printed},
    {"per-field noise translucent", Transport::translucent, PhaseMode::perField, true,
     ExtinctionMode::physical, ColourMode::natural, LightForm::printed},
    {"step-consistent", Transport::translucent, PhaseMode::perField, false,
     ExtinctionMode::physical, ColourMode::natural, LightForm::consistent},
    {"equal extinction, field colours", Transport::lowAlbedo, PhaseMode::perField, false,
     ExtinctionMode::equal, ColourMode::fields, LightForm::printed},
    {"field colours, noise, consistent", Transport::translucent, PhaseMode::perField, true,
     ExtinctionMode::physical, ColourMode::fields, LightForm::consistent}};

/// A look in which the mode shows; the sun stands in the south-west at 40°.
inline Look lookOf(const Mode& mode) {
    Look look;
    look.transport = mode.transport;
    look.phaseMode = mode.phase;
    look.phaseDisplay = PhaseDisplay::logarithmic;
    look.noise = mode.noise;
    look.extinction = mode.extinction;
    look.colour = mode.colour;
    look.lightForm = mode.form;
    look.sunAzimuthDeg = 225.0f;
    look.sunElevationDeg = 40.0f;
    look.of(Species::graupel).albedo = 0.8f;
    for (SpeciesLook& field : look.species) field.noiseScaleCells = 3.0f;
    return look;
}

inline render::FrameInputs frame(const SpeciesVolume& volume, const Look& look,
                                 const CameraPose& pose, glm::ivec2 sizePx, int planes) {
    render::FrameInputs inputs;
    inputs.look = look;
    inputs.sizePx = sizePx;
    inputs.camera = placeCamera(pose, volume.grid, static_cast<double>(sizePx.x) / sizePx.y);
    inputs.planes = planes;
    return inputs;
}

}  // namespace neph::test
