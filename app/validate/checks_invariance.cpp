// checks_invariance.cpp: results must not depend on how a medium is described (fields, majorants,
// bricks, voxels), and energy must be conserved.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/validate/checks.h"

namespace neph::validate {
namespace {

using render::DetectorKind;
using render::MeterScene;

// Relative; docs/validation.md has the reasons.
constexpr double kFluxTolerance = 3e-3;
constexpr double kRadianceTolerance = 1e-2;
constexpr double kTwinTolerance = 1.5e-2;  // a difference has the errors of both measurements

glm::dvec3 extentOf(const MeterScene& scene) {
    return glm::dvec3(scene.size) * scene.spacingM;
}

void aimSun(MeterScene& scene, double zenithDeg) {
    const double zenith = glm::radians(zenithDeg);
    scene.towardsSun = {-std::sin(zenith), 0.0, std::cos(zenith)};
}

/// Adds a detector and a quantity that is `factor` times its reading. `level` is the expected
/// value, or its magnitude if a twin supplies it; tolerances are relative to it.
void add(Trial& trial, const std::string& name, const render::Detector& detector, double factor,
         double level, double tolerance) {
    trial.detectors.push_back(detector);
    trial.quantities.push_back({name,
                                {{trial.detectors.size() - 1, factor}},
                                0.0,
                                Expected{level, tolerance * level, ""}});
}

/// Adds reflectance R, transmittance T and an oblique radiance, as shares of the incident light.
void addFluxes(Trial& trial, double r, double t, double slant) {
    const double fluxTolerance = trial.twin ? kTwinTolerance : kFluxTolerance;
    const glm::dvec3 extentM = extentOf(trial.scene);
    const double mu = trial.scene.towardsSun.z;
    add(trial, "R", {DetectorKind::flux, {{0.0, 0.0, extentM.z}, extentM}, {0.0, 0.0, -1.0}},
        1.0 / mu, r, fluxTolerance);
    add(trial, "T", {DetectorKind::flux, {{0.0, 0.0, 0.0}, {extentM.x, extentM.y, 0.0}}}, 1.0 / mu,
        t, fluxTolerance);
    const double side = std::sqrt(0.75);  // sine of 60 degrees
    const glm::dvec3 looking{0.6 * side, 0.8 * side, -0.5};
    add(trial, "radiance leaving the top at 60°",
        {DetectorKind::radiance, {{0.0, 0.0, extentM.z}, extentM}, looking}, M_PI / mu, slant,
        trial.twin ? 2.0 * kTwinTolerance : kRadianceTolerance);
}

/// A slab of 16 levels and a depth of 1 km.
MeterScene slabScene() {
    MeterScene scene;
    scene.size = {1, 1, 16};
    scene.spacingM = {16000.0, 16000.0, 62.5};
    aimSun(scene, 50.0);
    return scene;
}

render::MeterField uniform(const MeterScene& scene, double extinctionPerM, double albedo,
                           const PhaseSpec& phase) {
    return {Array3f(scene.size, static_cast<float>(extinctionPerM)), albedo, phase};
}

/// Two fields, one of them absorbing, against a single field with the mean phase function of
/// [Riley03] eq. 18.
Trial mixtureTrial() {
    Trial trial;
    trial.name = "Mixture of two fields = one field by Eq. 18";
    trial.source = "one field with the summed extinction and the mean phase function";
    trial.scene = slabScene();
    Twin twin{trial.scene, {}};
    constexpr double kBeta1 = 2e-3, kBeta2 = 3e-3, kAlbedo2 = 0.9;
    trial.scene.fields = {uniform(trial.scene, kBeta1, 1.0, henyeyGreenstein(0.85)),
                          uniform(trial.scene, kBeta2, kAlbedo2, henyeyGreenstein(-0.2))};
    PhaseSpec mean;
    mean.kind = PhaseKind::doubleHenyeyGreenstein;
    mean.g = 0.85f;
    mean.g2 = -0.2f;
    mean.weight = static_cast<float>(kBeta1 / (kBeta1 + kAlbedo2 * kBeta2));
    twin.scene.fields = {uniform(trial.scene, kBeta1 + kBeta2,
                                 (kBeta1 + kAlbedo2 * kBeta2) / (kBeta1 + kBeta2), mean)};
    trial.twin = std::move(twin);
    addFluxes(trial, 0.5, 0.3, 0.5);
    return trial;
}

/// Extinction that is independent in each voxel, so that majorants differ much from it.
MeterScene randomScene(double albedo) {
    MeterScene scene;
    scene.size = {17, 18, 16};
    scene.spacingM = {60.0, 60.0, 50.0};
    aimSun(scene, 50.0);
    scene.fields = {{randomExtinction(scene.size, 0.004, 3), albedo, henyeyGreenstein(0.85)}};
    return scene;
}

/// Looser majorants and other brick sizes cost more null collisions and change nothing else.
Trial majorantTrial(double scale, int brickVoxels) {
    Trial trial;
    trial.name =
        fmt::format("Random medium: bounds {:g} times as large, bricks of {}", scale, brickVoxels);
    trial.source = "unscaled majorants, bricks of 4";
    trial.scene = randomScene(0.9);
    trial.quick = false;
    trial.settings.majorantScale = scale;
    trial.settings.brickVoxels = brickVoxels;
    trial.twin = Twin{trial.scene, {}};
    addFluxes(trial, 0.2, 0.6, 0.2);
    return trial;
}

/// The same slab on different grids: g 0.85, optical depth 8, sun overhead. docs/validation.md
/// states the source of the values.
Trial resolutionTrial(glm::ivec3 size, bool trilinear) {
    Trial trial;
    trial.name = fmt::format("Uniform slab of {} x {} x {} {}", size.x, size.y, size.z,
                             trilinear ? "voxels, interpolated" : "voxels");
    trial.source = "adding-doubling";
    trial.scene.size = size;
    trial.scene.spacingM = glm::dvec3(4000.0, 4000.0, 1000.0) / glm::dvec3(size);
    trial.scene.trilinear = trilinear;
    trial.scene.fields = {uniform(trial.scene, 8e-3, 1.0, henyeyGreenstein(0.85))};
    addFluxes(trial, 0.35843207, 0.64156793, 0.38601262);
    return trial;
}

/// Incident light is reflected, transmitted or absorbed: R + T + A = 1.
Trial balanceTrial() {
    Trial trial;
    trial.name = "Random medium that absorbs: balance of energy";
    trial.source = "R + T + A = 1";
    trial.scene = randomScene(0.95);
    addFluxes(trial, 0.4, 0.6, 0.5);
    trial.quantities.pop_back();
    trial.detectors.pop_back();
    const glm::dvec3 extentM = extentOf(trial.scene);
    const double mu = trial.scene.towardsSun.z;
    trial.detectors.push_back({DetectorKind::absorption, {{0.0, 0.0, 0.0}, extentM}});
    const double perVolume = extentM.z / mu;
    for (Quantity& quantity : trial.quantities) quantity.expected.reset();
    trial.quantities.push_back({"A", {{2, perVolume}}, 0.0, {}});
    trial.quantities.push_back({"R + T + A",
                                {{0, 1.0 / mu}, {1, 1.0 / mu}, {2, perVolume}},
                                0.0,
                                Expected{1.0, kFluxTolerance, ""}});
    return trial;
}

/// A Lambertian surface under clear air reflects its albedo, in every direction alike.
Trial groundTrial() {
    constexpr double kAlbedo = 0.3;
    Trial trial;
    trial.name = "Lambert ground of albedo 0.3 under the sun at 50°";
    trial.source = "pi I / (mu0 F0) = albedo";
    trial.scene = slabScene();
    trial.scene.fields = {uniform(trial.scene, 0.0, 1.0, {})};
    trial.scene.surfaceAlbedo = kAlbedo;
    addFluxes(trial, kAlbedo, 1.0, kAlbedo);
    return trial;
}

}  // namespace

std::vector<Trial> invarianceTrials() {
    std::vector<Trial> trials;
    trials.push_back(mixtureTrial());
    trials.push_back(majorantTrial(3.0, 4));
    trials.push_back(majorantTrial(1.0, 2));
    trials.push_back(majorantTrial(1.0, 16));
    trials.push_back(resolutionTrial({1, 1, 1}, false));
    trials.push_back(resolutionTrial({7, 5, 16}, false));
    trials.push_back(resolutionTrial({7, 5, 16}, true));
    trials.push_back(balanceTrial());
    trials.push_back(groundTrial());
    return trials;
}

}  // namespace neph::validate
