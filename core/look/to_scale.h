// to_scale.h: whether a look shows the water and ice of the data as they are: as much of each field
// as the model has, and how that takes and scatters light.
//
// Where the eye stands, what light falls on the cloud and how bright it is shown are choices that
// leave an image to scale.
#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/look/look.h"

namespace neph {

/// What decides about one field besides the look.
struct FieldOfData {
    bool anything = false;    ///< the shown time has some of it
    bool statesSize = false;  ///< the data say how large its particles are
    /// Where they do not, a constant radius between these is as good as any, m.
    double leastRadiusM = 0.0, mostRadiusM = std::numeric_limits<double>::infinity();
};

/// The data that a look is seen on; `scaleDataOf` in core/volume/scale_data.h has it of a volume.
struct ScaleData {
    std::array<FieldOfData, kSpeciesCount> fields{};
    double cellM = kLookCellM;  ///< native horizontal cell
};

/// Why the image is not to scale, a few words each: "cloud x0.02, rain x0.2", "light scattered
/// once". Empty where it is. docs/presets.md lists what counts.
std::vector<std::string> notToScale(const Look& look, const ScaleData& data);

/// "to scale", or "not to scale: cloud x0.02, rain x0.2; light scattered once", of such reasons.
std::string scaleText(const std::vector<std::string>& reasons);

}  // namespace neph
