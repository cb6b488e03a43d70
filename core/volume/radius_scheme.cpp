// radius_scheme.cpp: the size distributions of WSM6, Thompson, Morrison and Lin, as coded in WRF
// 4.2.2.
#include "core/volume/radius_scheme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/optics/particle_size.h"

namespace neph {
namespace {

/// Mass of Thompson's snow is this times the squared diameter, kg/m². [Thompson08]
constexpr double kThompsonSnowKgPerM2 = 0.069;

constexpr RadiusBounds kCloudBounds{2.51e-6, 50e-6};
constexpr RadiusBounds kIceBounds{5.01e-6, 125e-6};
constexpr RadiusBounds kSnowBounds{10.01e-6, 999e-6};

double within(RadiusBounds bounds, double radiusM) {
    return std::clamp(radiusM, bounds.lowerM, bounds.upperM);
}

/// Bulk density of one particle, kg/m³.
double densityOf(Microphysics scheme, Species species) {
    const bool morrison = scheme == Microphysics::morrison;
    switch (species) {
        case Species::cloud:
            return 1000.0;
        case Species::ice:
            if (scheme == Microphysics::thompson) return 890.0;
            return morrison ? 500.0 : 917.0;
        case Species::rain:
            return morrison ? 997.0 : 1000.0;
        case Species::snow:
            return 100.0;
        case Species::graupel:
            return scheme == Microphysics::wsm6 || scheme == Microphysics::thompson ? 500.0 : 400.0;
        case Species::hail:
            return scheme == Microphysics::wsm6 ? 700.0 : 900.0;
    }
    return 0.0;
}

/// What WRF writes where a species is absent; 0: nothing.
double backgroundRadiusM(Species species) {
    if (species == Species::cloud) return 2.49e-6;
    if (species == Species::ice) return 4.99e-6;
    return species == Species::snow ? 9.99e-6 : 0.0;
}

/// Droplets per m³ if unknown; 100 per cm³ is the value of Thompson and of maritime clouds.
double dropletsOf(Microphysics scheme) {
    if (scheme == Microphysics::wsm6) return 3e8;
    return scheme == Microphysics::morrison ? 2.5e8 : 1e8;
}

/// Shape parameter μ of the droplets' gamma distribution.
double dropletShape(Microphysics scheme, double numberPerM3) {
    if (scheme == Microphysics::thompson) {
        return std::min(15.0, std::round(1e9 / numberPerM3) + 2.0);
    }
    const double inverse = 0.0005714 * numberPerM3 * 1e-6 + 0.2714;  // Morrison, after [Martin94]
    return std::clamp(1.0 / (inverse * inverse) - 1.0, 2.0, 10.0);
}

ParticleSize cloudSize(Microphysics scheme, RadiationOptics optics, CellState cell) {
    if (cell.numberPerM3 <= 0.0) cell.numberPerM3 = dropletsOf(scheme);
    if (scheme != Microphysics::wsm6) return sizeFromNumber(scheme, Species::cloud, cell);
    const double density = densityOf(scheme, Species::cloud);
    if (optics == RadiationOptics::geometric) {
        const double equal = equalSpheresRadiusM(cell.contentKgPerM3, cell.numberPerM3, density);
        return {within(kCloudBounds, equal), density};
    }
    // As coded in WRF: 1.5 / λ with a λ that is the inverse of the diameter; three times the
    // radius.
    const double inverseDiameter =
        std::cbrt(std::numbers::pi / 6.0 * density * cell.numberPerM3 / cell.contentKgPerM3);
    return {within(kCloudBounds, 1.5 / inverseDiameter), density};
}

/// WSM6 diagnoses number and diameter from the mass alone; the others need a number, or a radius is
/// assumed. docs/physics.md §7
ParticleSize iceSize(Microphysics scheme, const CellState& cell) {
    if (scheme == Microphysics::wsm6) {
        const double number =
            std::clamp(5.38e7 * std::pow(cell.contentKgPerM3, 0.75), 1e3, 1e6);  // [HDC04]
        const double diameterM = 11.9 * std::sqrt(cell.contentKgPerM3 / number);
        const double radiusM = std::max(0.75 * 0.163 * diameterM, 10.01e-6);
        return {within(kIceBounds, radiusM), densityOf(scheme, Species::ice)};
    }
    if (schemeReadsNumber(scheme, Species::ice) && cell.numberPerM3 > 0.0) {
        return sizeFromNumber(scheme, Species::ice, cell);
    }
    return {30e-6, densityOf(Microphysics::unknown, Species::ice)};
}

/// Size of an exponential distribution with a fixed intercept.
ParticleSize interceptSize(const CellState& cell, double interceptPerM4, double density) {
    const double slope = interceptSlopePerM(cell.contentKgPerM3, interceptPerM4, density);
    return {effectiveRadiusM(slope, 0.0), density};
}

/// Intercepts of [Lin83], also used by WSM6, 1/m⁴.
constexpr double kRainIntercept = 8e6, kGraupelIntercept = 4e6, kHailIntercept = 4e4;
constexpr double kLinSnowIntercept = 3e6;

ParticleSize wsm6Snow(RadiationOptics optics, const CellState& cell) {
    // N0 increases with decreasing temperature, up to 1e11. [HDC04]
    const double intercept =
        std::clamp(2e6 * std::exp(0.12 * (kFreezingK - cell.temperatureK)), 2e6, 1e11);
    const ParticleSize consistent = interceptSize(cell, intercept, 100.0);
    if (optics == RadiationOptics::geometric) return consistent;
    return {within(kSnowBounds, consistent.radiusM / 3.0), 100.0};  // as coded in WRF: 0.5 / λ
}

ParticleSize snowSize(Microphysics scheme, RadiationOptics optics, const CellState& cell) {
    if (scheme == Microphysics::wsm6) return wsm6Snow(optics, cell);
    if (scheme == Microphysics::thompson) {
        const double second = cell.contentKgPerM3 / kThompsonSnowKgPerM2;
        const double radiusM = 0.5 * snowThirdMoment(second, cell.temperatureK) / second;
        return sizeFromFile(scheme, Species::snow, within(kSnowBounds, radiusM));
    }
    if (schemeReadsNumber(scheme, Species::snow) && cell.numberPerM3 > 0.0) {
        return sizeFromNumber(scheme, Species::snow, cell);
    }
    return interceptSize(cell, kLinSnowIntercept, 100.0);
}

/// Thompson makes the intercept depend on the content, the others keep it fixed.
ParticleSize graupelSize(Microphysics scheme, const CellState& cell) {
    const double density = densityOf(scheme, Species::graupel);
    if (scheme == Microphysics::thompson) {
        const double exponent = 3.5 + 2.0 / 7.0 * (std::log10(cell.contentKgPerM3) + 7.0);
        return interceptSize(cell, std::pow(10.0, std::clamp(exponent, 2.0, 7.0)), density);
    }
    if (schemeReadsNumber(scheme, Species::graupel) && cell.numberPerM3 > 0.0) {
        return sizeFromNumber(scheme, Species::graupel, cell);
    }
    return interceptSize(cell, kGraupelIntercept, density);
}

ParticleSize rainSize(Microphysics scheme, const CellState& cell) {
    if (schemeReadsNumber(scheme, Species::rain) && cell.numberPerM3 > 0.0) {
        return sizeFromNumber(scheme, Species::rain, cell);
    }
    return interceptSize(cell, kRainIntercept, densityOf(scheme, Species::rain));
}

}  // namespace

bool schemeReadsNumber(Microphysics scheme, Species species) {
    if (species == Species::cloud) return true;  // otherwise the scheme's fixed number applies
    if (scheme == Microphysics::thompson)
        return species == Species::ice || species == Species::rain;
    return scheme == Microphysics::morrison && species != Species::hail;
}

bool schemeReadsTemperature(Microphysics scheme, Species species) {
    return species == Species::snow &&
           (scheme == Microphysics::wsm6 || scheme == Microphysics::thompson);
}

ParticleSize sizeFromScheme(Microphysics scheme, Species species, RadiationOptics optics,
                            const CellState& cell) {
    switch (species) {
        case Species::cloud:
            return cloudSize(scheme, optics, cell);
        case Species::ice:
            return iceSize(scheme, cell);
        case Species::rain:
            return rainSize(scheme, cell);
        case Species::snow:
            return snowSize(scheme, optics, cell);
        case Species::graupel:
            return graupelSize(scheme, cell);
        case Species::hail:
            break;
    }
    return interceptSize(cell, kHailIntercept, densityOf(scheme, Species::hail));
}

ParticleSize sizeFromNumber(Microphysics scheme, Species species, const CellState& cell) {
    const double density = densityOf(scheme, species);
    const double mu = species == Species::cloud ? dropletShape(scheme, cell.numberPerM3) : 0.0;
    const double slope = gammaSlopePerM(cell.contentKgPerM3, cell.numberPerM3, density, mu);
    const double radiusM = effectiveRadiusM(slope, mu);
    if (species == Species::cloud) return {within(kCloudBounds, radiusM), density};
    if (species == Species::ice) return {within(kIceBounds, radiusM), density};
    return {radiusM, density};
}

ParticleSize sizeFromFile(Microphysics scheme, Species species, double radiusM) {
    if (scheme == Microphysics::thompson && species == Species::snow) {
        // Mass 0.069 M2 = π/6 ρ M3 and r_e = M3 / (2 M2): larger flakes have a lower density.
        return {radiusM, 3.0 * kThompsonSnowKgPerM2 / (std::numbers::pi * radiusM)};
    }
    return {radiusM, densityOf(scheme, species)};
}

RadiusBounds radiationBounds(Species species) {
    if (species == Species::cloud) return kCloudBounds;
    if (species == Species::ice) return kIceBounds;
    return species == Species::snow ? kSnowBounds : RadiusBounds{};
}

bool isBackgroundRadius(Species species, double radiusM) {
    if (!(radiusM > 0.0)) return true;
    return std::abs(radiusM - backgroundRadiusM(species)) < 0.012e-6;
}

double extinctionPerM(RadiationOptics optics, Species species, double contentKgPerM3,
                      const ParticleSize& size) {
    const bool ice = species == Species::ice;
    if (optics == RadiationOptics::geometric || !(ice || species == Species::snow)) {
        return geometricExtinctionPerM(contentKgPerM3, size.radiusM, size.densityKgPerM3);
    }
    // Fu's fit in RRTMG's visible band, 2513 / D_ge[µm] m²/kg, used with r_e in place of D_ge; snow
    // above 130 µm counts as 130 µm with less mass. [Fu96]
    constexpr double kFuM3PerKg = 2513e-6, kLargestSnowM = 130e-6;
    const double radiusM = ice ? size.radiusM : std::min(size.radiusM, kLargestSnowM);
    const double massShare = radiusM / size.radiusM * (radiusM / size.radiusM);
    return kFuM3PerKg * contentKgPerM3 * massShare / radiusM;
}

}  // namespace neph
