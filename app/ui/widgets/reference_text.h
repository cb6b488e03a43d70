// reference_text.h: how far the reference has come with an image, in words.
#pragma once
#include <optional>
#include <string>

#include "core/image/reference_progress.h"

namespace neph::ui {

/// Of work to come, from the samples there were. None before it is known, or once the target is
/// reached.
std::optional<double> secondsToTarget(const ReferenceProgress& progress);

/// "40 s", "2 min", "3 h", "12 days", of which nobody wants to know more.
std::string roughDuration(double seconds);

/// "37 samples per pixel, error 8.1 %, about 2 min to 2 %".
std::string referenceText(const ReferenceProgress& progress);

/// "Denoised preview", the same "of 16 samples per pixel", and what that means.
inline constexpr const char* kPreviewName = "Denoised preview";
std::string previewText(int samples);
std::string previewMeaning();

}  // namespace neph::ui
