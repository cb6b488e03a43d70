// mie_test.cpp: single spheres against published and independently computed values (docs/physics.md
// §6).
#include "core/optics/mie.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace neph;
using doctest::Approx;

namespace {

struct Row {
    std::complex<double> index;
    double x, extinction, scattering, asymmetry, back;
};

/// Absorbing rows are tests 9-11 of [Wiscombe80]'s MIEV0; the last is the example of [BH83]
/// appendix A.
const Row kRows[] = {
    {1.33, 1.0, 0.093924, 0.093924, 0.184517, 0.084625},
    {1.33, 10.0, 2.206549, 2.206549, 0.712459, 0.561179},
    {1.33, 100.0, 2.101090, 2.101090, 0.868315, 2.240901},
    {1.33, 1000.0, 2.016578, 2.016578, 0.883093, 0.676135},
    {{1.33, 1e-5}, 1.0, 0.093952, 0.093923, 0.184517, 0.084624},
    {{1.33, 1e-5}, 100.0, 2.101321, 2.096594, 0.868959, 2.146326},
    {{1.33, 1e-5}, 10000.0, 2.004089, 1.723857, 0.907840, 0.037572},
    {1.55, 5.212820, 3.105426, 3.105426, 0.633137, 2.925341},
};

}  // namespace

TEST_CASE("Mie efficiencies of single spheres are the published ones") {
    for (const Row& row : kRows) {
        CAPTURE(row.x);
        CAPTURE(row.index.imag());
        const MieEfficiencies q = mieEfficiencies(row.x, mieCoefficients(row.x, row.index));
        CHECK(q.extinction == Approx(row.extinction).epsilon(6e-6));
        CHECK(q.scattering == Approx(row.scattering).epsilon(6e-6));
        CHECK(q.asymmetry == Approx(row.asymmetry).epsilon(4e-6));
        CHECK(q.back == Approx(row.back).epsilon(2e-5));
    }
}

TEST_CASE("A sphere without absorption scatters all that it takes out of the beam") {
    for (double x : {0.1, 3.0, 57.0, 700.0}) {
        const MieEfficiencies q = mieEfficiencies(x, mieCoefficients(x, 1.333));
        CHECK(q.scattering == Approx(q.extinction).epsilon(1e-9));
    }
}

TEST_CASE("A tiny sphere scatters as Rayleigh says") {
    const double x = 0.01;
    const MieEfficiencies q = mieEfficiencies(x, mieCoefficients(x, 1.333));
    const double polarisability = (1.333 * 1.333 - 1.0) / (1.333 * 1.333 + 2.0);
    CHECK(q.scattering ==
          Approx(8.0 / 3.0 * x * x * x * x * polarisability * polarisability).epsilon(1e-3));
    CHECK(q.asymmetry == Approx(0.0).epsilon(1e-4));
}
