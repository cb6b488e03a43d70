// scattering_tables_test.cpp: tables that light is scattered by a thousand times must neither make
// nor lose any.
#include "app/render/engines/reference/scattering_tables.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/optics/phase_functions.h"
#include "shaders/lib/glsl_cpp.h"

using namespace neph;

namespace {

/// Integral over the sphere of a table that is linear between its entries, by Simpson's rule.
double integral(const PhaseTable& table, int wavelength) {
    constexpr int kParts = 16;
    double sum = 0.0;
    const int count = (kPhaseTableSize - 1) * kParts;
    for (int i = 0; i <= count; ++i) {
        const double index = static_cast<double>(i) / kParts;
        const auto entry = static_cast<std::size_t>(std::min(index, kPhaseTableSize - 2.0));
        const double f = index - static_cast<double>(entry);
        const double value = (1.0 - f) * static_cast<double>(table[entry][wavelength]) +
                             f * static_cast<double>(table[entry + 1][wavelength]);
        const double x = index / (kPhaseTableSize - 1), theta = M_PI * x * x;
        const double weight = i == 0 || i == count ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        // dΘ/d(index) = 2 π x / (size - 1)
        sum +=
            weight * value * 2.0 * M_PI * std::sin(theta) * 2.0 * M_PI * x / (kPhaseTableSize - 1);
    }
    return sum / (3.0 * kParts);
}

}  // namespace

TEST_CASE("Normalised tables integrate to 1 to the sixth digit, whatever the function") {
    for (std::size_t kind = 0; kind < phaseFunctions().size(); ++kind) {
        const PhaseSpec spec{.kind = static_cast<PhaseKind>(kind), .g = 0.98f};
        CAPTURE(phaseFunctions()[kind].id);
        const PhaseTable table = render::normalised(makePhaseTable(spec));
        for (int wavelength = 0; wavelength < 3; ++wavelength) {
            CHECK(integral(table, wavelength) == doctest::Approx(1.0).epsilon(2e-6));
        }
    }
}

TEST_CASE("The same share of the light lies within each interval") {
    const PhaseSpec spec{.kind = PhaseKind::henyeyGreenstein, .g = 0.85f};
    const auto versines = render::scatteringVersines(render::normalised(makePhaseTable(spec)), 1);
    REQUIRE(versines.size() == render::kScatteringIntervals + 1);
    CHECK(versines.front() == 0.0f);
    CHECK(versines.back() == 2.0f);
    for (const int i : {1, 40, 1000, 2048, 4000, 4095}) {
        const auto at = static_cast<std::size_t>(i);
        const float theta = 2.0f * std::asin(std::sqrt(0.5f * versines[at]));
        CHECK(phaseCumulative(spec, theta) ==
              doctest::Approx(i / 4096.0).epsilon(1e-3).scale(1e-2));
    }
}
