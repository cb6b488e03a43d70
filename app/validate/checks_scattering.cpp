// checks_scattering.cpp: single scattering, which has a closed form, and the white furnace, in
// which multiple scattering must leave uniform radiance unchanged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/validate/checks.h"

namespace neph::validate {
namespace {

using render::DetectorKind;

constexpr double kHeightM = 1000.0;
constexpr double kWidthM = 8000.0;
constexpr int kLevels = 16;

/// Radiance, after one scattering, that leaves a slab of optical depth t upwards (mu > 0) or
/// downwards, for a beam of irradiance 1 from mu0. `phase` is in 1/sr. [Chandrasekhar60] ch. III
double scatteredOnce(double t, double albedo, double phase, double mu0, double mu) {
    const double m = std::abs(mu);
    const double front = albedo * phase * mu0;
    if (mu > 0.0) return front / (m + mu0) * (1.0 - std::exp(-t * (1.0 / m + 1.0 / mu0)));
    // The general form below is 0/0 along the beam.
    if (std::abs(m - mu0) < 1e-9) return front * t / (mu0 * mu0) * std::exp(-t / mu0);
    return front / (mu0 - m) * (std::exp(-t / mu0) - std::exp(-t / m));
}

/// Mean phase function over the sun's disc, because the glory is only a few discs wide.
double phaseOfSun(const PhaseSpec& spec, const render::MeterScene& scene, glm::dvec3 leaving) {
    double sum = 0.0;
    const std::vector<glm::dvec3> disc = sunDisc(scene);
    for (const glm::dvec3 dir : disc) {
        const auto cosTheta = static_cast<float>(std::clamp(-glm::dot(leaving, dir), -1.0, 1.0));
        sum += static_cast<double>(phaseValue(spec, cosTheta).y);
    }
    return sum / static_cast<double>(disc.size());
}

/// A slab of single-scattering light; `depth` is optical depth.
struct Slab {
    double depth, albedo;
    PhaseSpec phase;
    std::string name;
};

Trial singleTrial(const Slab& slab, double sunZenithDeg) {
    Trial trial;
    trial.name = fmt::format("Single scattering: {}, sun at {:g}°", slab.name, sunZenithDeg);
    trial.source = "closed form [Chandrasekhar60]";
    trial.scene.size = {1, 1, kLevels};
    trial.scene.spacingM = {kWidthM, kWidthM, kHeightM / kLevels};
    trial.scene.fields.push_back(
        {Array3f(trial.scene.size, static_cast<float>(slab.depth / kHeightM)), slab.albedo,
         slab.phase});
    const double sun = glm::radians(sunZenithDeg);
    trial.scene.towardsSun = {-std::sin(sun), 0.0, std::cos(sun)};
    trial.settings.maxScatterings = 1;
    for (const double zenithDeg : {0.0, 35.0, 70.0, 110.0, 145.0, 180.0}) {
        // Skip the forward direction: the phase function varies across the sun's disc.
        const bool straightOn = std::abs(180.0 - zenithDeg - sunZenithDeg) < 1.0;
        if (straightOn && slab.phase.kind != PhaseKind::isotropic) continue;
        const double zenith = glm::radians(zenithDeg);
        const glm::dvec3 leaving{std::sin(zenith), 0.0, std::cos(zenith)};
        const double z = leaving.z > 0.0 ? kHeightM : 0.0;
        trial.detectors.push_back(
            {DetectorKind::radiance, {{0.0, 0.0, z}, {kWidthM, kWidthM, z}}, -leaving});
        const double phase = phaseOfSun(slab.phase, trial.scene, leaving);
        const double expected =
            scatteredOnce(slab.depth, slab.albedo, phase, trial.scene.towardsSun.z, leaving.z);
        trial.quantities.push_back({fmt::format("radiance leaving at {:g}°", zenithDeg),
                                    {{trial.detectors.size() - 1, 1.0}},
                                    0.0,
                                    Expected{expected, 3e-3 * expected, ""}});
    }
    return trial;
}

PhaseSpec specOf(PhaseKind kind) {
    PhaseSpec spec;
    spec.kind = kind;
    return spec;
}

/// Three fields of random extinction that do not absorb, one of them water droplets, under a
/// uniform sky of radiance 1.
render::MeterScene furnace(bool periodic, bool trilinear) {
    render::MeterScene scene;
    scene.size = {9, 8, 10};
    scene.spacingM = {100.0, 110.0, 90.0};
    scene.periodic = periodic;
    scene.trilinear = trilinear;
    scene.sunIrradiance = 0.0;
    scene.skyRadiance = 1.0;
    std::uint32_t seed = 11;
    for (const PhaseKind kind :
         {PhaseKind::waterDroplets, PhaseKind::rayleigh, PhaseKind::doubleHenyeyGreenstein}) {
        scene.fields.push_back({randomExtinction(scene.size, 1e-3, ++seed), 1.0, specOf(kind)});
    }
    return scene;
}

/// Adds detectors inside the medium and at its top; each must read the radiance of the sky.
void addFurnaceViews(Trial& trial) {
    const glm::dvec3 extentM = glm::dvec3(trial.scene.size) * trial.scene.spacingM;
    const glm::dvec3 middleM = 0.5 * extentM;
    const auto add = [&](const std::string& name, const render::Detector& detector, double unit) {
        trial.detectors.push_back(detector);
        trial.quantities.push_back(
            {name, {{trial.detectors.size() - 1, 1.0 / unit}}, 0.0, Expected{1.0, 5e-4, ""}});
    };
    const glm::dvec3 slant = glm::normalize(glm::dvec3(0.6, -0.5, 0.4));
    add("radiance inside, upwards", {DetectorKind::radiance, {middleM, middleM}}, 1.0);
    add("radiance inside, slanting", {DetectorKind::radiance, {middleM, middleM}, slant}, 1.0);
    add("radiance of the top, from above",
        {DetectorKind::radiance, {{0.0, 0.0, extentM.z}, extentM}, {0.0, 0.0, -1.0}}, 1.0);
    add("irradiance of the middle plane",
        {DetectorKind::flux, {{0.0, 0.0, middleM.z}, {extentM.x, extentM.y, middleM.z}}}, M_PI);
}

Trial furnaceTrial(bool periodic, bool trilinear) {
    Trial trial;
    trial.name = fmt::format("White furnace: random medium, {}, {} sides",
                             trilinear ? "interpolated" : "voxels", periodic ? "periodic" : "open");
    trial.source = "radiance 1 everywhere";
    trial.scene = furnace(periodic, trilinear);
    addFurnaceViews(trial);
    return trial;
}

/// White ground below a medium that does not absorb: nothing is lost.
Trial furnaceOverGroundTrial() {
    Trial trial = furnaceTrial(true, false);
    trial.name = "White furnace: random medium over white ground";
    trial.scene.surfaceAlbedo = 1.0;
    trial.quick = false;  // paths between the two are long
    return trial;
}

}  // namespace

std::vector<Trial> singleScatteringTrials() {
    std::vector<Trial> trials;
    const Slab isotropic{1.0, 1.0, {}, "isotropic"};
    const Slab forward{0.7, 0.9, henyeyGreenstein(0.85), "Henyey-Greenstein, g 0.85"};
    const Slab droplets{0.5, 1.0, specOf(PhaseKind::waterDroplets), "water droplets"};
    for (const Slab& slab : {isotropic, forward, droplets}) {
        for (const double zenithDeg : {0.0, 60.0}) trials.push_back(singleTrial(slab, zenithDeg));
    }
    return trials;
}

std::vector<Trial> furnaceTrials() {
    std::vector<Trial> trials;
    for (const bool periodic : {false, true}) {
        for (const bool trilinear : {false, true}) {
            trials.push_back(furnaceTrial(periodic, trilinear));
        }
    }
    trials.push_back(furnaceOverGroundTrial());
    return trials;
}

}  // namespace neph::validate
