// phase_moments_test.cpp: moments that are known in closed form.
#include "core/transport/phase_moments.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/optics/phase_functions.h"

using namespace neph;

TEST_CASE("transport: the moments of Henyey-Greenstein are the powers of g") {
    for (const float g : {0.0f, 0.5f, 0.85f, 0.95f, -0.4f}) {
        PhaseSpec spec;
        spec.kind = PhaseKind::henyeyGreenstein;
        spec.g = g;
        const PhaseMoments moments =
            phaseMomentsOf([&](float cosTheta) { return phaseValue(spec, cosTheta).g; });
        for (std::size_t l = 0; l < moments.size(); ++l) {
            CAPTURE(g);
            CAPTURE(l);
            CHECK(moments[l] == doctest::Approx(std::pow(static_cast<double>(g), l)).epsilon(2e-4));
        }
    }
}

TEST_CASE("transport: the moments of Rayleigh scattering are 1, 0 and a tenth") {
    const PhaseMoments moments =
        phaseMomentsOf([](float cosTheta) { return 1.0f + cosTheta * cosTheta; });
    CHECK(moments[0] == doctest::Approx(1.0));
    CHECK(moments[1] == doctest::Approx(0.0));
    CHECK(moments[2] == doctest::Approx(0.1).epsilon(1e-4));
    CHECK(moments[3] == doctest::Approx(0.0));
}

TEST_CASE("transport: the first moment of every phase function is its asymmetry") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        if (spec.kind == PhaseKind::waterDroplets) continue;  // a table that may take seconds
        const PhaseMoments moments =
            phaseMomentsOf([&](float cosTheta) { return phaseValue(spec, cosTheta).g; });
        CAPTURE(static_cast<int>(spec.kind));
        CHECK(moments[1] == doctest::Approx(phaseAsymmetry(spec)).epsilon(2e-3));
    }
}
