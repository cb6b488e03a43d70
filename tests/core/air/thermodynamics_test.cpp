// thermodynamics_test.cpp: moist air against integrals of its equations, and MetPy.
#include "core/air/thermodynamics.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/sky/humidity.h"

using namespace neph;

TEST_CASE("Dew point is the inverse of the pressure of saturated vapour") {
    for (const double dewPoint : {233.0, 273.15, 280.0, 303.0}) {
        const double vapour = saturationPressurePa(dewPoint);
        const double ratio = 0.622 * vapour / (9e4 - vapour);
        CHECK(dewPointK(9e4, ratio) == doctest::Approx(dewPoint).epsilon(1e-9));
        CHECK(saturationRatio(9e4, dewPoint) == doctest::Approx(ratio).epsilon(1e-9));
    }
    CHECK(dewPointK(9e4, 0.0) == 0.0);
}

TEST_CASE("Equivalent potential temperature is that of MetPy's test") {
    // 1000 hPa, 293 K, dew point 280 K: 311.19 K.
    const double vapour = saturationPressurePa(280.0);
    const double ratio = 0.622 * vapour / (1e5 - vapour);
    CHECK(equivalentPotentialTemperatureK(1e5, 293.0, ratio) ==
          doctest::Approx(311.186).epsilon(2e-4));
    CHECK(equivalentPotentialTemperatureK(8e4, 290.0, 0.0) ==
          doctest::Approx(potentialTemperatureK(8e4, 290.0)));
}

TEST_CASE("The pseudoadiabat from 293 K at 1000 hPa is where entropy is kept") {
    // Integrated in Python from the conservation of entropy with latent heat and vapour of
    // [Bolton80], in 4000 steps. MetPy, whose latent heat is constant, has 284.64 to 252.91 K.
    const std::array<double, 5> pressuresPa{8e4, 6e4, 5e4, 4e4, 3e4};
    const std::array<double, 5> temperaturesK{284.512, 272.590, 264.194, 252.753, 236.139};
    for (std::size_t i = 0; i < pressuresPa.size(); ++i) {
        CAPTURE(pressuresPa[i]);
        CHECK(std::abs(pseudoadiabatK(1e5, 293.0, pressuresPa[i]) - temperaturesK[i]) < 0.01);
    }
}

TEST_CASE("The pseudoadiabat reaches the stratosphere and back") {
    const double top = pseudoadiabatK(9e4, 300.0, 1e4);
    CHECK(top > 180.0);
    CHECK(top < 230.0);
    CHECK(pseudoadiabatK(1e4, top, 9e4) == doctest::Approx(300.0).epsilon(1e-4));
}

TEST_CASE("Equivalent potential temperature is kept on the pseudoadiabat") {
    const double start = equivalentPotentialTemperatureK(9e4, 290.0, saturationRatio(9e4, 290.0));
    for (const double pressure : {7e4, 5e4, 3e4}) {
        const double temperature = pseudoadiabatK(9e4, 290.0, pressure);
        CHECK(equivalentPotentialTemperatureK(pressure, temperature,
                                              saturationRatio(pressure, temperature)) ==
              doctest::Approx(start).epsilon(1e-5));
    }
}

TEST_CASE("Air condenses where the lifted air is saturated") {
    const double pressure = condensationPressurePa(1e5, 300.0, 0.012);
    const double temperature = condensationTemperatureK(1e5, 300.0, 0.012);
    CHECK(saturationRatio(pressure, temperature) == doctest::Approx(0.012).epsilon(0.01));
    // Saturated air condenses where it is.
    CHECK(condensationPressurePa(9e4, 285.0, saturationRatio(9e4, 285.0) * 1.1) ==
          doctest::Approx(9e4));
}

TEST_CASE("Virtual temperature") {
    CHECK(virtualTemperatureK(300.0, 0.0) == 300.0);
    CHECK(virtualTemperatureK(300.0, 0.01) == doctest::Approx(301.805).epsilon(1e-5));
}
