// comparison.h: pictures beside a reference: what is compared, the figures, and how they are told.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/cli/render/reference_channels.h"
#include "core/image/error_picture.h"
#include "core/image/flip.h"
#include "core/image/picture_error.h"

namespace neph {

/// A picture that is compared, or the reference.
struct ComparedPicture {
    std::string name;      ///< file, or engine as typed
    bool display = false;  ///< as a screen shows it: decoded, not radiance
    ImageF picture;
    std::optional<Halves> halves;
    std::string made;               ///< how, where that is known: engine, samples, device
    std::string device;             ///< GL renderer string, where it was drawn here
    std::optional<int> samples;     ///< a pixel, where it was drawn here
    std::optional<double> seconds;  ///< likewise
    SampledPicture sampled() const {
        return {picture, halves ? &halves->a : nullptr, halves ? &halves->b : nullptr};
    }
};

/// The figures of one picture against the reference.
struct Comparison {
    PictureErrors errors;
    FlipMap flip;
    std::optional<FlipExposures> exposures;  ///< none: LDR-FLIP
};

/// With LDR-FLIP for pictures of displays, HDR-FLIP for radiance: at the reference's exposures, or
/// at `exposureEv` alone. Throws Error where the two are not of one kind, or as pictureErrors.
Comparison compare(const ComparedPicture& picture, const ComparedPicture& reference,
                   const std::optional<double>& exposureEv);

/// An aligned table of all pictures, with what the figures mean below.
std::string comparisonText(const std::vector<ComparedPicture>& pictures,
                           const std::vector<Comparison>& comparisons,
                           const ComparedPicture& reference);

/// The same as JSON, indented.
std::string comparisonJson(const std::vector<ComparedPicture>& pictures,
                           const std::vector<Comparison>& comparisons,
                           const ComparedPicture& reference);

/// Relative errors of the luminance as colours, to `most` or to a round number that fits.
Image8 relativeErrorPicture(const ComparedPicture& picture, const ComparedPicture& reference,
                            bool bothSigns, const std::optional<double>& most);

/// FLIP as colours.
Image8 flipPicture(const Comparison& comparison);

}  // namespace neph
