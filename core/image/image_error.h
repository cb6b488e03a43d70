// image_error.h: how far a linear image is from its reference, in numbers.
//
// Compares scene-referred radiance: premultiplied, background included, alpha ignored. Where an
// image consists of two independent halves, its noise is subtracted. docs/compare.md
#pragma once
#include <span>
#include <vector>

#include "core/image/image.h"

namespace neph {

/// An image and, if available, its two halves: independent images of equally many samples whose
/// mean the image is.
struct SampledImage {
    const ImageF& image;
    const ImageF* halfA = nullptr;
    const ImageF* halfB = nullptr;
    bool halved() const { return halfA != nullptr && halfB != nullptr; }
};

/// Errors of an image I against a reference R. Pure numbers: 0.01 is 1 %.
struct ImageErrors {
    double bias = 0.0;          ///< Σ(I-R) / ΣR over all pixels' R, G and B
    double biasSigma = 0.0;     ///< its standard error; 0 where nothing has halves
    double relRmse = 0.0;       ///< √mean (I-R)² / mean R over the same, without noise
    double relRmseRaw = 0.0;    ///< the same with noise
    double noise = 0.0;         ///< noise that was subtracted: raw² = rmse² + noise²
    double relRmseSigma = 0.0;  ///< how much noise may still have raised relRmse
    double relMse = 0.0;  ///< mean (I-R)² / (R² + (0.01 mean R)²) over the same, with noise
    double p95 = 0.0;     ///< 95 % of the brighter pixels have a smaller |I-R|/R, with noise
};

/// Luminance of linear RGB, Rec. 709. [BT709]
float luminance(const glm::vec4& colour);

/// Throws Error if the sizes differ, there are no pixels, a value is not finite or the reference is
/// black.
ImageErrors imageErrors(const SampledImage& image, const SampledImage& reference);

/// (I-R)/R of the luminance of each pixel, divided by 1 % of the maximum of R where R is darker
/// than that. Throws as imageErrors does.
std::vector<float> relativeErrors(const ImageF& image, const ImageF& reference);

/// Throws Error if the sizes differ, there are no pixels or a value is not finite.
void checkComparable(const ImageF& image, const ImageF& reference);

}  // namespace neph
