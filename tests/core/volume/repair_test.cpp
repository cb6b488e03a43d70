// repair_test.cpp: a few wrong values are clipped and counted; a field of them is refused, with the
// likely cause.
#include "core/volume/repair.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "core/volume/resample.h"
#include "core/volume/statistics.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kFieldSize{20, 20, 10};
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
using Field = std::function<float(int, int, int)>;

/// Log-normal cloud in the middle of the domain, zero elsewhere, as float32 holds it.
float logNormal(int x, int y, int z) {
    if (z < 2 || z > 7 || x < 3 || y < 3) return 0.0f;
    std::mt19937 random(static_cast<unsigned>(x + 20 * y + 400 * z));
    std::normal_distribution<double> logarithm(-8.0, 1.5);
    return std::min(static_cast<float>(std::exp(logarithm(random))), 0.02f);
}

MemoryDataset cloudOf(const Field& field) {
    MemoryDataset dataset(kFieldSize,
                          [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::cloud, field);
    return dataset;
}

/// What resampling and the summary say; both must say the same.
ErrorParts fieldRefusal(const Field& field) {
    MemoryDataset dataset = cloudOf(field);
    ErrorParts drawn;
    try {
        resample(dataset, 0);
        FAIL("no error");
    } catch (const Error& error) {
        drawn = error.parts();
    }
    try {
        summarise(dataset, 0);
        FAIL("no error");
    } catch (const Error& error) {
        CHECK(error.parts().hint == drawn.hint);
        CHECK(error.parts().found == drawn.found);
    }
    return drawn;
}

std::vector<std::string> repairNotes(const Field& field) {
    MemoryDataset dataset = cloudOf(field);
    return resample(dataset, 0).notes;
}

/// The bits of a float shifted by a byte, as behind a record mark of another size.
float inOtherOrder(float value) {
    std::array<unsigned char, 4> bytes{};
    std::memcpy(bytes.data(), &value, 4);
    std::swap(bytes[0], bytes[3]);
    std::swap(bytes[1], bytes[2]);
    std::memcpy(&value, bytes.data(), 4);
    return value;
}

}  // namespace

TEST_CASE("A field read in the wrong byte order is refused, and the message says so") {
    const ErrorParts error =
        fieldRefusal([](int x, int y, int z) { return inOtherOrder(logNormal(x, y, z)); });
    CHECK(contains(error.what, "Q_cloud"));
    CHECK(contains(error.what, "2024-05-06_21:00:00"));
    CHECK(contains(error.found, "values with condensate are impossible"));
    CHECK(contains(error.expected, "0 to 0.1 kg/kg"));
    CHECK(contains(error.hint, "byte order"));
}

TEST_CASE("So is one of rounded values, whose inOtherOrder bytes are next to zero") {
    const ErrorParts error = fieldRefusal([](int x, int y, int z) {
        const auto bits = std::bit_cast<std::uint32_t>(logNormal(x, y, z));
        return inOtherOrder(std::bit_cast<float>(bits & 0xFFFFFE00U));  // 14 bits of mantissa
    });
    CHECK(contains(error.hint, "byte order"));
}

TEST_CASE("Grams per kilogram that are read as kilograms are refused as such") {
    const ErrorParts error =
        fieldRefusal([](int x, int y, int z) { return 1000.0f * logNormal(x, y, z); });
    CHECK(contains(error.hint, "g/kg"));
    CHECK(!contains(error.hint, "byte order"));
}

TEST_CASE("A cloud of one value in the wrong order or unit is refused, not taken for missing") {
    const auto box = [](int x, int, int z, float value) { return x > 5 && z > 3 ? value : 0.0f; };
    CHECK(contains(
        fieldRefusal([=](int x, int y, int z) { return box(x, y, z, inOtherOrder(1e-3f)); }).hint,
        "byte order"));
    CHECK(contains(fieldRefusal([=](int x, int y, int z) { return box(x, y, z, 1.0f); }).hint,
                   "g/kg"));
}

TEST_CASE("Numbers of another kind are refused as not being where they are looked for") {
    // The two halves of the field's doubles, as float32.
    const ErrorParts error = fieldRefusal([](int x, int y, int z) {
        const auto whole =
            std::bit_cast<std::uint64_t>(static_cast<double>(logNormal(x / 2, y, z)) * 1.000000123);
        return std::bit_cast<float>(static_cast<std::uint32_t>(x % 2 == 0 ? whole : whole >> 32U));
    });
    CHECK(contains(error.hint, "record marks"));
    CHECK(contains(error.hint, "word size"));
}

TEST_CASE("Up to one in a hundred impossible values are taken as zero and counted") {
    // Of 17 x 17 x 6 = 1734 cloudy cells, some run away.
    int runaway = 0;
    const auto field = [&](int x, int y, int z) {
        const bool bad = z == 4 && y == 10 && x >= 20 - runaway;
        return bad ? 3.0f + static_cast<float>(x) : std::max(logNormal(x, y, z), 2e-6f);
    };
    runaway = 12;
    const std::vector<std::string> notes = repairNotes(field);
    REQUIRE(notes.size() == 1);
    CHECK(contains(notes[0], "Q_cloud: 12 impossible values (beyond 0.1 kg/kg) taken as zero"));
    CHECK(notes[0].starts_with("2024-05-06_21:00:00: "));
}

TEST_CASE("One value that stands wherever nothing is known is a mark, and is named") {
    for (const float mark : {-9999.0f, 1e20f}) {
        const std::vector<std::string> notes = repairNotes(
            [=](int x, int y, int z) { return z == 0 && x < 10 ? mark : logNormal(x, y, z); });
        REQUIRE(notes.size() == 1);
        CHECK(contains(notes[0], "200 impossible values"));
        CHECK(contains(notes[0], mark < 0.0f ? "-9999 kg/kg" : "1e+20 kg/kg"));
        CHECK(contains(notes[0], "mark for missing values"));
    }
}

TEST_CASE("A field without a value is noted beside others, and an error if it is all there is") {
    const auto nothing = [](int, int, int) { return kMissing; };
    CHECK(contains(fieldRefusal(nothing).what, "no hydrometeor has a value"));
    MemoryDataset dataset = cloudOf(logNormal);
    dataset.addRatio(Species::ice, nothing);
    const SpeciesVolume volume = resample(dataset, 0);
    REQUIRE(!volume.notes.empty());
    CHECK(contains(volume.notes[0], "Q_ice: all 4000 values are missing"));
}

TEST_CASE("Noise of models is no reason to refuse") {
    // Underflow, a constant background and undershoots, without a cloud.
    std::mt19937 random(4);
    std::uniform_real_distribution<float> exponent(-44.0f, -9.0f);
    const std::vector<std::string> notes = repairNotes([&](int x, int, int z) {
        const float noise = std::pow(10.0f, exponent(random));
        return z == 0 ? 2e-16f : x == 0 ? -noise : noise;
    });
    REQUIRE(notes.size() == 1);
    CHECK(contains(notes[0], "negative values clipped"));
}
