// grib_values_test.cpp: values of GRIB2 files against those that ecCodes reads from the same
// messages, in every packing and scanning mode, and against what was written.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "tests/readers/grib_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// Condensate with clear air beside it, in which no two neighbours are alike.
double gribCloud(int x, int y, int z, int t) {
    const double wave = std::sin(0.3 * x) * std::sin(0.2 * y) + 0.1 * z + 0.05 * t;
    return wave > 0.0 ? 1e-3 * wave + 1e-6 * ((7 * x + 13 * y) % 11) : 0.0;
}

/// Message number `index` as ecCodes reads it, x fastest from the south-west corner, by the
/// positions that ecCodes gives.
std::vector<double> byCodes(const std::filesystem::path& path, std::size_t index,
                            const GribSpec& spec) {
    const GribPoints points = gribPoints(path, index);
    std::vector<double> values(points.value.size());
    std::size_t i = 0;
    for (const auto& cell : gribOrder(spec)) {
        values[static_cast<std::size_t>(cell[1] * spec.nx + cell[0])] = points.value[i++];
    }
    return values;
}

/// Whether a field is what ecCodes reads, missing values (9999 there) included.
bool isAsByCodes(const Array3f& field, int z, const std::vector<double>& expected) {
    const std::size_t layer = field.index(0, 0, 1);
    for (std::size_t i = 0; i < layer; ++i) {
        const float value = field.values[static_cast<std::size_t>(z) * layer + i];
        const bool missing = expected[i] == 9999.0;
        if (missing != std::isnan(value)) return false;
        if (!missing && value != static_cast<float>(expected[i])) return false;
    }
    return layer == expected.size();
}

/// With only these two fields beside the air, CLMR is message 1 of every level of 4.
GribSpec cloudSpec() {
    GribSpec spec;
    spec.nx = 41;
    spec.ny = 37;
    spec.nz = 2;
    spec.omit = {"SPFH", "CIMIXR", "RWMR", "SNMR", "GRLE"};
    spec.fields["CLMR"] = gribCloud;
    return spec;
}

void checkCloud(const std::filesystem::path& path, const GribSpec& spec) {
    writeGrib(path, spec);
    const auto dataset = openFiles({path});
    REQUIRE(dataset->info().size == glm::ivec3(spec.nx, spec.ny, spec.nz));
    const Array3f cloud = dataset->read("CLMR", 0);
    CHECK(isAsByCodes(cloud, 0, byCodes(path, 0, spec)));
    CHECK(isAsByCodes(cloud, 1, byCodes(path, 4, spec)));
    for (int y = 0; y < spec.ny; ++y) {
        for (int x = 0; x < spec.nx; ++x) {
            if (spec.missing && spec.missing("CLMR", x, y, 1)) continue;
            const double off = static_cast<double>(cloud.at(x, y, 1)) - gribCloud(x, y, 1, 0);
            REQUIRE(std::abs(off) < 2e-8);  // half a step of 16 bits over 1.2e-3
        }
    }
}

}  // namespace

TEST_CASE("GRIB2 values are those of ecCodes in every packing") {
    const TemporaryFolder folder;
    for (const char* packing :
         {"grid_simple", "grid_ccsds", "grid_png", "grid_jpeg", "grid_ieee"}) {
        CAPTURE(packing);
        GribSpec spec = cloudSpec();
        spec.packing = packing;
        checkCloud(folder / packing, spec);
    }
}

TEST_CASE("GRIB2 values are those of ecCodes in complex packing of every order") {
    const TemporaryFolder folder;
    for (const int order : {0, 1, 2}) {
        for (const int marked : {0, 1, 2}) {
            CAPTURE(order);
            CAPTURE(marked);
            GribSpec spec = cloudSpec();
            spec.packing = "complex";
            spec.order = order;
            spec.marked = marked;
            if (marked > 0) {
                spec.missing = [](const std::string& name, int x, int y, int) {
                    return name == "CLMR" && ((7 * x + 5 * y) % 9 == 0 || y == 11);
                };
            }
            checkCloud(folder / "a", spec);
        }
    }
}

TEST_CASE("GRIB2 bitmaps leave gaps, whatever the packing") {
    const TemporaryFolder folder;
    for (const char* packing : {"grid_simple", "grid_jpeg", "complex"}) {
        CAPTURE(packing);
        GribSpec spec = cloudSpec();
        spec.packing = packing;
        spec.northward = false;
        spec.missing = [](const std::string& name, int x, int y, int z) {
            return name == "CLMR" && ((x + 3 * y + z) % 7 == 0 || y == 20);
        };
        checkCloud(folder / packing, spec);
    }
}

