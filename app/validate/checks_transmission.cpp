// checks_transmission.cpp: Beer-Lambert law, T = exp(-∫ extinction), [Riley03] eq. 6, against a
// plain sum in double precision over the sun's disc.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/validate/checks.h"

namespace neph::validate {
namespace {

using render::DetectorKind;
using render::MeterScene;

constexpr double kTolerance = 1e-3;  // relative

/// Extinction as textures interpolate it: between voxel centres, or constant in each voxel.
double extinctionAt(const MeterScene& scene, glm::dvec3 positionM) {
    const Array3f& field = scene.fields.front().extinctionPerM;
    const glm::dvec3 at = positionM / scene.spacingM - (scene.trilinear ? 0.5 : 0.0);
    const glm::dvec3 lower = glm::floor(at);
    const glm::dvec3 share = scene.trilinear ? at - lower : glm::dvec3(0.0);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step{corner & 1, (corner >> 1) & 1, corner >> 2};
        const glm::dvec3 weights = glm::mix(1.0 - share, share, glm::dvec3(step));
        const glm::ivec3 voxel =
            glm::clamp(glm::ivec3(lower) + step, glm::ivec3(0), scene.size - 1);
        sum += weights.x * weights.y * weights.z *
               static_cast<double>(field.at(voxel.x, voxel.y, voxel.z));
    }
    return sum;
}

/// Optical depth from a point to where the ray leaves the grid, by the midpoint rule.
double opticalDepth(const MeterScene& scene, glm::dvec3 positionM, glm::dvec3 dir) {
    constexpr int kSteps = 20000;
    const glm::dvec3 extentM = glm::dvec3(scene.size) * scene.spacingM;
    double lengthM = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (dir[axis] == 0.0) continue;
        const double wallM = dir[axis] > 0.0 ? extentM[axis] : 0.0;
        lengthM = std::min(lengthM, (wallM - positionM[axis]) / dir[axis]);
    }
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        sum += extinctionAt(scene, positionM + dir * (lengthM * (i + 0.5) / kSteps));
    }
    return sum * lengthM / kSteps;
}

/// Direct irradiance of a horizontal plane, for a beam of irradiance 1 from the sun's disc.
double directIrradiance(const MeterScene& scene, glm::dvec3 positionM) {
    double sum = 0.0;
    const std::vector<glm::dvec3> disc = sunDisc(scene);
    for (const glm::dvec3 dir : disc) {
        sum += std::exp(-opticalDepth(scene, positionM, dir)) * dir.z;
    }
    return sum / static_cast<double>(disc.size());
}

MeterScene randomScene(bool trilinear) {
    MeterScene scene;
    scene.size = {12, 12, 12};
    scene.spacingM = {100.0, 120.0, 80.0};
    scene.trilinear = trilinear;
    scene.periodic = false;
    Array3f extinction = randomExtinction(scene.size, 2e-3, 7);
    // The outermost voxels are empty, so that interpolation at the boundary does not matter.
    for (int z = 0; z < 12; ++z) {
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 12; ++x) {
                const bool inner = std::min({x, y, z}) > 0 && std::max({x, y, z}) < 11;
                if (!inner) extinction.at(x, y, z) = 0.0f;
            }
        }
    }
    scene.fields.push_back({std::move(extinction), 0.0, {}});
    return scene;
}

/// Direct irradiance at two points of a random medium, on the ground and inside.
Trial randomTrial(bool trilinear, double zenithDeg, const render::MeterSettings& settings) {
    Trial trial;
    trial.name =
        fmt::format("Beer-Lambert: random medium, {}, sun at {:g}°, bound times {:g}, bricks of {}",
                    trilinear ? "interpolated" : "voxels", zenithDeg, settings.majorantScale,
                    settings.brickVoxels);
    trial.settings = settings;
    trial.source = "exp(-optical depth), summed in double precision";
    trial.scene = randomScene(trilinear);
    const double zenith = glm::radians(zenithDeg);
    trial.scene.towardsSun = {0.8 * std::sin(zenith), 0.6 * std::sin(zenith), std::cos(zenith)};
    for (const glm::dvec3 point : {glm::dvec3(410.0, 530.0, 0.0), glm::dvec3(233.0, 317.0, 87.0)}) {
        trial.detectors.push_back({DetectorKind::flux, {point, point}, {0.0, 0.0, 1.0}});
        const double expected = directIrradiance(trial.scene, point);
        trial.quantities.push_back(
            {fmt::format("irradiance at {:g}, {:g}, {:g} m", point.x, point.y, point.z),
             {{trial.detectors.size() - 1, 1.0}},
             0.0,
             Expected{expected, kTolerance * expected, ""}});
    }
    return trial;
}

