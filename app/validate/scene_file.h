// scene_file.h: a validation case in JSON: a medium, experiments on it, and the expected results.
//
// The schema is in docs/validation.md. Files are untrusted: unknown keys, and values outside their
// range, are errors. Angles describe the direction in which light travels: zenith from the
// vertical, azimuth from +x towards +y.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// A radiance: light that leaves the top upwards, or the bottom downwards.
struct View {
    std::string name;
    bool top = true;
    double zenithDeg = 0.0, azimuthDeg = 0.0;
    /// Part of the top or the bottom that it is the mean of, m; otherwise all.
    std::optional<std::array<glm::dvec2, 2>> area;
};

/// Measured of the whole or of a column; see trialsOf.
enum class Flux : int { reflected, transmitted, direct, diffuse, absorbed, balance };
inline constexpr std::array<std::string_view, 6> kFluxNames{"R",         "T", "T_direct",
                                                            "T_diffuse", "A", "balance"};

/// What the file expects of a quantity, by its name.
struct NamedExpected {
    std::string quantity;
    Expected expected;
};

/// Illumination and detectors.
struct Experiment {
    std::string name;
    render::MeterScene scene;  ///< without its fields, which all experiments share
    std::vector<Flux> fluxes;
    std::vector<View> views;
    bool perColumn = false;  ///< also measure each column by itself
    std::vector<NamedExpected> expected;
};

/// A parsed file.
struct SceneFile {
    std::string name, source;
    bool quick = true;  ///< part of a quick run
    std::vector<render::MeterField> fields;
    std::vector<Experiment> experiments;
};

/// `where` begins the messages. Files named in the text are relative to `folder`. Throws Error.
SceneFile parseSceneFile(std::string_view text, const std::string& where,
                         const std::filesystem::path& folder);

/// Reads and parses a file. Throws Error.
SceneFile loadSceneFile(const std::filesystem::path& file);

/// The measurements that a file asks for. Fluxes are shares of the light incident on the top;
/// radiances are π I divided by the same light, as in I3RC [Cahalan05]. Throws Error if a quantity
/// is expected that no detector measures.
std::vector<Trial> trialsOf(const SceneFile& file, const std::string& where);

}  // namespace neph::validate
