// levels.h: axes of grids: even spacing in x and y, interfaces between levels in z. Metres.
//
// Raw output gives the centres of layers; the host needs their interfaces. CM1 and MicroHH place
// each centre halfway between two interfaces, the lowest of which is the ground, so every interface
// is the mirror image of the one below in the centre between them. This recovers a stretched grid
// exactly, but a wrong start makes layers alternately too thick and too thin. Therefore:
//   1. Evenly spaced centres: interfaces are half a step away from them.
//   2. Otherwise mirrored from 0 m upwards, if each interface is within 5 % of the local spacing of
//      the midpoint between its centres. This holds for any grid that stretches by less than 20 %
//      per level.
//   3. Otherwise halfway between centres, the outermost half a step beyond, but not below ground.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "readers/raw_les/text.h"

namespace raw {

/// Step of `count` positions `at(i)`, which must be equal everywhere to 0.1 %, because the host's
/// cells are. Negative if positions decrease; 0 for a single one. `axis` is its name in messages.
/// Throws Error.
double evenSpacing(const std::string& axis, std::size_t count,
                   const std::function<double(std::size_t)>& at);

/// Interfaces, one more than `centresM`, increasing. Throws Error if centres do not increase or
/// there are fewer than two.
std::vector<double> interfacesOf(std::span<const double> centresM);

/// Midpoints of neighbouring interfaces, one fewer than `interfacesM`.
std::vector<double> centresOf(std::span<const double> interfacesM);

}  // namespace raw
