// reference_report_test.cpp: what is said of an image whose error falls.
#include "app/ui/widgets/reference_report.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

ui::ReferenceReport report(int paths, double error, double target, double seconds) {
    return {.paths = paths, .relativeError = error, .targetError = target, .seconds = seconds};
}

}  // namespace

TEST_CASE("Half the error takes four times the paths: three times the time there was") {
    CHECK(ui::secondsToTarget(report(16, 0.04, 0.02, 10.0)).value() == doctest::Approx(30.0));
    CHECK(ui::secondsToTarget(report(37, 0.1, 0.01, 2.0)).value() == doctest::Approx(198.0));
    CHECK_FALSE(ui::secondsToTarget(report(16, 0.02, 0.02, 10.0)));
}

TEST_CASE("One sample has no error yet: it is no reason to rest, and no time is predicted") {
    const ui::ReferenceReport first = report(1, ui::ReferenceReport{}.relativeError, 0.5, 3.0);
    CHECK_FALSE(ui::isReached(first));
    CHECK_FALSE(ui::secondsToTarget(first));
    CHECK(ui::pathsText(first) == "1 sample per pixel");
    CHECK_FALSE(ui::isReached(report(1, 0.0, 0.5, 3.0)));
    CHECK(ui::isReached(report(2, 0.0, 0.5, 3.0)));
}

TEST_CASE("The status line says how far the reference is and how long it takes") {
    CHECK(ui::pathsText(report(37, 0.081, 0.02, 7.8)) ==
          "37 samples per pixel, error 8.1 %, about 2 min to 2 %");
    CHECK(ui::pathsText(report(400, 0.0199, 0.02, 7.8)) == "400 samples per pixel, error 2 %");
}

TEST_CASE("Durations are told in the unit that suits them") {
    CHECK(ui::roughDuration(0.0) == "0 s");
    CHECK(ui::roughDuration(59.4) == "59 s");
    CHECK(ui::roughDuration(59.6) == "1 min");
    CHECK(ui::roughDuration(7200.0) == "2 h");
    CHECK(ui::roughDuration(86400.0) == "1 day");
    CHECK(ui::roughDuration(12.0 * 86400.0) == "12 days");
}
