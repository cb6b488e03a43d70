// sidecar.h: the JSON file that describes bricks of numbers, type "nephoscope-brick". The schema is
// in docs/raw-les.md.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/raw_values.h"

namespace les {

enum class BrickRole {
    other,
    mixingRatio,
    numberConcentration,
    effectiveRadius,
    dryAirDensity,
    airPressure,
    airTemperature,
    potentialTemperature,
    vapourMixingRatio
};

/// One variable as the sidecar states it; units are not converted yet.
struct BrickVariable {
    std::string name, unit, description;
    BrickRole role = BrickRole::other;
    NephSpecies species = NEPH_SPECIES_NONE;
    NumberType type = NumberType::float32;
    double scale = 1.0, offset = 0.0;  ///< value in `unit` = scale · number + offset
    std::optional<double> missing;
    std::uint64_t firstByte = 0;
    /// One file for all times or one per time, relative to the sidecar; an empty name means zero
    /// everywhere.
    std::vector<std::string> files;
    std::vector<double> profile;  ///< instead of files: one value per level, in `unit`
};

/// A parsed sidecar.
struct Sidecar {
    std::string model, scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    std::array<std::size_t, 3> shape{};  ///< x, y, z
    std::array<double, 2> spacingM{};
    std::array<std::vector<double>, 2> edgesM{};  ///< faces of uneven cells, the first at 0
    std::vector<double> interfacesM;
    bool bigEndian = false;
    std::string projection;  ///< PROJ string that shows the middle of the grid at 0, 0; or empty
    std::string utcOfZero;   ///< when `seconds` are 0; or empty
    std::vector<neph::plugin::Time> times;
    std::vector<BrickVariable> variables;
    std::vector<std::string> notes;
};

/// Any text gives a Sidecar with finite numbers and consistent sizes, or an Error that names the
/// key.
Sidecar parseSidecar(std::string_view text);

/// Whether a text could be a sidecar. Cheap; never throws.
bool looksLikeSidecar(std::string_view text);

}  // namespace les
