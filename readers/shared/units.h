// units.h: conversion of units as data files spell them, by the UDUNITS-2 library.
#pragma once
#include <optional>
#include <string_view>

namespace shared {

/// value in the wanted unit = scale · value + offset.
struct Conversion {
    double scale = 1.0, offset = 0.0;
    double operator()(double value) const { return scale * value + offset; }
    bool isIdentity() const { return scale == 1.0 && offset == 0.0; }
};

/// Conversion from the unit `from` to the unit `to`; nothing if `from` is no unit or one of another
/// kind. Beside what UDUNITS knows, spellings of model output are understood: "  kg(-1)" of WRF,
/// "#/kg" of CM1, "-" for a pure number, and, where pressure or temperature is wanted, "mb" and
/// "C", which UDUNITS takes for millibarn and coulomb. Thread-safe.
std::optional<Conversion> conversion(std::string_view from, std::string_view to);

}  // namespace shared
