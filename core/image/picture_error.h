// picture_error.h: how far a linear picture is from its reference, in numbers.
//
// Of radiance before tone mapping, as it stands: premultiplied, background included, alpha left
// out. Where a picture is known twice from independent samples, its noise is taken off.
// docs/compare.md
#pragma once
#include <span>
#include <vector>

#include "core/image/image.h"

namespace neph {

/// A picture, and its two halves where it has them: means of equally many samples that are
/// independent of each other, whose mean the picture is.
struct SampledPicture {
    const ImageF& picture;
    const ImageF* halfA = nullptr;
    const ImageF* halfB = nullptr;
    bool halved() const { return halfA != nullptr && halfB != nullptr; }
};

/// Of a picture I against a reference R. Pure numbers: 0.01 is 1 %.
struct PictureErrors {
    double bias = 0.0;          ///< Σ(I-R) / ΣR over all pixels' R, G and B
    double biasSigma = 0.0;     ///< its standard error; 0 where nothing has halves
    double relRmse = 0.0;       ///< √mean (I-R)² / mean R over the same, without noise
    double relRmseRaw = 0.0;    ///< with it
    double noise = 0.0;         ///< that was taken off, so that raw² = rmse² + noise²
    double relRmseSigma = 0.0;  ///< by which noise may still have raised relRmse
    double relMse = 0.0;  ///< mean (I-R)² / (R² + (0.01 mean R)²) over the same, with noise
    double p95 = 0.0;     ///< 95 % of the brighter pixels have a smaller |I-R|/R, with noise
};

/// Rec. 709. [BT709]
float luminance(const glm::vec4& colour);

/// Throws Error where the sizes differ, there are no pixels, a value is no finite number or the
/// reference is black.
PictureErrors pictureErrors(const SampledPicture& picture, const SampledPicture& reference);

/// (I-R)/R of the luminance of each pixel; where R is less than 1 % of its maximum, that is what is
/// divided by. Throws the same.
std::vector<float> relativeErrors(const ImageF& picture, const ImageF& reference);

/// The smallest of `values` that `share` of them do not exceed. There is at least one.
double quantile(std::span<const float> values, double share);

/// Throws Error where the sizes differ, there are no pixels or a value is no finite number.
void checkComparable(const ImageF& picture, const ImageF& reference);

}  // namespace neph
