// scene_file.h: a case of validation kept as JSON: a medium, experiments on it, and what is
// expected of them.
//
// The schema is in docs/validation.md. Files are untrusted: unknown keys, sizes and ranges are
// errors. Angles are of the way light travels: zenith from the vertical, azimuth from +x towards
// +y.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// Light that leaves the top upwards, or the bottom downwards.
struct View {
    std::string name;
    bool top = true;
    double zenithDeg = 0.0, azimuthDeg = 0.0;
};

struct NamedExpected {
    std::string quantity;
    Expected expected;
};

struct Experiment {
    std::string name;
    render::MeterScene scene;  ///< without its fields
    std::vector<std::string> fluxes;
    std::vector<View> views;
    bool perColumn = false;
    std::vector<NamedExpected> expected;
};

struct SceneFile {
    std::string name, source;
    bool quick = true;
    std::vector<render::MeterField> fields;
    std::vector<Experiment> experiments;
};

/// `where` opens the messages; files that the text names are looked for in `folder`. Throws Error.
SceneFile parseSceneFile(std::string_view text, const std::string& where,
                         const std::filesystem::path& folder);

/// Throws Error.
SceneFile loadSceneFile(const std::filesystem::path& file);

/// What is to be measured. Fluxes are shares of the light that falls on the top, radiances are
/// pi I over that light: as I3RC has them. Throws Error where a quantity is expected that no
/// detector gives.
std::vector<Trial> trialsOf(const SceneFile& file, const std::string& where);

}  // namespace neph::validate
