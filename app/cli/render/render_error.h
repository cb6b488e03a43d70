// render_error.h: the error of an image that `render` has drawn, in words and for its file.
#pragma once
#include <optional>
#include <string>

#include "app/cli/render/bands.h"
#include "core/image/measured_error.h"

namespace neph {

/// Of an image of one side, all of whose rows were drawn since average(): traces the reference for
/// `seconds` at most. None where it cannot be compared, which is printed. Throws Cancelled.
std::optional<MeasuredError> errorOf(const Bands& bands, double seconds, const Progress& progress);

/// As metadata: a JSON object of shares, size and paths per pixel, with the names that `compare
/// --json` has for them.
std::string errorJson(const MeasuredError& measured);

}  // namespace neph
