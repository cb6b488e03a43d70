// aerosol_test.cpp: cross-sections of a model's aerosol against limits, closed forms and the values
// that WRF's radiation uses.
#include "core/optics/aerosol.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace neph;
using doctest::Approx;

namespace {

/// Mean of r^power of a lognormal distribution, in closed form.
double lognormalPower(const AerosolKind& kind, double power) {
    const double log = std::log(kind.deviation);
    return std::pow(kind.medianRadiusM, power) * std::exp(0.5 * power * power * log * log);
}

}  // namespace

TEST_CASE("Particles grow in humid air as kappa says, up to a humidity of 98 percent") {
    // By hand: 1 + 0.4 · 0.9 / 0.1 = 4.6, and 1 + 0.04 · 0.6 / 0.4 = 1.06.
    CHECK(radiusGrowth(0.9, 0.4) == Approx(1.663103).epsilon(1e-6));
    CHECK(radiusGrowth(0.6, 0.04) == Approx(1.019613).epsilon(1e-6));
    CHECK(radiusGrowth(0.0, 0.4) == 1.0);
    CHECK(radiusGrowth(0.7, 0.0) == 1.0);
    CHECK(radiusGrowth(0.98, 0.4) == Approx(std::cbrt(20.6)));
    CHECK(radiusGrowth(1.2, 0.4) == radiusGrowth(0.98, 0.4));
    CHECK(radiusGrowth(-0.1, 0.4) == 1.0);
}

TEST_CASE("Tiny particles scatter as Rayleigh says, by the sixth moment of their sizes") {
    const AerosolKind tiny{1e-9, 1.3, 0.0, 1.5};
    const double k = 2.0 * std::numbers::pi / 550e-9, polarisability = (2.25 - 1.0) / (2.25 + 2.0);
    const double expected = 8.0 / 3.0 * std::numbers::pi * std::pow(k, 4) * polarisability *
                            polarisability * lognormalPower(tiny, 6.0);
    CHECK(meanExtinctionM2(tiny, 0.5) == Approx(expected).epsilon(1e-3));
}

TEST_CASE("Large particles take out twice the light that meets them, and diffraction's edge") {
    // Q = 2 (1 + x^(-2/3)) to first order [BH83] §4.4.3; x is 343 at the median.
    const AerosolKind large{30e-6, 1.2, 0.0, {1.5, 0.1}};
    const double mean =
        meanExtinctionM2(large, 0.0) / (2.0 * std::numbers::pi * lognormalPower(large, 2.0));
    CHECK(mean > 1.0);
    CHECK(mean == Approx(1.0 + std::pow(343.0, -2.0 / 3.0)).epsilon(5e-3));
}

TEST_CASE("A grown particle is a larger one of its volumes of water and dry matter") {
    const AerosolKind kind{0.1e-6, 1.6, 0.5, {1.6, 0.02}};
    // At 0.8 the volume is 1 + 0.5 · 4 = 3 dry ones: index 1.333 + (0.267 + 0.02 i) / 3.
    const AerosolKind grown{0.1e-6 * std::cbrt(3.0), 1.6, 0.0, {1.422, 0.02 / 3.0}};
    CHECK(meanExtinctionM2(kind, 0.8) == Approx(meanExtinctionM2(grown, 0.0)).epsilon(1e-9));
}

TEST_CASE("Cross-sections are those of WRF's radiation: dry aerosol, and dust in any air") {
    // [WRF] gt_aod, m² per particle at 550 nm; its first row is for air of at most 10 %.
    CHECK(meanExtinctionM2(kHygroscopicAerosol, 0.0) == Approx(5.73936e-15).epsilon(0.02));
    struct Row {
        double humidity, dustM2;
    };
    constexpr std::array kRows{Row{0.0, 2.63577e-12}, Row{0.6, 2.72095e-12}, Row{0.8, 2.87263e-12},
                               Row{0.9, 3.15081e-12}, Row{0.95, 3.66798e-12}};
    for (const Row& row : kRows) {
        CAPTURE(row.humidity);
        CHECK(meanExtinctionM2(kDustAerosol, row.humidity) == Approx(row.dustM2).epsilon(0.02));
    }
}

TEST_CASE("The table has the cross-sections between its entries") {
    for (const AerosolKind& kind : {kHygroscopicAerosol, kDustAerosol}) {
        const ExtinctionByHumidity table(kind);
        for (double humidity : {0.0, 0.137, 0.5, 0.777, 0.913, 0.9751, 0.98, 1.3, -0.2}) {
            CAPTURE(humidity);
            CHECK(table.atM2(humidity) == Approx(meanExtinctionM2(kind, humidity)).epsilon(1e-3));
        }
    }
}
