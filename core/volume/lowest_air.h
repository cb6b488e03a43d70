// lowest_air.h: the humidity of the air at the ground, which haze can follow.
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
};

/// Reads the lowest native layer of vapour, pressure and temperature. Throws Cancelled.
LowestAir readLowestAir(Dataset& dataset, int time, const Progress& progress = {});

}  // namespace neph