/// A slab that is a single voxel.
Trial uniformTrial(double depth, double mu) {
    Trial trial;
    trial.name = fmt::format("Beer-Lambert: uniform slab, optical depth {:g}", depth / mu);
    trial.source = "exp(-optical depth)";
    trial.scene.spacingM = {4000.0, 4000.0, 1000.0};
    trial.scene.fields.push_back(
        {Array3f(glm::ivec3(1), static_cast<float>(depth / 1000.0)), 0.0, {}});
    trial.scene.towardsSun = {std::sqrt(1.0 - mu * mu), 0.0, mu};
    trial.detectors.push_back({DetectorKind::flux, {{0.0, 0.0, 0.0}, {4000.0, 4000.0, 0.0}}});
    const double expected = std::exp(-depth / mu);
    trial.quantities.push_back(
        {"T direct", {{0, 1.0 / mu}}, 0.0, Expected{expected, kTolerance * expected, ""}});
    return trial;
}

}  // namespace

std::vector<Trial> transmissionTrials() {
    std::vector<Trial> trials;
    trials.push_back(uniformTrial(0.1, 1.0));
    trials.push_back(uniformTrial(1.0, 1.0));
    trials.push_back(uniformTrial(1.0, 0.5));
    for (const bool trilinear : {false, true}) {
        for (const double zenithDeg : {0.0, 40.0}) {
            trials.push_back(randomTrial(trilinear, zenithDeg, {}));
        }
    }
    trials.push_back(randomTrial(false, 40.0, {.majorantScale = 3.0}));
    for (const int brickVoxels : {2, 16}) {
        trials.push_back(randomTrial(true, 40.0, {.brickVoxels = brickVoxels}));
    }
    return trials;
}

std::vector<glm::dvec3> sunDisc(const render::MeterScene& scene) {
    constexpr int kRings = 7, kSpokes = 6;
    const glm::dvec3 a = glm::normalize(glm::cross(scene.towardsSun, glm::dvec3(0.3, 1.0, 0.2)));
    const glm::dvec3 b = glm::cross(scene.towardsSun, a);
    std::vector<glm::dvec3> disc;
    for (int ring = 0; ring < kRings; ++ring) {
        const double radius = scene.sunRadiusRad * std::sqrt((ring + 0.5) / kRings);
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double angle = 2.0 * M_PI * (spoke + 0.5 * (ring % 2)) / kSpokes;
            disc.push_back(glm::normalize(scene.towardsSun +
                                          radius * (std::cos(angle) * a + std::sin(angle) * b)));
        }
    }
    return disc;
}

double RandomNumbers::next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;  // [Knuth] MMIX
    return static_cast<double>(state_ >> 11U) * 0x1p-53;
}

Array3f randomExtinction(glm::ivec3 size, double meanPerM, std::uint32_t seed) {
    Array3f extinction(size);
    RandomNumbers numbers(seed);
    for (float& value : extinction.values) {
        const double here = numbers.next();  // the lower third of its range leaves a voxel empty
        value = here < 1.0 / 3.0 ? 0.0f : static_cast<float>(3.0 * meanPerM * (here - 1.0 / 3.0));
    }
    return extinction;
}

PhaseSpec henyeyGreenstein(double g) {
    PhaseSpec spec;
    spec.kind = PhaseKind::henyeyGreenstein;
    spec.g = static_cast<float>(g);
    return spec;
}

}  // namespace neph::validate
