// format_test.cpp: numbers and units on screen.
#include "app/ui/format.h"

#include <doctest/doctest.h>

#include "tests/text.h"

using namespace neph;

TEST_CASE("Numbers carry their unit as a reader writes it") {
    CHECK(ui::sliderFormat(parameter("cloud.effective_radius")) == "%.4g µm");
    CHECK(ui::sliderFormat(parameter("cloud.density")) == "%.4g kg/m³");
    CHECK(ui::sliderFormat(parameter("sun.azimuth")) == "%.4g°");
    CHECK(ui::sliderFormat(parameter("cloud.mixing_scale")) == "%.4g");
    CHECK(ui::sliderFormat(parameter("view.planes")) == "%d");
}

TEST_CASE("A tooltip gives meaning, range and default in the units of the screen, and the id") {
    const std::string tip = ui::tooltipOf(parameter("cloud.effective_radius"));
    CHECK(contains(tip, parameter("cloud.effective_radius").help));
    CHECK(contains(tip, "1 µm to 1e+04 µm"));
    CHECK(contains(tip, "Default 10 µm"));
    CHECK(contains(tip, "cloud.effective_radius"));
    for (const Parameter& row : lookTable()) CHECK(contains(ui::tooltipOf(row), "Default "));
}
