// air_columns_test.cpp: how much air there is along a ray.
#include "core/sky/air_columns.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/sky/atmosphere.h"

using namespace neph;

namespace {

double sine(double deg) {
    return std::sin(deg * std::numbers::pi / 180.0);
}

}  // namespace

TEST_CASE("Relative optical air mass is that of the published table") {
    // F. Kasten, A. T. Young, Applied Optics 28, 4735 (1989): elevation, relative air mass. Their
    // rays are refracted and ours are not: at 1 degree they pass 7 % more air.
    constexpr std::array<std::array<double, 2>, 5> kPublished{
        {{90.0, 1.0}, {60.0, 1.1540}, {20.0, 2.9032}, {5.0, 10.306}, {1.0, 26.31}}};
    const double vertical = integratedColumnsM(0.0, 1.0).x;
    for (const auto& row : kPublished) {
        const double elevation = row[0], mass = row[1];
        CAPTURE(elevation);
        const double tolerance = elevation > 10.0 ? 0.005 : elevation > 2.0 ? 0.03 : 0.08;
        CHECK(integratedColumnsM(0.0, sine(elevation)).x / vertical ==
              doctest::Approx(mass).epsilon(tolerance));
    }
}

TEST_CASE("Vertical columns are the integrals of the profiles") {
    const glm::dvec3 columns = integratedColumnsM(0.0, 1.0);
    CHECK(columns.x == doctest::Approx(8400.0).epsilon(1e-3));
    CHECK(columns.y == doctest::Approx(1200.0).epsilon(4e-3));
    CHECK(columns.z == doctest::Approx(15e3).epsilon(4e-3));
}

TEST_CASE("The table agrees with the integral, down to the horizon") {
    for (const double altitudeM : {0.0, 300.0, 1500.0, 7000.0, 20e3}) {
        for (double up = horizonUp(altitudeM) + 1e-4; up < 1.0; up += 0.021) {
            CAPTURE(altitudeM);
            CAPTURE(up);
            const glm::dvec3 exact = integratedColumnsM(altitudeM, up);
            const glm::dvec3 looked = airColumnsM(altitudeM, up);
            // Of a column that stops light at all: a hundred metres of either.
            for (int k = 0; k < 3; ++k)
                CHECK(looked[k] == doctest::Approx(exact[k]).epsilon(0.01).scale(100.0));
        }
    }
}

TEST_CASE("The horizon dips by what a sphere has") {
    CHECK(horizonUp(0.0) == 0.0);
    // acos(R / (R + h)): 3.21 degrees from 10 km, 19.8 from 400 km.
    CHECK(horizonUp(10e3) == doctest::Approx(-sine(3.2086)).epsilon(1e-3));
    CHECK(horizonUp(400e3) == doctest::Approx(-sine(19.785)).epsilon(1e-3));
}
