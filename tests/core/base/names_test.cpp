// names_test.cpp: finding what a mistyped name meant.
#include "core/base/names.h"

#include <doctest/doctest.h>

#include <array>
#include <string_view>

using namespace neph;

TEST_CASE("A mistyped name finds the nearest known one") {
    constexpr std::array<std::string_view, 3> known{"render", "readers", "presets"};
    CHECK(nearestName("rendr", known) == "render");
    CHECK(nearestName("readrs", known) == "readers");
    CHECK(nearestName("preset", known) == "presets");
}

TEST_CASE("A name that is like none of the known ones finds nothing") {
    constexpr std::array<std::string_view, 2> known{"render", "presets"};
    CHECK(nearestName("wrfout_d01_2024", known).empty());
    CHECK(nearestName("", known).empty());
    CHECK(nearestName("render", {}).empty());
}

TEST_CASE("A known name is nearest to itself") {
    constexpr std::array<std::string_view, 2> known{"cloud.phase", "cloud.phase_g"};
    CHECK(nearestName("cloud.phase_g", known) == "cloud.phase_g");
    CHECK(nearestName("cloud.phase", known) == "cloud.phase");
}
