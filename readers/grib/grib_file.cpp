// grib_file.cpp: the description of a file, and its values level by level.
#include "readers/grib/grib_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace grib {

std::vector<float> GribFile::layerOf(const Quantity& quantity, const Layer& layer) const {
    switch (quantity.source) {
        case Source::interfaceHeight:
            return air_.interface(layer);
        case Source::airPressure:
            return air_.pressure(layer);
        case Source::airTemperature:
            return air_.temperature(layer);
        case Source::dryAirDensity:
            return air_.density(layer);
        case Source::vapour:
            return air_.vapour(layer);
        case Source::stored:
        case Source::perMoistAir:
            break;
    }
    std::vector<float> values = air_.stored(quantity.parameter, layer);
    if (quantity.source == Source::perMoistAir) {
        const std::vector<float> ratio = air_.vapour(layer);
        for (std::size_t i = 0; i < ratio.size(); ++i) values[i] *= 1.0f + ratio[i];
    }
    if (quantity.role == NEPH_ROLE_MIXING_RATIO) air_.clearBelowGround(layer, values);
    return values;
}

void GribFile::read(const neph::plugin::Request& request) {
    if (request.time != timeRead_) reader_.clear();
    timeRead_ = request.time;
    const Quantity& quantity = quantities_.at(request.variable);
    Layer layer{request.time, 0, {}};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        layer.columns.lower[axis] = request.lower[axis];
        layer.columns.upper[axis] = request.upper[axis];
    }
    float* to = request.values;
    for (std::size_t z = request.lower[2]; z < request.upper[2]; ++z) {
        request.tick(static_cast<double>(z - request.lower[2]) /
                     static_cast<double>(request.length(2)));
        layer.level = z;
        to = std::ranges::copy(layerOf(quantity, layer), to).out;
    }
    request.tick(1.0);
}

}  // namespace grib
