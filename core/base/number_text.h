// number_text.h: numbers formatted for people.
#pragma once
#include <string>

namespace neph {

/// Up to `digits` significant digits without trailing zeros: 0.5, 10000, 2.5e-07. Uses powers of
/// ten below 1e-4 and from 1e7 up.
std::string numberText(double value, int digits = 4);

/// A share and its standard error (0 if unknown) in percent: "-3.20 ± 0.15 %", with as many
/// decimals as are meaningful.
std::string percentText(double share, double sigma = 0.0);

}  // namespace neph
