// air.cpp: equations of docs/physics.md §7, with the same constants as the WRF reader.
#include "readers/grib/air.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grib {
namespace {

constexpr float kGravity = 9.80665f;             // m/s², WMO code table 4.2, geopotential height
constexpr float kReferencePressure = 1.0e5f;     // Pa, WRF share/module_model_constants.F
constexpr float kDryGasConstant = 287.0f;        // J/(kg K), r_d there
constexpr float kKappa = 2.0f / 7.0f;            // r_d / cp there
constexpr float kVapourRatio = 461.6f / 287.0f;  // r_v / r_d there
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A choice: from here up air holds less than some 1e-5 kg/kg of vapour, which is nothing here, and
// relative humidity over water, as analyses state it there, would give impossible values.
constexpr float kDryAbovePressure = 1.0e4f;  // Pa

// What stands in cells that the model masked below the ground, where nothing is drawn: the
// sea-level temperature of the standard atmosphere (ISO 2533), and the scale height that goes with
// it.
constexpr float kMaskedTemperature = 288.15f;                      // K
constexpr float kMaskedScaleHeight = 287.0f * 288.15f / 9.80665f;  // m

constexpr Parameter kTheta{0, 0, 2}, kVirtualTheta{0, 0, 15}, kGeopotential{0, 3, 4};
constexpr Parameter kSpecificHumidity{0, 1, 0}, kMixingRatio{0, 1, 2}, kRelativeHumidity{0, 1, 1},
    kDewPoint{0, 0, 6};

/// Pressure of saturated vapour over water in Pa at a temperature in K. [Bolton80] eq. 10
float saturation(float temperature) {
    const float celsius = temperature - 273.15f;
    return 611.2f * std::exp(17.67f * celsius / (celsius + 243.5f));
}

/// NaN for vapour that the host would refuse, and none below zero.
float possibleVapour(float ratio) {
    const bool possible = ratio >= static_cast<float>(NEPH_LEAST_VAPOUR_KG_PER_KG) &&
                          ratio <= static_cast<float>(NEPH_MOST_VAPOUR_KG_PER_KG);
    return possible ? std::max(ratio, 0.0f) : kNan;
}

bool isPossible(float pressure, float temperature) {
    return pressure >= static_cast<float>(NEPH_LEAST_PRESSURE_PA) &&
           pressure <= static_cast<float>(NEPH_MOST_PRESSURE_PA) &&
           temperature >= static_cast<float>(NEPH_LEAST_TEMPERATURE_K) &&
           temperature <= static_cast<float>(NEPH_MOST_TEMPERATURE_K);
}

Layer atLevel(Layer layer, std::size_t level) {
    layer.level = level;
    return layer;
}

}  // namespace

Air::Values Air::stored(const Parameter& parameter, const Layer& layer) const {
    Values values(layer.columns.count());
    const Stack* stack = contents_.find(parameter);
    const std::size_t field = stack == nullptr ? kNoField : stack->at(layer.time).at(layer.level);
    if (field == kNoField) {
        std::ranges::fill(values, kNan);
    } else {
        reader_.read(field, layer.columns, values);
    }
    return values;
}

Air::Values Air::heightOfCentre(const Layer& layer) const {
    Values height = stored(contents_.height, layer);
    if (contents_.height == kGeopotential) {
        for (float& value : height) value /= kGravity;
    }
    if (contents_.surface != kIsobaric) return height;
    const auto isMissing = [](float value) { return std::isnan(value); };
    const double pressureHere = contents_.levels[layer.level];
    for (std::size_t level = layer.level + 1;
         level < contents_.levels.size() && std::ranges::any_of(height, isMissing); ++level) {
        const Values above = stored(contents_.height, atLevel(layer, level));
        const double depths = std::log(pressureHere / contents_.levels[level]);
        const float scale = contents_.height == kGeopotential ? 1.0f / kGravity : 1.0f;
        for (std::size_t i = 0; i < height.size(); ++i) {
            if (!std::isnan(height[i])) continue;
            height[i] = scale * above[i] - kMaskedScaleHeight * static_cast<float>(depths);
        }
    }
    return height;
}

std::vector<bool> Air::maskedCells(const Layer& layer) const {
    if (contents_.surface != kIsobaric) return {};
    const Values height = stored(contents_.height, layer);
    std::vector<bool> masked(height.size());
    bool any = false;
    for (std::size_t i = 0; i < height.size(); ++i) {
        masked[i] = std::isnan(height[i]);
        any = any || masked[i];
    }
    return any ? masked : std::vector<bool>();
}

