// reference_text_test.cpp: what is said of an image whose error falls.
#include "app/ui/widgets/reference_text.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

ReferenceProgress after(int samples, double error, double target, double seconds) {
    return {.samples = samples, .relativeError = error, .targetError = target, .seconds = seconds};
}

}  // namespace

TEST_CASE("Half the error takes four times the samples: three times the time there was") {
    CHECK(ui::secondsToTarget(after(16, 0.04, 0.02, 10.0)).value() == doctest::Approx(30.0));
    CHECK(ui::secondsToTarget(after(37, 0.1, 0.01, 2.0)).value() == doctest::Approx(198.0));
    CHECK_FALSE(ui::secondsToTarget(after(16, 0.02, 0.02, 10.0)));
}

TEST_CASE("One sample has no known error: it is no reason to stop, and no time is estimated") {
    const ReferenceProgress first = after(1, ReferenceProgress{}.relativeError, 0.5, 3.0);
    CHECK_FALSE(isReached(first));
    CHECK_FALSE(ui::secondsToTarget(first));
    CHECK(ui::referenceText(first) == "1 sample per pixel");
    CHECK_FALSE(isReached(after(1, 0.0, 0.5, 3.0)));
    CHECK(isReached(after(2, 0.0, 0.5, 3.0)));
}

TEST_CASE("The status line says how far the reference is and how long it takes") {
    CHECK(ui::referenceText(after(37, 0.081, 0.02, 7.8)) ==
          "37 samples per pixel, error 8.1 %, about 2 min to 2 %");
    CHECK(ui::referenceText(after(400, 0.0199, 0.02, 7.8)) == "400 samples per pixel, error 2 %");
}

TEST_CASE("A preview says that it is one, and of how many samples") {
    CHECK(ui::previewText(16) == "Denoised preview of 16 samples per pixel");
}

TEST_CASE("Durations are in the unit that suits them") {
    CHECK(ui::roughDuration(0.0) == "0 s");
    CHECK(ui::roughDuration(59.4) == "59 s");
    CHECK(ui::roughDuration(59.6) == "1 min");
    CHECK(ui::roughDuration(7200.0) == "2 h");
    CHECK(ui::roughDuration(86400.0) == "1 day");
    CHECK(ui::roughDuration(12.0 * 86400.0) == "12 days");
}
