// slab_test.cpp: layers whose reflection and transmission are known. docs/transport.md
#include <doctest/doctest.h>

#include <cmath>

#include "core/transport/light_solver.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

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

TransportBudget slabBudget(const SlabRow& row, bool low, bool aligned, int cycles) {
    TransportSlab slab{row.g, row.opticalDepth, row.singleScattering, {2, 2, row.layers + 1}};
    // The peak is kept where the horizontal distance of nodes is optically thin.
    if (aligned) slab.widthToHeight = 0.5 * row.layers / row.opticalDepth;
    LightScene scene;
    scene.periodicSides = true;
    const double sine = low ? 0.5 : 1.0;
    scene.towardsSun = {std::sqrt(1.0 - sine * sine), 0.0, sine};
    LightSettings settings;
    settings.aligned = aligned;
    settings.levels = 9;  // a column halves in few nodes at a time
    settings.coldCycles = 12;
    LightSolver solver(slab.medium(), scene, settings);
    for (int i = 0; i < cycles; ++i) solver.cycle();
    return transportBudget(solver);
}

}  // namespace

TEST_CASE("transport: slabs reflect and transmit what adding and doubling says" *
          doctest::skip(!kSolvesInSeconds)) {
    for (const SlabRow& row : kSlabRows) {
        for (const bool low : {false, true}) {
            CAPTURE(row.g);
            CAPTURE(row.opticalDepth);
            CAPTURE(row.singleScattering);
            CAPTURE(low);
            const TransportBudget budget = slabBudget(row, low, false, 40);
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
        const TransportBudget budget = slabBudget(row, low, true, 40);
        CHECK(std::abs(budget.reflected - (low ? row.reflectedLow : row.reflectedHigh)) < 0.004);
        CHECK(std::abs(budget.transmitted - (low ? row.transmittedLow : row.transmittedHigh)) <
              0.01);
    }
}

TEST_CASE("transport: the step cloud of I3RC reflects and transmits what the consensus says") {
    // Case 1, experiments 1 and 2: columns of optical depth 2 and 18. [Cahalan05]
    TransportSlab slab{0.85, 18.0, 1.0, {32, 2, 33}};
    LightMedium medium = slab.medium();
    medium.spacingM = {15.625, 1000.0, 250.0 / 32.0};
    for (int k = 0; k < 33; ++k) {
        for (int i = 0; i < 32; ++i) {
            for (int j = 0; j < 2; ++j) {
                medium.classes[0].extinctionPerM.at(i, j, k) = i < 16 ? 0.008f : 0.072f;
            }
        }
    }
    for (const bool low : {false, true}) {
        LightScene scene;
        scene.periodicSides = true;
        if (low) scene.towardsSun = {-std::sqrt(0.75), 0.0, 0.5};
        LightSettings settings;
        LightSolver solver(medium, scene, settings);
        for (int i = 0; i < 40; ++i) solver.cycle();
        const TransportBudget budget = transportBudget(solver);
        CAPTURE(low);
        CHECK(budget.reflected == doctest::Approx(low ? 0.58044 : 0.32760).epsilon(0.01));
        CHECK(budget.transmitted == doctest::Approx(low ? 0.41956 : 0.67240).epsilon(0.01));
    }
}
