// atmosphere.cpp: integration along rays, and the table of light scattered many times.
#include "core/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/sky/air_columns.h"

namespace neph {
namespace {

using glm::dvec2, glm::dvec3;

constexpr double kSunRadius = 0.00465;  // radians; half of its mean diameter of 32'
constexpr double kHazeAngstrom = 1.3;   // of continental haze [Angstrom29]
/// Share of the light that haze scatters which goes on as if it were not scattered, for light that
/// is then scattered elsewhere; near the sun, where it is seen itself, less of it. Tuned to exact
/// solutions: docs/sky.md.
constexpr double kForward = 0.35, kForwardAtSun = 0.14;
/// How much more light that is scattered many times molecules send along level rays than along
/// vertical ones: it comes from around the horizon, where the sky is brightest, the more so the
/// lower the sun. Tuned to the same.
constexpr double kLevelGain = 0.6, kHighSunGain = 0.18;
constexpr double kContrast = 3.912;  // -ln 0.02: what a visibility is the optical depth of
/// Molecules of 1 Dobson unit, 1/m², spread over the tent of ozone, m.
constexpr double kDobsonPerM2 = 2.6868e20, kOzoneTentM = 15e3;

/// Absorption of a molecule of ozone at each of the wavelengths, 1e-25 m². [Bruneton17]
constexpr std::array<double, kSpectrumSize> kOzone{1.527e-2, 0.1582, 0.7752, 2.139,
                                                   4.266,    5.019,  2.662,  1.209};

constexpr glm::ivec2 kManySize{32, 24};  // elevations of the sun, altitudes

/// Optical depth of the molecules above the sea. [Bodhaine99] eq. 30
double moleculesDepth(double nm) {
    const double um2 = 1e-6 * nm * nm;
    return 0.0021520 * (1.0455996 - 341.29061 / um2 - 0.90230850 * um2) /
           (1.0 + 0.0027059889 / um2 - 85.968563 * um2);
}

/// Their extinction at sea level, 550 nm.
double greenMoleculesPerM() {
    return moleculesDepth(550.0) / kMoleculesHeightM;
}

Spectrum byWavelength(const auto& valueAt) {
    Spectrum made;
    for (std::size_t i = 0; i < kSpectrumSize; ++i) made.at[i] = static_cast<float>(valueAt(i));
    return made;
}

double rayleigh(double cosTheta) {
    return 3.0 / (16.0 * std::numbers::pi) * (1.0 + cosTheta * cosTheta);
}

double cornetteShanks(double cosTheta, double g) {
    const double g2 = g * g;
    return 3.0 / (8.0 * std::numbers::pi) * (1.0 - g2) / (2.0 + g2) * (1.0 + cosTheta * cosTheta) /
           std::pow(1.0 + g2 - 2.0 * g * cosTheta, 1.5);
}

/// What goes on forwards of light that is seen at an angle from the sun: kForwardAtSun within some
/// 10 degrees of it, kForward beyond 40.
double forwardAt(double cosSun) {
    const double half2 = 0.5 + 0.5 * cosSun;  // of the cosine of half the angle
    return kForward - (kForward - kForwardAtSun) * std::pow(half2, 24.0);
}

/// Part of the air that a ray passes.
struct Reach {
    double fromM = 0.0, toM = 0.0;
    bool ground = false;  ///< at the end
};

Reach reachOf(double altitudeM, double up) {
    const double r = kEarthRadiusM + altitudeM, top = kEarthRadiusM + kAtmosphereTopM;
    const double b = r * up;
    Reach reach;
    const double atTop = b * b + top * top - r * r;
    if (atTop <= 0.0 || (r > top && up >= 0.0)) return reach;
    reach.fromM = r > top ? -b - std::sqrt(atTop) : 0.0;
    reach.toM = -b + std::sqrt(atTop);
    const double atGround = b * b + kEarthRadiusM * kEarthRadiusM - r * r;
    reach.ground = up < 0.0 && atGround > 0.0;
    if (reach.ground) reach.toM = std::max(0.0, -b - std::sqrt(atGround));
    return reach;
}

/// Of the table of light scattered many times: finer near the horizon and the ground.
double placeOfSun(double sunUp) {
    return 0.5 + 0.5 * std::copysign(std::sqrt(std::abs(sunUp)), sunUp);
}
double sunAtPlace(double place) {
    const double x = 2.0 * place - 1.0;
    return std::copysign(x * x, x);
}

}  // namespace

/// A ray as its points see it.
struct Atmosphere::Path {
    Path(const SkyRay& ray, double trueUp)
        : fromM(kEarthRadiusM + ray.altitudeM), up(ray.up), sunUp(trueUp) {
        const double across = std::sqrt(std::max(0.0, 1.0 - up * up));
        cosSun = up * sunUp + across * std::cos(ray.azimuthFromSun) *
                                  std::sqrt(std::max(0.0, 1.0 - sunUp * sunUp));
    }
    double fromM, up;
    double sunUp;   ///< without refraction, as all that follows of the sun
    double cosSun;  ///< of the angle between ray and sun
};

/// A point of it: how high it is, and how the sun stands there.
struct Atmosphere::Place {
    Place(const Path& path, double atM) {
        const double radiusM =
            std::sqrt(path.fromM * path.fromM + atM * (atM + 2.0 * path.fromM * path.up));
        altitudeM = radiusM - kEarthRadiusM;
        sunUp = (path.fromM * path.sunUp + atM * path.cosSun) / radiusM;
        const double level = 1.0 - std::min(std::abs(path.fromM * path.up + atM) / radiusM, 1.0);
        const double most = std::lerp(kLevelGain, kHighSunGain, std::clamp(sunUp, 0.0, 1.0));
        gain = static_cast<float>(1.0 + most * level * level);
    }
    double altitudeM, sunUp;
    float gain;  ///< kLevelGain
};

/// Of light scattered many times as it begins: isotropic but for what goes on.
struct Atmosphere::Phases {
    float molecules = static_cast<float>(1.0 / (4.0 * std::numbers::pi));
    float haze = static_cast<float>(1.0 - kForward) * molecules;
    bool manyTimes = false;  ///< light scattered more often as well
    double forward = kForward;
};

struct Atmosphere::Sum {
    Spectrum radiance, once, byMolecules, byHaze;
    Spectrum reaches{1.0f};  ///< of light that is scattered, with what goes on forwards
    Spectrum depth;          ///< of what is seen through it
};

double visibilityOfHazeM(double hazePerM) {
    return kContrast / (hazePerM + greenMoleculesPerM());
}

Atmosphere::Atmosphere(const AtmosphereSpec& spec) : spec_(spec) {
    moleculesPerM_ = byWavelength(
        [](std::size_t i) { return moleculesDepth(kSpectrumNm[i]) / kMoleculesHeightM; });
    const double hazePerM = std::max(0.0, kContrast / spec.visibilityM - greenMoleculesPerM());
    hazePerM_ = byWavelength(
        [&](std::size_t i) { return hazePerM * std::pow(kSpectrumNm[i] / 550.0, -kHazeAngstrom); });
    const double ozonePerM3 = spec.ozoneDobson * kDobsonPerM2 / kOzoneTentM;
    ozonePerM_ = byWavelength([&](std::size_t i) { return 1e-25 * kOzone[i] * ozonePerM3; });
    std::vector<Spectrum> made(static_cast<std::size_t>(kManySize.x * kManySize.y));
    shareOut(static_cast<std::size_t>(kManySize.y), workerCount(16),
             [&](std::size_t j, std::size_t, const Progress&) {
                 const double share = static_cast<double>(j) / (kManySize.y - 1);
                 for (int i = 0; i < kManySize.x; ++i) {
                     made[j * static_cast<std::size_t>(kManySize.x) + static_cast<std::size_t>(i)] =
                         manyTimesAt(kAtmosphereTopM * share * share,
                                     sunAtPlace(static_cast<double>(i) / (kManySize.x - 1)));
                 }
             });
    manyTimes_ = std::move(made);
}

Atmosphere::Local Atmosphere::localAt(double altitudeM) const {
    const glm::vec3 density(airDensity(std::max(altitudeM, 0.0)));
    Local local;
    local.molecules = density.x * moleculesPerM_;
    const Spectrum haze = density.y * hazePerM_;
    local.haze = static_cast<float>(kHazeAlbedo) * haze;
    local.extinction = local.molecules + haze + density.z * ozonePerM_;
    return local;
}

Spectrum Atmosphere::depthOf(const dvec3& columnsM, double forward) const {
    const glm::vec3 columns(columnsM * dvec3(1.0, 1.0 - kHazeAlbedo * forward, 1.0));
    return columns.x * moleculesPerM_ + columns.y * hazePerM_ + columns.z * ozonePerM_;
}

Spectrum Atmosphere::transmittance(double altitudeM, double up) const {
    if (up < apparentHorizonUp(altitudeM)) return Spectrum(0.0f);
    if (altitudeM >= kAtmosphereTopM && up >= 0.0) return Spectrum(1.0f);
    return expMinus(depthOf(bentRay(altitudeM, up).columnsM));
}

Spectrum Atmosphere::discLight(double altitudeM, double sunUp) const {
    return expMinus(depthOf(sunAir(altitudeM, trueSunUp(sunUp)).columnsM, 0.0));
}

Spectrum Atmosphere::sunlight(double altitudeM, double sunUp) const {
    return sunlightOf(altitudeM, trueSunUp(sunUp), 0.0);
}

Spectrum Atmosphere::sunlightOf(double altitudeM, double trueUp, double forward) const {
    const SunAir air = sunAir(altitudeM, trueUp);
    constexpr double kWellUp = 0.0;  // the whole disc, seen from anywhere: air raises it
    if (trueUp > kWellUp) return expMinus(depthOf(air.columnsM, forward));
    const double above = (std::asin(std::max(trueUp, -1.0)) - std::asin(air.lowestUp)) / kSunRadius;
    if (above <= -1.0) return Spectrum(0.0f);
    const double x = std::min(above, 1.0);
    const double visible = 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / std::numbers::pi;
    return static_cast<float>(visible) * expMinus(depthOf(air.columnsM, forward));
}

Spectrum Atmosphere::manyTimes(double altitudeM, double trueUp) const {
    const dvec2 share{placeOfSun(trueUp),
                      std::sqrt(std::clamp(altitudeM / kAtmosphereTopM, 0.0, 1.0))};
    const dvec2 at = share * dvec2(kManySize - 1);
    const glm::ivec2 cell = glm::min(glm::ivec2(at), kManySize - 2);
    const glm::vec2 f(at - dvec2(cell));
    const Spectrum* row = &manyTimes_[static_cast<std::size_t>(cell.y * kManySize.x + cell.x)];
    const Spectrum* above = row + kManySize.x;
    return (1.0f - f.y) * ((1.0f - f.x) * row[0] + f.x * row[1]) +
           f.y * ((1.0f - f.x) * above[0] + f.x * above[1]);
}

/// A stretch around a place, as if all of it were as it is there.
void Atmosphere::add(const Place& place, double lengthM, const Phases& phases, Sum& sum) const {
    const Local local = localAt(place.altitudeM);
    const Spectrum sun = sunlightOf(place.altitudeM, place.sunUp, phases.forward);
    const Spectrum many =
        phases.manyTimes ? manyTimes(place.altitudeM, place.sunUp) : Spectrum(0.0f);
    const auto length = static_cast<float>(lengthM), forward = static_cast<float>(phases.forward);
    Spectrum depth;
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        depth.at[i] = length * (local.extinction.at[i] - forward * local.haze.at[i]);
        sum.depth.at[i] += length * local.extinction.at[i];
    }
    const Spectrum clear = expMinus(depth);
    constexpr auto kSpread = static_cast<float>(1.0 - kForward);
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        const float once =
            sun.at[i] * (local.molecules.at[i] * phases.molecules + local.haze.at[i] * phases.haze);
        const float byMolecules = place.gain * local.molecules.at[i];
        const float scattered = byMolecules + kSpread * local.haze.at[i];
        const float x = depth.at[i];
        // (1 - e^-x) / x.
        const float mean = x < 0.02f ? 1.0f - x * (0.5f - x / 6.0f) : (1.0f - clear.at[i]) / x;
        const float seen = sum.reaches.at[i] * mean * length;
        sum.radiance.at[i] += seen * (once + scattered * many.at[i]);
        sum.once.at[i] += seen * once;
        sum.byMolecules.at[i] += seen * byMolecules;
        sum.byHaze.at[i] += seen * local.haze.at[i];
        sum.reaches.at[i] *= clear.at[i];
    }
}

