// number_text.h: numbers as people write them.
#pragma once
#include <string>

namespace neph {

/// With up to `digits` significant digits and no zeros behind the point: 0.5, 10000, 2.5e-07.
/// Powers of ten where more than six digits or three zeros would stand before them.
std::string numberText(double value, int digits = 4);

/// Of a share and its standard error, 0 where it is not known: "-3.2 ± 0.02 %", with as many
/// decimals as have meaning.
std::string percentText(double share, double sigma = 0.0);

}  // namespace neph
