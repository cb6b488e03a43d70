// levels.h: axes of grids: faces of cells in x and y, interfaces between levels in z. Metres.
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
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "readers/les/text.h"

namespace les {

/// Step of the cell centres of an even axis: every centre within 1 % of a step of its place.
/// Negative if they decrease; 0 for a single one. Nothing for any other axis.
std::optional<double> evenStep(std::span<const double> centresM);

/// Faces of cells that are not even, one more than `centresM`, the first at 0. Every centre is the
/// middle of its cell where that gives a smooth grid, else faces are halfway between centres.
/// `axis` is its name in messages. Throws Error if centres do not increase.
///
/// "In the middle" leaves one number open, which shifts all faces in turns up and down. It is what
/// the half of the inner faces agree on best for which the smooth curve through the centres says:
/// face = (5 (c₋₁ + c₀) − c₋₂ − c₁) / 8, exact for widths that change linearly, as CM1's do.
std::vector<double> facesOf(const std::string& axis, std::span<const double> centresM);

/// Moves faces so that the first is 0. Throws Error unless they increase. `what` names them.
void startAtZero(const std::string& what, std::vector<double>& faces);

/// Interfaces, one more than `centresM`, increasing. Throws Error if centres do not increase or
/// there are fewer than two.
std::vector<double> interfacesOf(std::span<const double> centresM);

/// Midpoints of neighbouring interfaces, one fewer than `interfacesM`.
std::vector<double> centresOf(std::span<const double> interfacesM);

}  // namespace les
