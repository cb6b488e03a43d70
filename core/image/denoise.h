// denoise.h: a preview of what a noisy image will look like, from its two halves.
//
// An edge-avoiding filter of holes [Dammertz10], guided by the noise as in [Schied17]. It looks
// smooth but is not unbiased: no figure may come from it, and no half is changed. docs/compare.md
#pragma once
#include <cstddef>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace neph {

/// Threads that are worth it, at most.
inline constexpr std::size_t kMostDenoisers = 16;

/// The mean of two independent halves, of equally many samples each, with less noise: each half is
/// averaged over pixels that the other half does not tell apart from its own. A pixel where the
/// halves differ by five times the noise around hardly counts, and its light is missing. Where the
/// halves agree the mean is left as it is, and so is alpha. Both are linear and of one size; values
/// are finite. Pixels are shared out to `threads`, whose number does not change the result.
/// `progress` is asked now and then, with shares of parts of the work; throws Cancelled.
ImageF denoised(const ImageF& halfA, const ImageF& halfB, std::size_t threads = 1,
                const Progress& progress = {});

}  // namespace neph
