// slab_test.cpp: layers whose reflection, transmission and radiances are known. docs/transport.md
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/transport/light_solver.h"
#include "shaders/lib/glsl_cpp.h"
#include "tests/core/transport/transport_slab.h"
#include "tests/core/transport/view_rays.h"

using namespace neph;

namespace {

const double kSine60 = std::sqrt(0.75);

/// By adding and doubling with 48 points a hemisphere, good to 2e-7; transmission includes the
/// beam.
struct SlabRow {
    double g, singleScattering, opticalDepth;
    double reflectedHigh, transmittedHigh;  ///< sun in the zenith
    double reflectedLow, transmittedLow;    ///< sun at 30 degrees
    int layers;                             ///< so that the scaled depth of each is about 0.1
};

const SlabRow kSlabRows[] = {
    {0.00, 1.00, 1, 0.34132876, 0.65867124, 0.49837553, 0.50162447, 32},
    {0.00, 1.00, 8, 0.82180326, 0.17819674, 0.87664848, 0.12335152, 96},
    {0.00, 1.00, 64, 0.97433809, 0.025661913, 0.98223689, 0.017763109, 512},
    {0.00, 0.99, 8, 0.72875013, 0.12206761, 0.79890886, 0.082649101, 96},
    {0.85, 1.00, 1, 0.042316093, 0.95768391, 0.16487754, 0.83512246, 32},
    {0.85, 1.00, 8, 0.35843207, 0.64156793, 0.55807755, 0.44192245, 64},
    {0.85, 1.00, 64, 0.84628087, 0.15371913, 0.89496971, 0.10503029, 256},
    {0.85, 0.99, 8, 0.30214904, 0.55894095, 0.48675994, 0.36765323, 64},
};

LightMedium slabMedium(const SlabRow& row, bool aligned) {
    TransportSlab slab{row.g, row.opticalDepth, row.singleScattering, {2, 2, row.layers + 1}};
    // The peak is kept where the horizontal distance of nodes is optically thin.
    if (aligned) slab.widthToHeight = 0.5 * row.layers / row.opticalDepth;
    return slab.medium();
}

/// Sunlight travels towards +x, as I3RC has it.
LightScene periodicScene(bool low) {
    LightScene scene;
    scene.periodicSides = true;
    if (low) scene.towardsSun = {-kSine60, 0.0, 0.5};
    return scene;
}

LightSolver solvedSlab(const SlabRow& row, bool low, bool aligned, int cycles) {
    LightSettings settings;
    settings.aligned = aligned;
    settings.levels = 9;  // a column halves in few nodes at a time
    settings.coldCycles = 12;
    LightSolver solver(slabMedium(row, aligned), periodicScene(low), settings);
    for (int i = 0; i < cycles; ++i) solver.cycle();
    return solver;
}

constexpr double kStepCloudG = 0.85;

/// Case 1 of I3RC: columns of optical depth 2 and 18, a node each. [Cahalan05]
LightMedium stepCloud() {
    constexpr int kColumns = 32, kLayers = 32;
    constexpr double kWidthM = 500.0, kHeightM = 250.0;
    TransportSlab slab{kStepCloudG, 18.0, 1.0, {kColumns, 2, kLayers + 1}};
    LightMedium medium = slab.medium();
    medium.spacingM = {kWidthM / kColumns, 1000.0, kHeightM / kLayers};
    for (int k = 0; k <= kLayers; ++k) {
        for (int i = 0; i < kColumns; ++i) {
            const double opticalDepth = i < kColumns / 2 ? 2.0 : 18.0;
            for (int j = 0; j < 2; ++j) {
                medium.classes[0].extinctionPerM.at(i, j, k) =
                    static_cast<float>(opticalDepth / kHeightM);
            }
        }
    }
    return medium;
}

struct ExpectedRadiance {
    const char* name;
    glm::dvec3 travel;
    double value;  ///< times pi, over the irradiance of the top
    double relative;
};

void checkRadiances(const LightSolver& solver, const LightMedium& medium, double g,
                    std::span<const ExpectedRadiance> rows) {
    const std::vector<PhaseOfCosine> phases{
        [&](float cosTheta) { return glsl::hgValue(cosTheta, static_cast<float>(g)); }};
    for (const ExpectedRadiance& row : rows) {
        CAPTURE(row.name);
        const double measured = leavingRadiance(solver, medium, phases, row.travel);
        CHECK(measured == doctest::Approx(row.value).epsilon(row.relative));
    }
}

const glm::dvec3 kUp(0.0, 0.0, 1.0), kDown(0.0, 0.0, -1.0);
const glm::dvec3 kUpForward(kSine60, 0.0, 0.5), kUpBackward(-kSine60, 0.0, 0.5);
const glm::dvec3 kDownForward(kSine60, 0.0, -0.5);

/// By a slab that delta-M scales to l = 2, after [Chandrasekhar60].
double scatteredOnce(double g, double opticalDepth, const LightScene& scene,
                     const glm::dvec3& travel) {
    const double kept = 1.0 - g * g * g, depth = kept * opticalDepth;
    const double sun = scene.towardsSun.z, eye = std::abs(travel.z);
    const auto cosTheta = static_cast<float>(-glm::dot(travel, scene.towardsSun));
    const float phase = glsl::hgValue(cosTheta, static_cast<float>(g));
    const double source = std::numbers::pi * static_cast<double>(phase) / kept;
    if (travel.z > 0.0) {
        return source / (sun + eye) * (1.0 - std::exp(-depth * (1.0 / sun + 1.0 / eye)));
    }
    return source / (sun - eye) * (std::exp(-depth / sun) - std::exp(-depth / eye));
}

/// Of kSlabRows[4], by adding and doubling as well.
const ExpectedRadiance kThinSlabFromZenith[] = {
    {"up at 0", kUp, 0.017625947, 0.05},
    {"up at 60", kUpForward, 0.054834579, 0.02},
    {"down at 60", kDownForward, 0.17293717, 0.01},
};

}  // namespace

