// lowest_air.h: humidity and aerosol of the air at the ground, which haze can follow.
#pragma once
#include <optional>
#include <string>

#include "core/dataset/dataset.h"

namespace neph {

/// Of one time.
struct LowestAir {
    /// The mean over the domain, by area, of the relative humidity of the layer at the ground, over
    /// water; what is supersaturated counts as 1. Empty where it is not known.
    std::optional<double> humidity;
    std::string reason;  ///< why it is not: "the data have no water vapour"
    /// The mean in the same way of the extinction at 550 nm of the model's aerosol, 1/m, each cell
    /// at its own humidity (core/optics/aerosol.h). Empty where it or the humidity is not known.
    std::optional<double> aerosolPerM = {};
    std::string noAerosol = {};  ///< why it is not
};

/// Reads the lowest native layer of vapour, pressure and temperature, and of aerosol where the data
/// have it. Throws Cancelled.
LowestAir readLowestAir(Dataset& dataset, int time, const Progress& progress = {});

}  // namespace neph
