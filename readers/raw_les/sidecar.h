// sidecar.h: the JSON beside a bare brick of numbers, type "nephoscope-brick"; docs/raw-les.md is
// its schema.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/raw_values.h"

namespace raw {

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

struct BrickVariable {
    std::string name, unit, description;
    BrickRole role = BrickRole::other;
    NephSpecies species = NEPH_SPECIES_NONE;
    NumberType type = NumberType::float32;
    double scale = 1.0, offset = 0.0;  ///< from the file's number to `unit`
    std::optional<double> missing;
    std::uint64_t firstByte = 0;
    /// One for all times or one a time, as written; empty where the variable is zero everywhere.
    std::vector<std::string> files;
    std::vector<double> profile;  ///< instead of files: one value a level, in `unit`
};

struct Sidecar {
    std::string model, scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    std::array<std::size_t, 3> shape{};  ///< x, y, z
    std::array<double, 2> spacingM{};
    std::vector<double> interfacesM;
    bool bigEndian = false;
    std::vector<neph::plugin::Time> times;
    std::vector<BrickVariable> variables;
    std::vector<std::string> notes;
};

/// Total: any text gives a Sidecar whose numbers are finite and whose sizes fit together, or an
/// Error that names the key.
Sidecar parseSidecar(std::string_view text);

/// Whether the start of a file could be one: cheap, no Error.
bool looksLikeSidecar(std::string_view text);

}  // namespace raw