TEST_CASE("transport: slabs reflect and transmit what adding and doubling says" *
          doctest::skip(!kSolvesInSeconds)) {
    for (const SlabRow& row : kSlabRows) {
        for (const bool low : {false, true}) {
            CAPTURE(row.g);
            CAPTURE(row.opticalDepth);
            CAPTURE(row.singleScattering);
            CAPTURE(low);
            const TransportBudget budget = transportBudget(solvedSlab(row, low, false, 40));
            const double reflected = low ? row.reflectedLow : row.reflectedHigh;
            const double transmitted = low ? row.transmittedLow : row.transmittedHigh;
            CHECK(std::abs(budget.reflected - reflected) < 0.01);
            CHECK(std::abs(budget.transmitted - transmitted) < 0.01);
            if (row.singleScattering < 1.0) continue;
            CHECK(budget.reflected + budget.transmitted == doctest::Approx(1.0).epsilon(0.015));
        }
    }
}

TEST_CASE("transport: rings about the sun find the faint reflection of a thin slab" *
          doctest::skip(!kSolvesInSeconds)) {
    // Moments to l = 2 put a fifth too little into it.
    const SlabRow& row = kSlabRows[4];
    for (const bool low : {false, true}) {
        const LightSolver solver = solvedSlab(row, low, true, 40);
        const TransportBudget budget = transportBudget(solver);
        CHECK(std::abs(budget.reflected - (low ? row.reflectedLow : row.reflectedHigh)) < 0.004);
        CHECK(std::abs(budget.transmitted - (low ? row.transmittedLow : row.transmittedHigh)) <
              0.01);
        // Under a low sun moments about it do not tell what leaves a thin slab: docs/transport.md
        if (!low) checkRadiances(solver, slabMedium(row, true), row.g, kThinSlabFromZenith);
    }
}

TEST_CASE("transport: rays of view see light that was scattered once as the closed form has it") {
    // Before any cycle there is no other.
    constexpr double kG = 0.85, kDepth = 2.0;
    const TransportSlab slab{kG, kDepth, 1.0, {4, 2, 17}};
    const LightMedium medium = slab.medium();
    for (const bool low : {false, true}) {
        CAPTURE(low);
        const LightSolver solver(medium, periodicScene(low), {});
        std::vector<ExpectedRadiance> rows;
        for (const glm::dvec3& travel :
             {kUp, kUpForward, kUpBackward, low ? kDown : kDownForward}) {
            rows.push_back(
                {"once", travel, scatteredOnce(kG, kDepth, solver.scene(), travel), 0.002});
        }
        checkRadiances(solver, medium, kG, rows);
    }
}

TEST_CASE("transport: what a slab sends up and down under a low sun is what reciprocity says") {
    // With sun and eye exchanged it is that of the sun in the zenith.
    const SlabRow& row = kSlabRows[4];
    const ExpectedRadiance rows[] = {{"up", kUp, kThinSlabFromZenith[1].value, 0.04},
                                     {"down", kDown, kThinSlabFromZenith[2].value, 0.02}};
    checkRadiances(solvedSlab(row, true, false, 40), slabMedium(row, false), row.g, rows);
}

TEST_CASE("transport: the step cloud of I3RC reflects and transmits what the consensus says") {
    for (const bool low : {false, true}) {
        LightSolver solver(stepCloud(), periodicScene(low), {});
        for (int i = 0; i < 40; ++i) solver.cycle();
        const TransportBudget budget = transportBudget(solver);
        CAPTURE(low);
        CHECK(budget.reflected == doctest::Approx(low ? 0.58044 : 0.32760).epsilon(0.01));
        CHECK(budget.transmitted == doctest::Approx(low ? 0.41956 : 0.67240).epsilon(0.01));
    }
}

TEST_CASE("transport: the step cloud of I3RC is as bright from outside as the consensus says" *
          doctest::skip(!kSolvesInSeconds)) {
    // Means over the 32 columns; what goes forward is not in the consensus, but from an independent
    // Monte Carlo model: tests/validation/i3rc-case1-step-cloud.json
    const ExpectedRadiance high[] = {{"Iu", kUp, 0.2564, 0.03},
                                     {"I60 forward", kUpForward, 0.405, 0.03},
                                     {"I60 backward", kUpBackward, 0.40425, 0.03}};
    // Id is 5 to 6 % too bright, and 2 to 3 % of R is lost: docs/transport.md
    const ExpectedRadiance low[] = {{"Iu", kUp, 0.40607, 0.05},
                                    {"I60 forward", kUpForward, 1.03, 0.05},
                                    {"I60 backward", kUpBackward, 0.56674, 0.05},
                                    {"Id", kDown, 0.39303, 0.065}};
    const LightMedium medium = stepCloud();
    LightSettings settings;
    settings.aligned = true;
    for (const bool isLow : {false, true}) {
        CAPTURE(isLow);
        LightSolver solver(medium, periodicScene(isLow), settings);
        for (int i = 0; i < 30; ++i) solver.cycle();
        const TransportBudget budget = transportBudget(solver);
        CHECK(budget.reflected ==
              doctest::Approx(isLow ? 0.58044 : 0.32760).epsilon(isLow ? 0.035 : 0.01));
        CHECK(budget.transmitted == doctest::Approx(isLow ? 0.41956 : 0.67240).epsilon(0.01));
        checkRadiances(solver, medium, kStepCloudG,
                       isLow ? std::span<const ExpectedRadiance>(low) : high);
    }
}
