// native_levels.h: what of a model's heights decides the levels of a regular grid.
#pragma once

namespace neph {

/// Of one run at one time, or of several that are to share a grid; metres above sea level.
struct NativeLevels {
    double lowestM = 0.0, highestM = 0.0;  ///< of the interfaces of all columns
    double medianDepthM = 0.0;             ///< of the layers
    bool operator==(const NativeLevels&) const = default;
};

}  // namespace neph
