// possible_air_test.cpp: air that cannot be is refused, and the message says where and why.
#include "core/volume/possible_air.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/base/error.h"
#include "core/volume/native_band.h"
#include "core/volume/resample.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kAirSize{4, 3, 6};

/// Air whose density follows from pressure and temperature, both impossible in one cell if given.
MemoryDataset air(std::optional<float> badPressure, std::optional<float> badTemperature = {}) {
    MemoryDataset dataset(kAirSize, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    const auto at = [](std::optional<float> bad, float good) {
        return [=](int x, int y, int z) { return bad && x == 2 && y == 1 && z == 5 ? *bad : good; };
    };
    const auto pressure = at(badPressure, 9e4f), temperature = at(badTemperature, 285.0f);
    dataset.add("air_pressure", VariableRole::airPressure, {}, kAirSize, pressure);
    dataset.add("air_temperature", VariableRole::airTemperature, {}, kAirSize, temperature);
    auto& variables = dataset.stated().variables;
    std::erase_if(variables, [](const VariableInfo& v) { return v.name == "rho"; });
    dataset.add("rho", VariableRole::dryAirDensity, {}, kAirSize, [=](int x, int y, int z) {
        return pressure(x, y, z) / (287.0f * temperature(x, y, z));
    });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-4f; });
    return dataset;
}

ErrorParts airRefusal(MemoryDataset dataset) {
    try {
        resample(dataset, 0);
    } catch (const Error& error) {
        return error.parts();
    }
    FAIL("no error");
    return {};
}

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("A density that is not air's is an error that names its cell and what is to blame") {
    const ErrorParts missing = airRefusal(air(kNoValue));
    CHECK(contains(missing.what, "rho"));
    CHECK(contains(missing.what, "2024-05-06_21:00:00"));
    CHECK(contains(missing.found, "x 2, y 1, level 5"));
    CHECK(contains(missing.found, "air_pressure is missing there"));
    CHECK(contains(missing.expected, "1e-06 to 2 kg/m3"));
    CHECK(!missing.hint.empty());
    CHECK(contains(airRefusal(air(1e20f)).found, "air_pressure is 1e+20 Pa there"));
    CHECK(contains(airRefusal(air({}, 1.0f)).found, "air_temperature is 1 K there"));
    // Just inside the limits, and just outside: 1.2 kPa and 1.3 kg/m3 per 120 kPa and 320 K.
    CHECK_NOTHROW([] {
        MemoryDataset dataset = air(119'000.0f, 399.0f);
        resample(dataset, 0);
    }());
    CHECK(contains(airRefusal(air(230'000.0f)).found, "air_pressure is 230000 Pa there"));
}

TEST_CASE(
    "A density profile that is impossible, and temperatures that size particles, are refused") {
    MemoryDataset full(kAirSize, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    full.addRatio(Species::snow, [](int, int, int) { return 1e-4f; });
    full.add("t", VariableRole::airTemperature, {}, {1, 1, 6},
             [](int, int, int z) { return z == 4 ? -40.0f : 260.0f; });
    RadiusPlan radii;
    RadiusRule& rule = radii.rules[static_cast<std::size_t>(Species::snow)];
    rule.source = RadiusSource::scheme;
    rule.scheme = Microphysics::wsm6;
    rule.temperatureVariable = "t";
    try {
        resample(full, 0, {{}, radii});
        FAIL("no error");
    } catch (const Error& error) {
        CHECK(contains(error.parts().what, "variable t "));
        CHECK(contains(error.parts().found, "-40 K in cell x 0, y 0, level 4"));
        CHECK(contains(error.parts().expected, "100 to 400 K"));
    }
}

TEST_CASE("Air that is possible with its bytes in the opposite order is said to be so") {
    MemoryDataset dataset(kAirSize, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    std::erase_if(dataset.stated().variables,
                  [](const VariableInfo& v) { return v.name == "rho"; });
    dataset.add("rho", VariableRole::dryAirDensity, {}, kAirSize,
                [](int, int, int) { return bytesSwapped(1.125f); });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 1e-4f; });
    CHECK(contains(airRefusal(dataset).hint, "byte order"));
    CHECK(bytesSwapped(bytesSwapped(1.125f)) == 1.125f);
    // 0x3F900000 and 0x0000903F.
    CHECK(bytesSwapped(1.125f) == std::bit_cast<float>(0x0000903FU));
}
