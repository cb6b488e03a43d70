// optics_test.cpp: extinction from mass, and the update of the light buffer. Expected values are
// from docs/physics.md §1 and §3.
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;
using doctest::Approx;

namespace {

struct Field {
    const char* name;
    float radiusM, densityKgPerM3;
    double crossSectionM2, concentrationPerM3, massExtinction, opticalDepthOfKm, freePathM;
};

/// [Riley03] table 3 with the densities of docs/physics.md; numbers for 1 g of particles per m³.
constexpr Field kFields[] = {
    {"cloud", 10e-6f, 1000.0f, 6.283e-10, 2.387e8, 150.0, 150.0, 6.67},
    {"ice", 1e-3f, 917.0f, 6.283e-6, 260.3, 1.636, 1.636, 611.0},
    {"rain", 1e-3f, 1000.0f, 6.283e-6, 238.7, 1.5, 1.5, 667.0},
    {"snow", 2e-3f, 100.0f, 2.513e-5, 298.4, 7.5, 7.5, 133.0},
    {"graupel", 2.5e-3f, 400.0f, 3.927e-5, 38.2, 1.5, 1.5, 667.0},
};

/// Uniform light of 1 after a layer that is divided into equal slices.
template <typename Step>
float throughSlices(float opticalDepth, int slices, Step step) {
    float light = 1.0f;
    for (int i = 0; i < slices; ++i) light = step(light, opticalDepth / static_cast<float>(slices));
    return light;
}

}  // namespace

TEST_CASE("Table 3 radii give the tabulated cross-section, concentration and extinction") {
    for (const Field& f : kFields) {
        CAPTURE(f.name);
        const float concentration = glsl::numberConcentration(1e-3f, f.radiusM, f.densityKgPerM3);
        const float perM =
            glsl::extinctionPerM(glsl::extinctionCrossSection(f.radiusM), concentration);
        CHECK(glsl::extinctionCrossSection(f.radiusM) == Approx(f.crossSectionM2).epsilon(2e-4));
        CHECK(concentration == Approx(f.concentrationPerM3).epsilon(2e-3));
        CHECK(perM * 1000.0f == Approx(f.opticalDepthOfKm).epsilon(2e-4));
        CHECK(1.0f / perM == Approx(f.freePathM).epsilon(4e-3));
        CHECK(glsl::massExtinctionM2PerKg(f.radiusM, f.densityKgPerM3) ==
              Approx(f.massExtinction).epsilon(3e-4));
    }
}

TEST_CASE("A sphere of radius 1 holds 4.18879 and transmittance of depth 1 is 1/e") {
    CHECK(glsl::volumeOfSphere(1.0f) == Approx(4.18879020).epsilon(1e-6));
    CHECK(glsl::transmittance(1.0f) == Approx(0.36787944).epsilon(1e-6));
    CHECK(glsl::transmittance(0.0f) == 1.0f);
}

TEST_CASE(
    "The printed light update gives 0.503, 0.150 and 0.096 for 1, 5 and 20 slices of depth 5") {
    auto step = [](float light, float tau) {
        return glsl::lightStepPrinted(light, light, tau, 0.2f, 0.5f);
    };
    CHECK(throughSlices(5.0f, 1, step) == Approx(0.503).epsilon(1e-3));
    CHECK(throughSlices(5.0f, 5, step) == Approx(0.150).epsilon(4e-3));
    CHECK(throughSlices(5.0f, 20, step) == Approx(0.096).epsilon(6e-3));
    CHECK(throughSlices(5.0f, 20000, step) == Approx(std::exp(-2.5)).epsilon(1e-3));
}

TEST_CASE("The consistent light update does not depend on the number of slices") {
    for (float albedo : {1.0f, 0.9f}) {
        for (float forward : {0.0f, 1e-6f, 0.5f, 0.9f, 1.0f}) {
            for (int slices : {1, 5, 20, 128}) {
                for (float depth : {0.01f, 1.0f, 5.0f, 40.0f}) {
                    CAPTURE(albedo);
                    CAPTURE(forward);
                    CAPTURE(slices);
                    CAPTURE(depth);
                    const float light = throughSlices(depth, slices, [&](float l, float tau) {
                        return glsl::lightStepConsistent(l, l, tau, albedo, 0.4f * forward,
                                                         forward);
                    });
                    const double exact = std::exp(-(1.0 - static_cast<double>(albedo * forward)) *
                                                  static_cast<double>(depth));
                    CHECK(light == Approx(exact).epsilon(2e-5));
                }
            }
        }
    }
}

TEST_CASE("Ring taps contribute only the light scattered into the outer part of the forward arc") {
    const float depth = 0.7f, inner = 0.3f, outer = 0.6f;
    const double through = std::exp(-0.7);
    CHECK(glsl::lightStepPrinted(0.0f, 1.0f, depth, inner, outer) ==
          Approx((1.0 - through) * 0.3).epsilon(1e-6));
    CHECK(glsl::lightStepPrinted(1.0f, 0.0f, depth, inner, outer) ==
          Approx(through + (1.0 - through) * 0.3).epsilon(1e-6));
    const double gain = (std::exp(-0.7 * (1.0 - 0.9 * 0.6)) - through) / 0.6;
    CHECK(glsl::lightStepConsistent(0.0f, 1.0f, depth, 0.9f, inner, outer) ==
          Approx(gain * 0.3).epsilon(1e-5));
}

TEST_CASE("The light update stays within [0, 1] for any optical depth") {
    for (float depth : {0.0f, 1e-30f, 1e-6f, 1.0f, 90.0f, 1e4f, 1e30f}) {
        for (float forward : {0.0f, 1e-30f, 0.3f, 1.0f}) {
            for (float albedo : {0.0f, 1.0f}) {
                CAPTURE(depth);
                CAPTURE(forward);
                CAPTURE(albedo);
                const glm::vec2 w =
                    glsl::lightWeightsConsistent(depth, albedo, 0.5f * forward, forward);
                CHECK(w.x >= 0.0f);
                CHECK(w.y >= 0.0f);
                CHECK(w.x + w.y <= 1.0f + 1e-6f);
            }
        }
    }
}

TEST_CASE("Skylight through thick conservative layers follows the exact spherical transmission") {
    struct Row {
        float g, depth;
        double transmission;  // adding-doubling, docs/physics.md §5
    };
    for (const Row& row : {Row{0.0f, 8.0f, 0.14153}, Row{0.0f, 64.0f, 0.02038},
                           Row{0.85f, 8.0f, 0.50752}, Row{0.85f, 64.0f, 0.12090}}) {
        const double unnormalised = 4.0 / 3.0 / 1.4209;
        CHECK(static_cast<double>(glsl::skyTransmittance(row.depth, row.g)) * unnormalised ==
              Approx(row.transmission).epsilon(2.5e-3));
    }
    CHECK(glsl::skyTransmittance(0.0f, 0.85f) == 1.0f);
}
