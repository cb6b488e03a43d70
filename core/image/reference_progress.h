// reference_progress.h: how far an engine that converges has come with an image: one set of figures
// for the renderer, the window, the commands and their files.
#pragma once
#include <cstdint>
#include <limits>

namespace neph {

/// How far an engine that converges has come with an image.
struct ReferenceProgress {
    int samples = 0;  ///< paths per pixel
    /// Relative standard error: root mean variance of the pixels over their mean; infinite before
    /// there are two samples.
    double relativeError = std::numeric_limits<double>::infinity();
    double targetError = 0.0;       ///< at which it may rest; 0: no target
    std::uint64_t collisions = 0;   ///< collisions, real and null
    std::uint64_t scatterings = 0;  ///< particles that scattered
    std::uint64_t faults = 0;       ///< paths whose radiance was no number, counted as 0
    double seconds = 0.0;           ///< of work
};

/// Whether the target is reached. One sample has no known error.
bool isReached(const ReferenceProgress& progress);

/// The work that leads to an error, in multiples of the work so far: the error falls with the
/// square root of the number of samples.
double workTo(double error, const ReferenceProgress& progress);

/// Of two parts of one image: the worse, and the work of both. A part without samples does not
/// count.
ReferenceProgress together(const ReferenceProgress& a, const ReferenceProgress& b);

}  // namespace neph