TEST_CASE("GRIB2 scanning modes are turned so that x runs east and y north") {
    const TemporaryFolder folder;
    for (int mode = 0; mode < 16; ++mode) {
        for (const char* packing : {"grid_simple", "complex", "grid_ccsds"}) {
            CAPTURE(mode);
            CAPTURE(packing);
            GribSpec spec = cloudSpec();
            spec.packing = packing;
            spec.westward = (mode & 8) != 0;
            spec.northward = (mode & 4) != 0;
            spec.alongY = (mode & 2) != 0;
            spec.alternating = (mode & 1) != 0;
            checkCloud(folder / "a", spec);
        }
    }
}

TEST_CASE("A box of a GRIB2 field equals that part of the whole, in whatever order it is read") {
    const TemporaryFolder folder;
    for (const bool northward : {true, false}) {
        CAPTURE(northward);
        GribSpec spec = cloudSpec();
        spec.packing = "complex";
        spec.northward = northward;
        writeGrib(folder / "a", spec);
        const Array3f whole = openFiles({folder / "a"})->read("CLMR", 0);
        const auto dataset = openFiles({folder / "a"});
        for (const CellBox& box : {CellBox{{5, 30, 0}, {20, 33, 2}}, CellBox{{0, 3, 1}, {41, 5, 2}},
                                   CellBox{{40, 36, 0}, {41, 37, 1}},
                                   CellBox{{0, 0, 0}, {3, 19, 2}}, CellBox{{7, 4, 1}, {9, 5, 2}}}) {
            const Array3f part = dataset->read("CLMR", 0, box);
            for (int z = 0; z < part.size.z; ++z) {
                for (int y = 0; y < part.size.y; ++y) {
                    for (int x = 0; x < part.size.x; ++x) {
                        REQUIRE(part.at(x, y, z) ==
                                whole.at(box.lower.x + x, box.lower.y + y, box.lower.z + z));
                    }
                }
            }
        }
    }
}

TEST_CASE("Several fields in one GRIB2 message are read apart, with the bitmap of the one before") {
    const TemporaryFolder folder;
    GribSpec spec = cloudSpec();
    spec.severalFields = true;
    spec.missing = [](const std::string& name, int x, int, int) {
        return (name == "CLMR" || name == "CIMIXR") && x % 5 == 0;
    };
    spec.omit.erase("CIMIXR");
    spec.fields["CIMIXR"] = [](int x, int y, int, int) { return 1e-5 * (x + y); };
    auto messages = gribMessages(spec);
    CHECK(messages.size() == 2);  // one for each level
    // The second field, CLMR, has the same gaps: it may refer to the bitmap of the first.
    for (GribMessage& message : messages) referToBitmap(message, 1);
    writeMessages(folder / "a", messages);
    const auto dataset = openFiles({folder / "a"});
    const Array3f cloud = dataset->read("CLMR", 0), ice = dataset->read("CIMIXR", 0);
    CHECK(std::isnan(cloud.at(10, 3, 1)));
    CHECK(static_cast<double>(cloud.at(11, 3, 1)) ==
          doctest::Approx(gribCloud(11, 3, 1, 0)).epsilon(1e-4));
    CHECK(static_cast<double>(ice.at(11, 3, 1)) == doctest::Approx(1.4e-4).epsilon(1e-3));
}

TEST_CASE("Density, pressure and temperature from GRIB2 are those of docs/physics.md section 7") {
    const TemporaryFolder folder;
    GribSpec spec;
    // The first test value there: p 5e4 Pa, theta 320 K, q_v 0.002.
    const double temperature = 320.0 * std::pow(0.5, 2.0 / 7.0);
    spec.fields["TMP"] = [=](int, int, int, int) { return temperature; };
    spec.fields["SPFH"] = [](int, int, int, int) { return 0.002 / 1.002; };
    spec.ground["HGT"] = [](int x, int, int, int) { return x == 2 ? 20.0 : 10.0; };
    writeGrib(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const double density = 5e4 / (287.0 * temperature * (1.0 + 461.6 / 287.0 * 0.002));
    CHECK(static_cast<double>(dataset->read("air_temperature", 0).at(1, 1, 1)) ==
          doctest::Approx(temperature).epsilon(1e-6));
    CHECK(static_cast<double>(dataset->read("dry_air_density", 0).at(1, 1, 1)) ==
          doctest::Approx(density).epsilon(1e-6));
    CHECK(dataset->read("air_pressure", 0).at(1, 1, 1) == 5e4f);
    // Centres at 50, 150 and 250 m; the ground at 10 and 20 m.
    const Array3f heights = dataset->read("interface_height", 0);
    REQUIRE(heights.size.z == 4);
    const std::array<float, 4> expected{10.0f, 100.0f, 200.0f, 300.0f};
    for (int k = 0; k < 4; ++k) {
        CHECK(heights.at(0, 0, k) == expected[static_cast<std::size_t>(k)]);
    }
    CHECK(heights.at(2, 0, 0) == 20.0f);
    CHECK(hasNote(dataset->info(), "the lowest as HGT of the ground"));
}