/// Light scattered at least twice, seen from everywhere, before it is scattered once more: of light
/// scattered once as if isotropic, and a geometric series of what follows. [Hillaire20] eq. 5-10
Spectrum Atmosphere::manyTimesAt(double altitudeM, double trueUp) const {
    constexpr int kUps = 8, kAzimuths = 4, kSteps = 20;
    constexpr auto kGoesOn = static_cast<float>(kForward);
    Spectrum light, again;
    for (int i = 0; i < kUps; ++i) {
        for (int j = 0; j < kAzimuths; ++j) {
            const SkyRay ray{altitudeM, (i + 0.5) / kUps * 2.0 - 1.0,
                             std::numbers::pi * (j + 0.5) / kAzimuths};
            const Path path(ray, trueUp);
            const Reach reach = reachOf(altitudeM, ray.up);
            Sum sum;
            for (int step = 0; step < kSteps; ++step) {
                const dvec2 t{step / static_cast<double>(kSteps), (step + 1.0) / kSteps};
                const dvec2 atM = reach.fromM + (reach.toM - reach.fromM) * t * t;
                const Place place(path, 0.5 * (atM.x + atM.y));
                const Spectrum before = sum.reaches;
                add(place, atM.y - atM.x, {}, sum);
                const Local local = localAt(place.altitudeM);
                for (std::size_t k = 0; k < kSpectrumSize; ++k) {
                    const float goesOn = kGoesOn * local.haze.at[k];
                    const float scattered = (local.molecules.at[k] + local.haze.at[k] - goesOn) /
                                            std::max(local.extinction.at[k] - goesOn, 1e-20f);
                    again.at[k] += (before.at[k] - sum.reaches.at[k]) * scattered;
                }
            }
            light += sum.radiance;
            if (!reach.ground) continue;
            const Place below(path, reach.toM);
            const double perRadiance =
                spec_.groundAlbedo / std::numbers::pi * std::max(below.sunUp, 0.0);
            light += static_cast<float>(perRadiance) *
                     (sum.reaches * sunlightOf(0.0, below.sunUp, kForward));
        }
    }
    constexpr float kPerDirection = 1.0f / (kUps * kAzimuths);
    Spectrum many;
    for (std::size_t k = 0; k < kSpectrumSize; ++k) {
        many.at[k] = kPerDirection * light.at[k] / (1.0f - kPerDirection * again.at[k]);
    }
    return many;
}

