// format_test.cpp: numbers and units on screen.
#include "app/ui/widgets/format.h"

#include <doctest/doctest.h>

#include "core/base/number_text.h"

using namespace neph;

TEST_CASE("Numbers are short and without powers of ten where people write none") {
    CHECK(numberText(0.0) == "0");
    CHECK(numberText(0.5) == "0.5");
    CHECK(numberText(10000.0) == "10000");
    CHECK(numberText(123456.0) == "123456");
    CHECK(numberText(3.14159, 3) == "3.14");
    CHECK(numberText(-0.012345) == "-0.01235");
    CHECK(numberText(9.99996) == "10");
    CHECK(numberText(2.5e-7) == "2.5e-07");
    CHECK(numberText(3e9) == "3e+09");
}

TEST_CASE("A tooltip gives range, default and the preset's value in the units of the screen") {
    const Parameter& radius = parameter("cloud.effective_radius");
    Look preset;
    CHECK(ui::factsOf(radius, preset) == "1 µm to 10000 µm · default 10 µm");
    preset.of(Species::cloud).effectiveRadiusM = 12e-6f;
    CHECK(ui::factsOf(radius, preset) == "1 µm to 10000 µm · default 10 µm · preset 12 µm");
    CHECK(ui::factsOf(parameter("cloud.density"), Look{}) ==
          "10 kg/m³ to 1000 kg/m³ · default 1000 kg/m³");
    CHECK(ui::factsOf(parameter("sun.azimuth"), Look{}) == "0° to 360° · default 225°");
    CHECK(ui::factsOf(parameter("view.engine"), Look{}) == "default March");
}
