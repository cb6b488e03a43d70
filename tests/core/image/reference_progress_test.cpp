// reference_progress_test.cpp: what follows from the figures of the reference.
#include "core/image/reference_progress.h"

#include <doctest/doctest.h>

using namespace neph;

TEST_CASE("A quarter of the error takes sixteen times the work, and a target needs two samples") {
    ReferenceProgress progress{.samples = 4, .relativeError = 0.08, .targetError = 0.02};
    CHECK(workTo(0.02, progress) == doctest::Approx(16.0));
    CHECK_FALSE(isReached(progress));
    progress.relativeError = 0.02;
    CHECK(isReached(progress));
    progress.samples = 1;
    CHECK_FALSE(isReached(progress));
}

TEST_CASE("Two tiles are as good as the worse, and have cost what both did") {
    const ReferenceProgress a{.samples = 8,
                              .relativeError = 0.1,
                              .collisions = 5,
                              .scatterings = 2,
                              .faults = 1,
                              .seconds = 1.5};
    const ReferenceProgress b{.samples = 4,
                              .relativeError = 0.2,
                              .collisions = 7,
                              .scatterings = 3,
                              .faults = 0,
                              .seconds = 0.5};
    const ReferenceProgress both = together(a, b);
    CHECK(both.samples == 4);
    CHECK(both.relativeError == 0.2);
    CHECK(both.collisions == 12);
    CHECK(both.scatterings == 5);
    CHECK(both.faults == 1);
    CHECK(both.seconds == 2.0);
    CHECK(together({}, b).samples == 4);
}
