// flip.h: the difference that an observer sees when alternating between two images: LDR-FLIP
// [Andersson20] and HDR-FLIP [Andersson21].
//
// Per pixel, from 0 (no difference) to 1 (the largest possible). HDR-FLIP is not quite symmetric,
// because its exposures are those of the reference. docs/compare.md
#pragma once
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace neph {

/// Pixels per degree of an observer 0.7 m from a screen that is 0.7 m and 3840 pixels wide.
/// [Andersson20]
inline constexpr double kFlipPixelsPerDegree =
    0.7 * (3840.0 / 0.7) * 3.14159265358979323846 / 180.0;

/// FLIP of every pixel, and its summary over the image.
struct FlipMap {
    glm::ivec2 size{0};
    std::vector<float> errors;  ///< in [0, 1], row 0 on top
    double mean() const;
    double p95() const;
};

/// Exposures at which two images are compared, in EV: from `start` to `stop`, both included.
struct FlipExposures {
    double start = 0.0, stop = 0.0;
    int count = 1;
};

/// Of linear RGB images; values outside [0, 1] are clipped. Throws Error if sizes differ, there are
/// no pixels, or a value is not finite.
FlipMap ldrFlip(const ImageF& image, const ImageF& reference,
                double pixelsPerDegree = kFlipPixelsPerDegree, const Progress& progress = {});

/// From the exposure that maps the reference's largest luminance to 0.85 of white to the one that
/// maps its median there (median of the non-black pixels where most are black), in steps of about 1
/// EV, at least two. Throws Error if the reference is black.
FlipExposures flipExposures(const ImageF& reference);

/// The largest LDR-FLIP of each pixel over the exposures, each tone mapped with the ACES fit.
/// Negative radiance counts as zero. Throws as ldrFlip does.
FlipMap hdrFlip(const ImageF& image, const ImageF& reference, const FlipExposures& exposures,
                double pixelsPerDegree = kFlipPixelsPerDegree, const Progress& progress = {});

}  // namespace neph