void Air::fillMasked(const Layer& layer, std::span<float> values, float with) const {
    const std::vector<bool> masked = maskedCells(layer);
    for (std::size_t i = 0; i < masked.size(); ++i) {
        if (masked[i]) values[i] = with;
    }
}

Air::Values Air::pressure(const Layer& layer) const {
    if (contents_.surface == kHybrid) return stored(contents_.pressure, layer);
    return Values(layer.columns.count(), static_cast<float>(contents_.levels[layer.level]));
}

Air::Values Air::temperature(const Layer& layer) const {
    Values values = stored(contents_.temperature, layer);
    fillMasked(layer, values, kMaskedTemperature);
    const bool isVirtual = contents_.temperature == kVirtualTheta;
    if (contents_.temperature != kTheta && !isVirtual) return values;
    const Values p = pressure(layer);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] *= std::pow(p[i] / kReferencePressure, kKappa);
    }
    // Vapour that follows from the temperature itself is not taken off it.
    const bool independent =
        contents_.vapour == kSpecificHumidity || contents_.vapour == kMixingRatio;
    if (!isVirtual || !contents_.hasVapour || !independent) return values;
    const Values ratio = vapour(layer);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] *= (1.0f + ratio[i]) / (1.0f + kVapourRatio * ratio[i]);
    }
    return values;
}

Air::Values Air::vapour(const Layer& layer) const {
    if (!contents_.hasVapour) return {};
    Values values = stored(contents_.vapour, layer);
    fillMasked(layer, values, contents_.vapour == kDewPoint ? kMaskedTemperature : 0.0f);
    if (contents_.vapour == kMixingRatio || contents_.vapour == kSpecificHumidity) {
        const bool specific = contents_.vapour == kSpecificHumidity;
        for (float& value : values) {
            value = possibleVapour(specific ? value / (1.0f - value) : value);
        }
        return values;
    }
    const Values p = pressure(layer);
    const bool relative = contents_.vapour == kRelativeHumidity;
    const Values t = relative ? temperature(layer) : Values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float e = relative ? 0.01f * values[i] * saturation(t[i]) : saturation(values[i]);
        const bool dry = p[i] <= kDryAbovePressure && !std::isnan(e);
        values[i] = dry ? 0.0f : possibleVapour(e / (kVapourRatio * (p[i] - e)));
    }
    return values;
}

Air::Values Air::density(const Layer& layer) const {
    const Values p = pressure(layer), t = temperature(layer), ratio = vapour(layer);
    Values values(p.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float moist = ratio.empty() ? 1.0f : 1.0f + kVapourRatio * ratio[i];
        values[i] = isPossible(p[i], t[i]) ? p[i] / (kDryGasConstant * t[i] * moist) : kNan;
    }
    return values;
}

Air::Values Air::ground(const Layer& layer) const {
    const std::size_t field = contents_.groundHeight.at(layer.time);
    if (field == kNoField) return {};
    Values values(layer.columns.count());
    reader_.read(field, layer.columns, values);
    return values;
}

/// Half a layer beyond the centre of `end`, away from `next`.
Air::Values Air::outermost(const Layer& layer, std::size_t end, std::size_t next) const {
    Values values = heightOfCentre(atLevel(layer, end));
    const Values inner = heightOfCentre(atLevel(layer, next));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.5f * (values[i] - inner[i]);
    return values;
}

Air::Values Air::interface(const Layer& layer) const {
    const std::size_t levels = contents_.levels.size(), k = layer.level;
    if (k == levels) return outermost(layer, k - 1, k - 2);
    if (k > 0) {
        Values values = heightOfCentre(layer);
        const Values below = heightOfCentre(atLevel(layer, k - 1));
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.5f * (values[i] + below[i]);
        return values;
    }
    Values values = outermost(layer, 0, 1);
    if (contents_.surface == kIsobaric) return values;
    const Values floor = ground(layer);
    if (floor.empty()) return values;
    const Values lowest = heightOfCentre(layer);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (floor[i] < lowest[i]) values[i] = floor[i];
    }
    return values;
}

void Air::clearBelowGround(const Layer& layer, std::span<float> values) const {
    if (contents_.surface != kIsobaric) return;
    fillMasked(layer, values, kNan);
    const Values floor = ground(layer);
    if (!floor.empty()) {
        const Values height = heightOfCentre(layer);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (height[i] < floor[i]) values[i] = kNan;
        }
        return;
    }
    const std::size_t field = contents_.groundPressure.at(layer.time);
    if (field == kNoField) return;
    Values most(layer.columns.count());
    reader_.read(field, layer.columns, most);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (contents_.levels[layer.level] > static_cast<double>(most[i])) values[i] = kNan;
    }
}

}  // namespace grib
