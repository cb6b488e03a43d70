// reference_progress.cpp: errors to work.
#include "core/image/reference_progress.h"

#include <algorithm>

namespace neph {

bool isReached(const ReferenceProgress& progress) {
    return progress.samples >= 2 && progress.relativeError <= progress.targetError;
}

double workTo(double error, const ReferenceProgress& progress) {
    const double ratio = progress.relativeError / error;
    return ratio * ratio;
}

ReferenceProgress together(const ReferenceProgress& a, const ReferenceProgress& b) {
    if (a.samples == 0) return b;
    return {.samples = std::min(a.samples, b.samples),
            .relativeError = std::max(a.relativeError, b.relativeError),
            .targetError = std::min(a.targetError, b.targetError),
            .collisions = a.collisions + b.collisions,
            .scatterings = a.scatterings + b.scatterings,
            .faults = a.faults + b.faults,
            .seconds = a.seconds + b.seconds};
}

}  // namespace neph
