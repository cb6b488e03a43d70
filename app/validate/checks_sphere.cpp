// checks_sphere.cpp: parallel light on a uniform sphere: the directly transmitted light, and the
// energy scattered into ten equal intervals of cos Θ.
//
// The intensity in a direction is the radiance of the sphere seen from there, integrated over its
// disc by parallel rays through a plane beyond the sphere. Each interval is integrated by
// Gauss-Legendre quadrature. The sphere consists of the voxels whose centre is inside: voxels with
// fractional extinction at the edge would widen the shadow of a thick sphere by 1 %.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/validate/checks.h"

namespace neph::validate {
namespace {

using render::Detector;
using render::DetectorKind;

constexpr double kRadiusM = 1000.0;
constexpr int kVoxels = 96;  // along a diameter
constexpr int kBins = 10;
constexpr double kBinWidth = 2.0 / kBins;

/// Results of an independent Monte Carlo model with one million photons, ±0.0005 per bin: shares of
/// the energy incident on the sphere, from cos Θ = -1 to 1.
struct Published {
    double depth;  ///< optical depth along the radius
    double g, albedo;
    std::array<double, kBins> bins;
};
constexpr std::array<Published, 3> kPublished{{
    {1.0, 0.85, 1.0, {.0068, .0079, .0096, .0117, .0149, .0196, .0274, .0430, .0842, .4783}},
    {20.0, 0.85, 1.0, {.1162, .1109, .1078, .1038, .1013, .0978, .0952, .0922, .0889, .0846}},
    {5.0, 0.0, 1.0, {.1650, .1487, .1328, .1172, .1042, .0896, .0760, .0626, .0490, .0350}},
}};
// Four standard errors of the published values, which leaves a margin for the voxels.
constexpr double kBinTolerance = 0.002;

bool isInside(glm::ivec3 voxel) {
    return glm::length((glm::dvec3(voxel) + 0.5) * (2.0 / kVoxels) - 1.0) < 1.0;
}

/// The sphere of radius kRadiusM in a cube of voxels, with empty surroundings.
render::MeterScene sphere(const Published& of) {
    render::MeterScene scene;
    scene.size = glm::ivec3(kVoxels);
    scene.spacingM = glm::dvec3(2.0 * kRadiusM / kVoxels);
    scene.periodic = false;
    render::MeterField field{Array3f(scene.size), of.albedo, henyeyGreenstein(of.g)};
    for (int z = 0; z < kVoxels; ++z) {
        for (int y = 0; y < kVoxels; ++y) {
            for (int x = 0; x < kVoxels; ++x) {
                field.extinctionPerM.at(x, y, z) =
                    isInside({x, y, z}) ? static_cast<float>(of.depth / kRadiusM) : 0.0f;
            }
        }
    }
    scene.fields.push_back(std::move(field));
    return scene;
}

/// Sees all light that leaves the sphere in the direction `leaving`, which lies in the plane y = 0.
/// The detector is the plane beyond the sphere that is more nearly perpendicular to it. Its reading
/// is the mean radiance over the square around the disc, 4 r².
Detector distantDetector(glm::dvec3 leaving) {
    const int axis = std::abs(leaving.z) > std::abs(leaving.x) ? 2 : 0;
    const int other = 2 - axis;
    const double side = leaving[axis] > 0.0 ? 1.0 : -1.0;
    const double half = kRadiusM / std::abs(leaving[axis]);
    glm::dvec3 middle(kRadiusM);
    middle[axis] += side * kRadiusM;
    middle[other] += kRadiusM * leaving[other] / std::abs(leaving[axis]);
    glm::dvec3 reach{0.0, kRadiusM, 0.0};
    reach[other] = half;
    return {DetectorKind::radiance, {middle - reach, middle + reach}, -leaving};
}

/// Nodes (x) and weights (y) of Gauss-Legendre quadrature on [-1, 1], by Newton's method on the
/// Legendre polynomial.
std::vector<glm::dvec2> gaussLegendre(int count) {
    std::vector<glm::dvec2> rule;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(M_PI * (i + 0.75) / (count + 0.5)), slope = 1.0;
        for (int step = 0; step < 20; ++step) {
            double last = 1.0, p = x;
            for (int n = 2; n <= count; ++n) {
                const double next = ((2 * n - 1) * x * p - (n - 1) * last) / n;
                last = p;
                p = next;
            }
            slope = count * (x * p - last) / (x * x - 1.0);
            x -= p / slope;
        }
        rule.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
    }
    return rule;
}

/// Energy scattered into one bin: 2π times the integral of the intensity, divided by the energy
/// incident on π r².
Quantity binOf(Trial& trial, int bin, double expected) {
    const double low = -1.0 + kBinWidth * bin;
    Quantity quantity{fmt::format("scattered, cos {:.1f} to {:.1f}", low, low + kBinWidth),
                      {},
                      0.0,
                      Expected{expected, kBinTolerance, ""}};
    // The phase function of g = 0.85 varies by a factor of 40 within the last bin.
    for (const glm::dvec2 node : gaussLegendre(bin == kBins - 1 ? 12 : 4)) {
        const double mu = low + 0.5 * kBinWidth * (node.x + 1.0);
        // Sunlight travels downwards, so cos Θ = -z.
        trial.detectors.push_back(distantDetector({std::sqrt(1.0 - mu * mu), 0.0, -mu}));
        const double intensity = 4.0 * kRadiusM * kRadiusM;
        quantity.terms.push_back(
            {trial.detectors.size() - 1,
             2.0 * M_PI * 0.5 * kBinWidth * node.y * intensity / (M_PI * kRadiusM * kRadiusM)});
    }
    return quantity;
}

/// Scattered energy, bin by bin and in total.
Trial binTrial(const Published& of) {
    Trial trial;
    trial.name = fmt::format("Sphere: optical radius {:g}, g {:g}", of.depth, of.g);
    trial.source = "independent Monte Carlo, 10^6 photons";
    trial.scene = sphere(of);
    trial.quick = of.depth < 10.0;
    for (int bin = 0; bin < kBins; ++bin) {
        trial.quantities.push_back(binOf(trial, bin, of.bins[static_cast<std::size_t>(bin)]));
    }
    Quantity all{"scattered in total", {}, 0.0, {}};
    for (const Quantity& quantity : trial.quantities) {
        all.terms.insert(all.terms.end(), quantity.terms.begin(), quantity.terms.end());
    }
    // Mean of exp(-τ) over the chords of a sphere; t is the optical depth of its diameter.
    const double t = 2.0 * of.depth;
    const double direct = 2.0 * (1.0 - (1.0 + t) * std::exp(-t)) / (t * t);
    all.expected = Expected{1.0 - direct, 3e-3, "1 - 2 (1 - (1 + t) exp(-t)) / t², t = 2 τ"};
    trial.quantities.push_back(std::move(all));
    return trial;
}

/// Directly transmitted light: the sphere absorbs everything else.
Trial directTrial(const Published& of) {
    Trial trial;
    trial.name = fmt::format("Sphere: optical radius {:g}, direct light", of.depth);
    trial.source = "2 (1 - (1 + t) exp(-t)) / t², t = 2 τ";
    trial.scene = sphere(of);
    trial.scene.fields.front().albedo = 0.0;
    trial.detectors.push_back(
        {DetectorKind::flux, {{0.0, 0.0, 0.0}, {2.0 * kRadiusM, 2.0 * kRadiusM, 0.0}}});
    const double t = 2.0 * of.depth;
    const double direct = 2.0 * (1.0 - (1.0 + t) * std::exp(-t)) / (t * t);
    // The square also receives the light that passes beside the sphere.
    trial.quantities.push_back(
        {"direct", {{0, 4.0 / M_PI}}, 1.0 - 4.0 / M_PI, Expected{direct, 1e-3, ""}});
    return trial;
}

}  // namespace

std::vector<Trial> sphereTrials() {
    std::vector<Trial> trials;
    for (const Published& of : kPublished) trials.push_back(directTrial(of));
    for (const Published& of : kPublished) trials.push_back(binTrial(of));
    return trials;
}

}  // namespace neph::validate
