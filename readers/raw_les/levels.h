// levels.h: axes of grids: even spacing in x and y, interfaces between levels in z. Metres.
//
// Raw output gives the centres of layers; the host wants their borders. Models put each centre half
// way between two interfaces (CM1, MicroHH), the lowest of which is the ground, so that every
// interface mirrors the one below in the centre between them. That recovers a stretched grid
// exactly, but a wrong start makes layers thick and thin in turn; therefore:
//   1. evenly spaced centres: interfaces lie half a step from them;
//   2. else the mirrored ones from 0 m up, where each is within 5 % of the local spacing from half
//      way between its neighbours, as it is for any grid that stretches by less than 20 % a level;
//   3. else half way between centres, the outermost a half step beyond, not below ground.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "readers/raw_les/text.h"

namespace raw {

/// Distance between neighbours of `count` positions `at(i)`. They must change steadily in one
/// direction, by the same step to 0.1 %: the host's cells do. Negative where they decrease; 0 for a
/// single one. `axis` is for messages. Throws Error.
double evenSpacing(const std::string& axis, std::size_t count,
                   const std::function<double(std::size_t)>& at);

/// Interfaces, one more than `centresM`, increasing. Throws Error where centres do not increase.
std::vector<double> interfacesOf(std::span<const double> centresM);

std::vector<double> centresOf(std::span<const double> interfacesM);

}  // namespace raw
