// humidity_test.cpp: saturation against tables, humidity and visibility against values computed
// apart.
#include "core/sky/humidity.h"

#include <doctest/doctest.h>

#include <array>

using namespace neph;

TEST_CASE("Vapour is saturated over water at the pressures of Goff and Gratch") {
    // Their formula of 1946, as the Smithsonian Meteorological Tables have it: °C, hPa.
    struct Row {
        double celsius, hPa;
    };
    constexpr std::array kRows{Row{-30.0, 0.5088}, Row{-20.0, 1.2540}, Row{-10.0, 2.8627},
                               Row{0.0, 6.1078},   Row{10.0, 12.272},  Row{20.0, 23.373},
                               Row{30.0, 42.430}};
    for (const Row& row : kRows) {
        CAPTURE(row.celsius);
        CHECK(saturationPressurePa(row.celsius + 273.15) ==
              doctest::Approx(100.0 * row.hPa).epsilon(0.0033));
    }
}

TEST_CASE("Air of known pressure, temperature and vapour has a known humidity") {
    // By hand: e = p q / (0.622 + q), over 611.2 exp(17.67 t / (t + 243.5)) Pa.
    CHECK(relativeHumidity(1e5, 298.15, 0.0) == 0.0);
    CHECK(relativeHumidity(1e5, 298.15, 0.014) == doctest::Approx(0.694967).epsilon(1e-4));
    CHECK(relativeHumidity(9.5e4, 288.15, 0.014) > 1.0);
    CHECK(relativeHumidity(1e5, 298.15, -1e-4) == 0.0);  // as advection leaves it
}

TEST_CASE("The density of dry air is that of docs/physics.md section 7") {
    CHECK(dryDensityKgPerM3(5e4, 262.5073, 0.002) == doctest::Approx(0.661534).epsilon(1e-4));
    CHECK(dryDensityKgPerM3(9e4, 291.1037, 0.015) == doctest::Approx(1.051864).epsilon(1e-4));
}

TEST_CASE("Haze follows humidity as NCEP's post-processor has it, at a contrast of 2 percent") {
    // 90 km e^(-2.5 (h - 0.15)) at a contrast of 5 %; ln 0.02 / ln 0.05 = 1.305865.
    CHECK(visibilityOfHumidityM(0.5) == doctest::Approx(48993.0).epsilon(1e-4));
    CHECK(visibilityOfHumidityM(0.7) == doctest::Approx(29716.0).epsilon(1e-4));
    CHECK(visibilityOfHumidityM(0.95) == doctest::Approx(15906.0).epsilon(1e-4));
    CHECK(visibilityOfHumidityM(1.0) == doctest::Approx(visibilityOfHumidityM(0.95)));
    CHECK(visibilityOfHumidityM(0.0) == doctest::Approx(117528.0).epsilon(1e-4));
    CHECK(visibilityOfHumidityM(0.0) == visibilityOfHumidityM(0.15));
}
