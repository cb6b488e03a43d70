// forward_peak.h: light scattered forward, which full transport counts as not scattered, as the eye
// sees it around the sun.
//
// Delta-M takes a share f = chi_L of what is scattered for a peak in which light goes on as it
// came, with moments 1 up to L and chi_l / f beyond. Light that is scattered by it m times, and by
// nothing else, has the moments (peak_l)^m: it is seen further off from the sun. docs/transport.md
#pragma once
#include <span>
#include <vector>

#include "core/optics/phase.h"

namespace neph {

/// One for each of `times`: f times the phase function of light that was scattered so often by the
/// peak of `phase` beyond degree L, `degree`. The peak of delta-M has rings, which stand for
/// nothing: it fades out where the first would begin, 180 degrees / L from forward, and at 60
/// degrees at most, beyond which there is little of it. Unit and angles are those of `phase`. All
/// zero where there is no peak.
std::vector<PhaseTable> peaksOf(const PhaseTable& phase, int degree, std::span<const double> times);

}  // namespace neph
