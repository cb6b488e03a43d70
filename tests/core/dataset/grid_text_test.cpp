// grid_text_test.cpp: lengths and steps as people write them.
#include "core/dataset/grid_text.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

DatasetInfo withTimes(const std::vector<double>& seconds) {
    DatasetInfo info;
    for (const double s : seconds) info.times.push_back({"t", s, {}, 0});
    return info;
}

}  // namespace

TEST_CASE("Lengths have three digits, in metres below a kilometre") {
    CHECK(lengthText(66.0 + 2.0 / 3.0) == "66.7 m");
    CHECK(lengthText(125.0) == "125 m");
    CHECK(lengthText(999.4) == "999 m");
    CHECK(lengthText(999.9) == "1 km");
    CHECK(lengthText(1000.0) == "1 km");
    CHECK(lengthText(1250.0) == "1.25 km");
    CHECK(lengthText(12'000.0) == "12 km");
    CHECK(lengthText(0.5) == "0.5 m");
}

TEST_CASE("Cells are as wide as they are along x and y, and from the narrowest to the widest") {
    DatasetInfo info;
    info.size = {3, 2, 1};
    info.spacingM = {100.0, 100.0};
    CHECK(cellWidthText(info) == "100 m");
    info.spacingM.y = 2000.0;
    CHECK(cellWidthText(info) == "100 m x 2 km");
    info.edgesM = {{{0.0, 5000.0, 6000.0, 8000.0}, {0.0, 400.0, 2400.0}}};
    CHECK(cellWidthText(info) == "1 to 5 km x 400 m to 2 km");
    info.edgesM[1] = {0.0, 1000.0, 6000.0};
    CHECK(cellWidthText(info) == "1 to 5 km");
}

TEST_CASE("Equal steps are said once, and unequal ones from the shortest to the longest") {
    CHECK(timeStepText(withTimes({0.0})).empty());
    CHECK(timeStepText(withTimes({0.0, 600.0, 1200.0})) == "every 10 min");
    CHECK(timeStepText(withTimes({0.0, 20.0, 40.0})) == "every 20 s");
    CHECK(timeStepText(withTimes({0.0, 600.001, 1200.0})) == "every 10 min");
    CHECK(timeStepText(withTimes({0.0, 600.0, 1800.0})) == "10 to 20 min apart");
    CHECK(timeStepText(withTimes({0.0, 30.0, 1830.0})) == "30 s to 30 min apart");
}
