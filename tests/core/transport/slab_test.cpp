// slab_test.cpp: layers whose reflection and transmission are known. docs/physics.md
#include <doctest/doctest.h>

#include <numbers>

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
    {0.00, 1.00, 8, 0.82180326, 0.17819674, 0.87664848, 0.12335152, 128},
    {0.00, 1.00, 64, 0.97433809, 0.025661913, 0.98223689, 0.017763109, 768},
    {0.00, 0.99, 8, 0.72875013, 0.12206761, 0.79890886, 0.082649101, 128},
    {0.85, 1.00, 1, 0.042316093, 0.95768391, 0.16487754, 0.83512246, 32},
    {0.85, 1.00, 8, 0.35843207, 0.64156793, 0.55807755, 0.44192245, 64},
    {0.85, 1.00, 64, 0.84628087, 0.15371913, 0.89496971, 0.10503029, 384},
    {0.85, 0.99, 8, 0.30214904, 0.55894095, 0.48675994, 0.36765323, 64},
};

TransportBudget slabBudget(const SlabRow& row, bool low, bool aligned, int cycles) {
    TransportSlab slab{row.g, row.opticalDepth, row.singleScattering, {2, 2, row.layers + 1}};
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

TEST_CASE("transport: slabs reflect and transmit what adding and doubling says") {
    for (const SlabRow& row : kSlabRows) {
        for (const bool low : {false, true}) {
            CAPTURE(row.g);
            CAPTURE(row.opticalDepth);
            CAPTURE(row.singleScattering);
            CAPTURE(low);
            const TransportBudget budget = slabBudget(row, low, false, 80);
            MESSAGE(row.g << " " << row.opticalDepth << " " << low << ": R " << budget.reflected
                          << " (" << (low ? row.reflectedLow : row.reflectedHigh) << ") T "
                          << budget.transmitted << " ("
                          << (low ? row.transmittedLow : row.transmittedHigh) << ")");
            CHECK(std::abs(budget.reflected - (low ? row.reflectedLow : row.reflectedHigh)) < 0.01);
            CHECK(std::abs(budget.transmitted - (low ? row.transmittedLow : row.transmittedHigh)) <
                  0.01);
        }
    }
}