/// Into how many parts a stretch has to be divided so that none of them passes through much of the
/// haze at once, as rays from far above do.
int Atmosphere::partsOf(const Path& path, double fromM, double toM) {
    constexpr double kHazyM = 10e3, kHazeM = 400.0, kClearM = 2500.0;
    constexpr int kMostParts = 24;
    const double middle = Place(path, 0.5 * (fromM + toM)).altitudeM;
    const double begin = Place(path, fromM).altitudeM, end = Place(path, toM).altitudeM;
    const double changeM = std::max(std::abs(begin - middle), std::abs(end - middle));
    const double wantedM = std::min(middle, end) < kHazyM ? kHazeM : kClearM;
    return std::clamp(static_cast<int>(std::ceil(changeM / wantedM)), 1, kMostParts);
}

AirLight Atmosphere::along(const SkyRay& ray) const {
    const Reach reach = reachOf(ray.altitudeM, ray.up);
    AirLight all;
    along(ray, std::array{reach.toM}, std::span(&all, 1));
    return all;
}

void Atmosphere::along(const SkyRay& ray, std::span<const double> distancesM,
                       std::span<AirLight> to) const {
    constexpr int kSteps = 40;       // of the whole
    constexpr double kHighM = 10e3;  // of eyes above which steps near the ground are long
    const Reach reach = reachOf(ray.altitudeM, ray.up);
    const double lengthM = std::max(reach.toM - reach.fromM, 1.0);
    const Path path(ray, trueSunUp(ray.sunUp));
    const double cosSeen = Path(ray, ray.sunUp).cosSun;  // haze is brightest around the disc
    const Phases phases{static_cast<float>(rayleigh(cosSeen)),
                        static_cast<float>(cornetteShanks(cosSeen, kHazeG)), true,
                        forwardAt(cosSeen)};
    double lastM = reach.toM;
    if (reach.ground) {
        const auto beyond = std::ranges::lower_bound(distancesM, reach.toM);
        if (beyond != distancesM.end()) lastM = *beyond;
    }
    const auto shareOf = [&](double atM) {
        return std::sqrt((std::clamp(atM, reach.fromM, lastM) - reach.fromM) / lengthM);
    };
    Sum sum;
    double from = 0.0;
    for (std::size_t i = 0; i < distancesM.size(); ++i) {
        const double until = shareOf(distancesM[i]);
        const int steps = std::min(static_cast<int>(std::ceil((until - from) * kSteps)), kSteps);
        for (int step = 0; step < steps; ++step) {
            const double a = std::lerp(from, until, step / static_cast<double>(steps));
            const double b = std::lerp(from, until, (step + 1.0) / steps);
            const double aM = reach.fromM + lengthM * a * a, bM = reach.fromM + lengthM * b * b;
            const int parts = ray.altitudeM > kHighM ? partsOf(path, aM, bM) : 1;
            for (int part = 0; part < parts; ++part) {
                const double atM = std::lerp(aM, bM, (part + 0.5) / parts);
                add(Place(path, atM), (bM - aM) / parts, phases, sum);
            }
        }
        from = std::max(from, until);
        to[i] = {sum.radiance, sum.once, sum.byMolecules, sum.byHaze, expMinus(sum.depth)};
    }
}

}  // namespace neph
