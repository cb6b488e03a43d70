// species.h: the hydrometeors, and the volume that holds them on a regular grid.
//
// Radii are those of [Riley03] table 3, colours those of its table 2; particle densities are from
// docs/physics.md. Hail is not in the paper: its radius is the smallest that counts as hail (stones
// of 5 mm diameter, [AMS]), its density that of Morrison's scheme. Radii of phase functions are
// tuned by eye: droplets of cloud and of drizzle, crystals of cirrus. The accessible colours are
// those of [OkabeIto08] that are nearest to the others: vermillion for red, reddish purple for
// magenta, blue, yellow, bluish green for green, sky blue for cyan.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid/grid.h"

namespace neph {

#include "shaders/shared/sizes.glsl"

/// The hydrometeors that a volume can hold; values are indices into arrays.
enum class Species : int { cloud, ice, rain, snow, graupel, hail };

/// Properties of a species that do not depend on the data.
struct SpeciesInfo {
    std::string_view id;          ///< spelling in parameter ids and JSON
    std::string_view label;       ///< spelling on screen
    bool liquid;                  ///< water droplets; otherwise ice particles
    float radiusM;                ///< equivalent spherical radius
    float densityKgPerM3;         ///< of one particle
    float phaseRadiusM;           ///< effective radius of the default phase function
    std::array<float, 3> colour;  ///< linear RGB of the field-colour mode
    std::array<std::uint8_t, 3> accessibleColour;  ///< sRGB, for any common colour blindness
};

/// In the order of Species.
inline constexpr auto kSpecies = std::to_array<SpeciesInfo>({
    {"cloud", "Cloud", true, 10e-6f, 1000.0f, 10e-6f, {1.0f, 0.05f, 0.05f}, {213, 94, 0}},
    {"ice", "Ice", false, 1e-3f, 917.0f, 30e-6f, {1.0f, 0.05f, 1.0f}, {204, 121, 167}},
    {"rain", "Rain", true, 1e-3f, 1000.0f, 25e-6f, {0.08f, 0.12f, 1.0f}, {0, 114, 178}},
    {"snow", "Snow", false, 2e-3f, 100.0f, 30e-6f, {1.0f, 0.9f, 0.05f}, {240, 228, 66}},
    {"graupel", "Graupel", false, 2.5e-3f, 400.0f, 30e-6f, {0.05f, 0.8f, 0.1f}, {0, 158, 115}},
    {"hail", "Hail", false, 2.5e-3f, 900.0f, 30e-6f, {0.05f, 0.85f, 0.9f}, {86, 180, 233}},
});
static_assert(kSpecies.size() == kSpeciesCount);

constexpr const SpeciesInfo& info(Species s) {
    return kSpecies[static_cast<std::size_t>(s)];
}

/// How a volume holds a species.
enum class Holding : int { absent, content, extinction };

/// Every hydrometeor on one regular grid at one time: the input of the renderer. Owns its data.
///
/// A species is held in one of two ways: as mass content where its particles have one size in the
/// whole volume, or as extinction where their size comes from the model and so varies from cell to
/// cell. Both are additive, so remapping and averaging conserve their column integrals.
struct SpeciesVolume {
    RegularGrid grid;
    double nativeCellM = 0.0;  ///< horizontal cell of the data before averaging; 0: the grid's own
    /// kg of hydrometeor per m³ of air, size `grid.size`, or empty.
    std::array<Array3f, kSpeciesCount> contentKgPerM3{};
    /// Extinction coefficient, 1/m, size `grid.size`, or empty. For a mixing scale of 1.
    std::array<Array3f, kSpeciesCount> extinctionPerM{};
    std::string timeLabel;
    double timeSeconds = 0.0;        ///< since the first time of the series
    std::vector<std::string> notes;  ///< what was clipped, masked or assumed, one sentence each

    /// The unit of lengths that a look gives in cells.
    double cellM() const {
        return nativeCellM > 0.0 ? nativeCellM : meanCellM(glm::dvec2(grid.spacingM));
    }
    /// False where the model has no such species.
    bool has(Species s) const { return holding(s) != Holding::absent; }
    Holding holding(Species s) const {
        if (holdsExtinction(s)) return Holding::extinction;
        return content(s).empty() ? Holding::absent : Holding::content;
    }
    std::array<Holding, kSpeciesCount> holdings() const;
    bool holdsExtinction(Species s) const { return !extinction(s).empty(); }
    const Array3f& content(Species s) const { return contentKgPerM3[static_cast<std::size_t>(s)]; }
    const Array3f& extinction(Species s) const {
        return extinctionPerM[static_cast<std::size_t>(s)];
    }
    /// Memory of the fields, for the volume cache.
    std::size_t bytes() const;
};

}  // namespace neph
