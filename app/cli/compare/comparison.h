// comparison.h: images beside a reference: what is compared, the figures, and how they are told.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/cli/render/reference_channels.h"
#include "core/image/error_image.h"
#include "core/image/flip.h"
#include "core/image/image_error.h"

namespace neph {

/// An image that is compared, or the reference.
struct ComparedImage {
    std::string name;      ///< file, or engine as typed
    bool display = false;  ///< as a screen shows it: decoded, not radiance
    ImageF image;
    std::optional<Halves> halves;
    std::string made;               ///< how, where that is known: engine, samples, device
    std::string scale;              ///< whether to scale, where that is known: scaleText()
    std::string device;             ///< GL renderer string, where it was drawn here
    std::optional<int> samples;     ///< a pixel, where it was drawn here
    std::optional<double> seconds;  ///< likewise
    SampledImage sampled() const {
        return {image, halves ? &halves->a : nullptr, halves ? &halves->b : nullptr};
    }
};

/// The figures of one image against the reference.
struct Comparison {
    ImageErrors errors;
    FlipMap flip;
    std::optional<FlipExposures> exposures;  ///< none: LDR-FLIP
};

/// With LDR-FLIP for images of displays, HDR-FLIP for radiance: at the reference's exposures, or
/// at `exposureEv` alone. Throws Error where the two are not of one kind, or as imageErrors.
Comparison compare(const ComparedImage& image, const ComparedImage& reference,
                   const std::optional<double>& exposureEv);

/// An aligned table of all images, with what the figures mean below.
std::string comparisonText(const std::vector<ComparedImage>& images,
                           const std::vector<Comparison>& comparisons,
                           const ComparedImage& reference);

/// The same as JSON, indented.
std::string comparisonJson(const std::vector<ComparedImage>& images,
                           const std::vector<Comparison>& comparisons,
                           const ComparedImage& reference);

/// Relative errors of the luminance as colours, to `most` or to a round number that fits.
Image8 relativeErrorImage(const ComparedImage& image, const ComparedImage& reference,
                          bool bothSigns, const std::optional<double>& most);

/// FLIP as colours.
Image8 flipImage(const Comparison& comparison);

}  // namespace neph
