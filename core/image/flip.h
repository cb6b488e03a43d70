// flip.h: the difference that an observer sees between two pictures who flips from one to the
// other: LDR-FLIP [Andersson20] and HDR-FLIP [Andersson21].
//
// Per pixel from 0, no difference, to 1, the largest there is. Not quite symmetric for HDR, whose
// exposures are the reference's. docs/compare.md
#pragma once
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace neph {

/// Pixels that an observer has to a degree: 0.7 m before a screen 0.7 m wide that has 3840 of them.
/// [Andersson20]
inline constexpr double kFlipPixelsPerDegree =
    0.7 * (3840.0 / 0.7) * 3.14159265358979323846 / 180.0;

struct FlipMap {
    glm::ivec2 size{0};
    std::vector<float> errors;  ///< in [0, 1], row 0 on top
    double mean() const;
    double p95() const;
};

/// Exposures at which two pictures are looked at, in EV: from `start` to `stop`, both included.
struct FlipExposures {
    double start = 0.0, stop = 0.0;
    int count = 1;
};

/// From linear RGB, of which what is outside [0, 1] is clipped. Throws Error where sizes differ,
/// there are no pixels or a value is no finite number.
FlipMap ldrFlip(const ImageF& picture, const ImageF& reference,
                double pixelsPerDegree = kFlipPixelsPerDegree, const Progress& progress = {});

/// From where the reference's largest luminance comes to 0.85 of white to where its median does (of
/// what is not black, where most is), in steps of about 1 EV, two at least. Throws Error where the
/// reference is black.
FlipExposures flipExposures(const ImageF& reference);

/// The largest LDR-FLIP of each pixel over the exposures, each tone mapped with the fit of ACES.
/// Negative radiance counts as none. Throws the same as ldrFlip.
FlipMap hdrFlip(const ImageF& picture, const ImageF& reference, const FlipExposures& exposures,
                double pixelsPerDegree = kFlipPixelsPerDegree, const Progress& progress = {});

}  // namespace neph
