// parcel.cpp: lifts a parcel in small steps of pressure and sums its buoyancy.
#include "core/air/parcel.h"

#include <algorithm>
#include <cmath>

#include "core/air/thermodynamics.h"

namespace neph {
namespace {

constexpr double kLiftStepPa = 500.0;
constexpr double kMixedLayerPa = 1.0e4;
constexpr double kUnstableLayerPa = 3.0e4;

/// What is known of the parcel at one pressure.
struct Step {
    ParcelPoint point;
    double buoyancyMPerS2 = 0.0;
};

Parcel mixedParcel(const Sounding& sounding) {
    const double groundPa = sounding.levels.front().pressurePa;
    const double topPa = std::max(groundPa - kMixedLayerPa, sounding.levels.back().pressurePa);
    constexpr int kSlices = 100;
    double theta = 0.0, vapour = 0.0;
    for (int i = 0; i < kSlices; ++i) {
        const double pressure = std::lerp(groundPa, topPa, (i + 0.5) / kSlices);
        const SoundingLevel air = levelAt(sounding, pressure);
        theta += potentialTemperatureK(pressure, air.temperatureK) / kSlices;
        vapour += air.vapourRatio / kSlices;
    }
    return {groundPa, theta / potentialTemperatureK(groundPa, 1.0), vapour};
}

Parcel unstableParcel(const Sounding& sounding) {
    const double topPa = sounding.levels.front().pressurePa - kUnstableLayerPa;
    const auto energy = [](const SoundingLevel& level) {
        return equivalentPotentialTemperatureK(level.pressurePa, level.temperatureK,
                                               level.vapourRatio);
    };
    const SoundingLevel* most = &sounding.levels.front();
    for (const SoundingLevel& level : sounding.levels) {
        if (level.pressurePa >= topPa && energy(level) > energy(*most)) most = &level;
    }
    return {most->pressurePa, most->temperatureK, most->vapourRatio};
}

/// Pressures of the way: of all levels above the parcel, of condensation, and between.
std::vector<double> pressuresOf(const Sounding& sounding, const Parcel& parcel,
                                double condensationPa) {
    std::vector<double> pressures{parcel.pressurePa};
    const double topPa = sounding.levels.back().pressurePa;
    if (condensationPa < parcel.pressurePa && condensationPa > topPa) {
        pressures.push_back(condensationPa);
    }
    for (const SoundingLevel& level : sounding.levels) {
        if (level.pressurePa < parcel.pressurePa) pressures.push_back(level.pressurePa);
    }
    std::ranges::sort(pressures, std::greater());
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < pressures.size(); ++i) {
        const int parts = std::max(
            1, static_cast<int>(std::ceil((pressures[i] - pressures[i + 1]) / kLiftStepPa)));
        for (int k = 0; k < parts; ++k) {
            all.push_back(std::lerp(pressures[i], pressures[i + 1], double(k) / parts));
        }
    }
    all.push_back(pressures.back());
    return all;
}

std::vector<Step> stepsOf(const Sounding& sounding, const Parcel& parcel, double condensationPa) {
    std::vector<Step> steps;
    double temperature = parcel.temperatureK, fromPa = parcel.pressurePa;
    for (const double pressure : pressuresOf(sounding, parcel, condensationPa)) {
        const bool dry = pressure >= condensationPa;
        temperature =
            dry ? parcel.temperatureK * std::pow(pressure / parcel.pressurePa, kPoissonDry)
                : pseudoadiabatK(fromPa, temperature, pressure);
        fromPa = pressure;
        const SoundingLevel air = levelAt(sounding, pressure);
        const double vapour =
            dry ? parcel.vapourRatio
                : std::min(parcel.vapourRatio, saturationRatio(pressure, temperature));
        const double around = virtualTemperatureK(air.temperatureK, air.vapourRatio);
        steps.push_back(
            {{pressure, air.heightM - sounding.groundM, temperature},
             kGravityMPerS2 * (virtualTemperatureK(temperature, vapour) - around) / around});
    }
    return steps;
}

/// Where buoyancy is zero between two steps of different sign.
ParcelPoint crossing(const Step& a, const Step& b) {
    const double share = a.buoyancyMPerS2 / (a.buoyancyMPerS2 - b.buoyancyMPerS2);
    return {std::lerp(a.point.pressurePa, b.point.pressurePa, share),
            std::lerp(a.point.heightM, b.point.heightM, share),
            std::lerp(a.point.temperatureK, b.point.temperatureK, share)};
}

/// A stretch of the way on which buoyancy has one sign.
struct Layer {
    ParcelPoint from, to;
    double energyJPerKg = 0.0;
    bool open = false;  ///< ends at the top of the sounding
};

std::vector<Layer> layersOf(const std::vector<Step>& steps) {
    std::vector<Layer> layers{{steps.front().point, steps.front().point}};
    const auto add = [&](const ParcelPoint& to, double lower, double upper) {
        Layer& layer = layers.back();
        layer.energyJPerKg += 0.5 * (lower + upper) * (to.heightM - layer.to.heightM);
        layer.to = to;
    };
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        const double lower = steps[i].buoyancyMPerS2, upper = steps[i + 1].buoyancyMPerS2;
        if (lower * upper < 0.0) {
            const ParcelPoint zero = crossing(steps[i], steps[i + 1]);
            add(zero, lower, 0.0);
            layers.push_back({zero, zero});
            add(steps[i + 1].point, 0.0, upper);
        } else {
            add(steps[i + 1].point, lower, upper);
        }
    }
    layers.back().open = true;
    return layers;
}

}  // namespace

Parcel parcelOf(const Sounding& sounding, ParcelSource source) {
    if (source == ParcelSource::mixedLayer) return mixedParcel(sounding);
    if (source == ParcelSource::mostUnstable) return unstableParcel(sounding);
    const SoundingLevel& lowest = sounding.levels.front();
    return {lowest.pressurePa, lowest.temperatureK, lowest.vapourRatio};
}

Ascent ascentOf(const Sounding& sounding, const Parcel& parcel) {
    Ascent ascent;
    ascent.parcel = parcel;
    const double condensationPa =
        condensationPressurePa(parcel.pressurePa, parcel.temperatureK, parcel.vapourRatio);
    const std::vector<Step> steps = stepsOf(sounding, parcel, condensationPa);
    for (const Step& step : steps) ascent.way.push_back(step.point);
    if (condensationPa >= sounding.levels.back().pressurePa) {
        const SoundingLevel air = levelAt(sounding, condensationPa);
        ascent.condensation = {
            condensationPa, air.heightM - sounding.groundM,
            condensationTemperatureK(parcel.pressurePa, parcel.temperatureK, parcel.vapourRatio)};
    }
    // Free convection begins above condensation: a warm surface alone is no cloud.
    for (const Layer& layer : layersOf(steps)) {
        const bool moist = layer.to.pressurePa < condensationPa;
        if (layer.energyJPerKg > 0.0 && moist) {
            if (!ascent.freeConvection) {
                ascent.freeConvection =
                    layer.from.pressurePa > condensationPa ? ascent.condensation : layer.from;
            }
            ascent.capeJPerKg += layer.energyJPerKg;
            ascent.equilibrium = layer.open ? std::nullopt : std::optional(layer.to);
        } else if (layer.energyJPerKg < 0.0 && !ascent.freeConvection) {
            ascent.cinJPerKg += layer.energyJPerKg;
        }
    }
    if (!ascent.freeConvection) ascent.cinJPerKg = 0.0;
    return ascent;
}

}  // namespace neph
