// raw_les_microhh_test.cpp: MicroHH cases: precision from file sizes, fields among other files,
// air.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("A MicroHH case can be opened by its folder, .ini or grid, in float and in double") {
    for (const bool doubles : {false, true}) {
        CAPTURE(doubles);
        const TemporaryFolder folder;
        MicrohhSpec spec;
        spec.doubles = doubles;
        const auto path = writeMicrohh(folder.path(), spec);
        for (const char* name : {"", "case.ini", "grid.0000000"}) {
            CAPTURE(name);
            const auto dataset = openFiles({*name == 0 ? path : path / name});
            const DatasetInfo& info = dataset->info();
            CHECK(info.model == "MicroHH");
            CHECK(info.scheme == "two-moment warm rain (swmicro=2mom_warm)");
            CHECK(info.cloudDropletsPerM3 == 7e7);
            CHECK(info.size == glm::ivec3(4, 3, 2));
            CHECK(info.spacingM == glm::dvec2(100.0));
            REQUIRE(info.times.size() == 2);
            CHECK(info.times[1].label == "7200 s");
            REQUIRE(info.notes.size() == 1);
            CHECK(contains(info.notes[0], "domain.sides=periodic"));
            CHECK(info.find("thl_bot") == nullptr);
            CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 50, 100});
            CHECK(dataset->read("rhoref", 0).values == std::vector<float>{1.2f, 1.1f});
            const Array3f ql = dataset->read("ql", 1, CellBox{{1, 1, 0}, {3, 3, 2}});
            CHECK(ql.at(0, 0, 0) == 0.0f);
            CHECK(ql.at(1, 1, 1) == 1e-3f);
        }
    }
}

TEST_CASE("The error for a MicroHH field opened by itself names what to open") {
    const TemporaryFolder folder;
    writeMicrohh(folder.path(), {});
    const ErrorParts error = errorOf([&] { openFiles({folder / "ql.0003600"}); });
    CHECK(contains(error.what, "one field of a MicroHH case"));
    CHECK(contains(error.hint, "open the folder"));
}

TEST_CASE("MicroHH times are in units of 10^iotimeprec seconds") {
    const TemporaryFolder folder;
    MicrohhSpec spec;
    spec.more = "[time]\niotimeprec=-1\n";
    const DatasetInfo info = openFiles({writeMicrohh(folder.path(), spec)})->info();
    CHECK(info.times[0].label == "360 s");
    CHECK(info.times[1].seconds == doctest::Approx(360.0));
}

TEST_CASE("A hydrometeor without a file at some times is drawn at the others, with a note") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    std::filesystem::remove(folder / "qr.0003600");
    const auto dataset = openFiles({path});
    REQUIRE(dataset->info().times.size() == 2);
    CHECK(dataset->read("qr", 0).values == std::vector<float>(24, 0.0f));
    CHECK(dataset->read("qr", 1).values == std::vector<float>(24, 1e-5f));
    CHECK(contains(dataset->info().notes.at(0), "qr, rain, has no file at 1 of 2 times"));
    CHECK(contains(dataset->info().notes.at(0), "3600 s"));
}

TEST_CASE("A hydrometeor that the run has and the case lacks altogether is named in a note") {
    const TemporaryFolder folder;
    MicrohhSpec spec;
    spec.rain = false;
    const auto path = writeMicrohh(folder.path(), spec);
    CHECK(contains(openFiles({path})->info().notes.at(0), "qr, rain, is not in the case"));
    writeText(folder / "case.ini",
              "[grid]\nitot=4\njtot=3\nktot=2\nxsize=400\nysize=300\nzsize=100\n"
              "[thermo]\nswthermo=moist\n[micro]\nswmicro=nsw6\n");
    const auto notes = openFiles({path})->info().notes;
    REQUIRE(notes.size() == 5);
    CHECK(contains(notes[0], "qi, cloud ice"));
    CHECK(contains(notes[1], "qr, rain"));
    CHECK(contains(notes[2], "qs, snow"));
    CHECK(contains(notes[3], "qg, graupel"));
}

TEST_CASE("A MicroHH run with an outflow is not said to have periodic sides") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    const std::string ini =
        "[grid]\nitot=4\njtot=3\nktot=2\nxsize=400\nysize=300\nzsize=100\n"
        "[thermo]\nswthermo=moist\n[micro]\nswmicro=2mom_warm\n";
    const auto saysPeriodic = [&](const std::string& text) {
        writeText(folder / "case.ini", text);
        const auto dataset = openFiles({path});
        return std::ranges::any_of(dataset->info().notes, [](const std::string& note) {
            return contains(note, "periodic sides");
        });
    };
    CHECK(saysPeriodic(ini));
    CHECK(saysPeriodic(ini + "[boundary]\nscalar_outflow=\n"));
    CHECK_FALSE(saysPeriodic(ini + "[boundary]\nscalar_outflow=qt\n"));
    CHECK_FALSE(saysPeriodic(ini + "[boundary_lateral]\nsw_openbc=true\n"));
}

TEST_CASE("The number of rain drops is converted from cubic metres to kilograms of air") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    for (const char* name : {"nr.0003600", "nr.0007200"}) {
        writeFloats(folder / name, std::vector<float>(24, 6000.0f));
    }
    const auto dataset = openFiles({path});
    const auto* number = dataset->info().find(VariableRole::numberConcentration, Species::rain);
    REQUIRE(number != nullptr);
    const auto perKg = dataset->read(number->name, 0);
    CHECK(perKg.values[0] == doctest::Approx(5000.0));  // 6000 / 1.2
    CHECK(perKg.at(3, 2, 1) == doctest::Approx(6000.0 / 1.1));
    std::filesystem::remove(folder / "nr.0007200");
    const auto info = openFiles({path})->info();
    CHECK(info.find(VariableRole::numberConcentration, Species::rain) == nullptr);
    CHECK(contains(info.notes.at(0), "nr, the number of rain drops, is not used"));
}

TEST_CASE("A time of which a MicroHH field is cut short is left out, with a note") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    writeText(folder / "qr.0007200", std::string(95, 'x'));
    const DatasetInfo writing = openFiles({path})->info();
    REQUIRE(writing.times.size() == 1);
    CHECK(contains(writing.notes.at(0), "qr.0007200 is being written"));
    std::filesystem::last_write_time(
        folder / "qr.0007200",
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    CHECK(contains(openFiles({path})->info().notes.at(0), "qr.0007200 is shorter than a field"));
}

TEST_CASE("A MicroHH case without rhoref uses the standard atmosphere, with a note") {
    const TemporaryFolder folder;
    MicrohhSpec spec;
    spec.density = false;
    const auto dataset = openFiles({writeMicrohh(folder.path(), spec)});
    CHECK(contains(dataset->info().notes.at(0), "Standard Atmosphere 1976"));
    // Table of the standard atmosphere: 1.225 kg/m³ at 0 m, 1.2133 at 100 m.
    const auto density = dataset->read("dry_air_density", 0).values;
    CHECK(density[0] == doctest::Approx(1.2221).epsilon(2e-4));
    CHECK(density[1] == doctest::Approx(1.2162).epsilon(2e-4));
}

TEST_CASE("Files that do not fit a MicroHH grid are refused with actual and expected size") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    const auto whatOf = [&] { return errorOf([&] { openFiles({path / "case.ini"}); }); };
    for (const char* name : {"ql.0003600", "ql.0007200", "qr.0003600", "qr.0007200"}) {
        writeText(folder / name, std::string(95, 'x'));
    }
    CHECK(contains(whatOf().what, "shorter than a field"));
    CHECK(whatOf().found == "95 bytes");
    CHECK(contains(whatOf().expected, "96 bytes"));
    writeMicrohh(folder.path(), {});
    writeText(folder / "grid.0000000", std::string(73, 'x'));
    CHECK(whatOf().found == "73 bytes");
    CHECK(contains(whatOf().expected, "72 bytes (float) or 144 bytes (double)"));
    writeFloats(folder / "grid.0000000", std::vector<float>(18, 7.0f));
    CHECK(contains(whatOf().what, "x coordinates differ from the .ini"));
    writeText(folder / "case.ini", "[grid]\nitot=0\njtot=3\nktot=2\n");
    CHECK(contains(whatOf().what, "grid/itot"));
}

TEST_CASE("A MicroHH grid in the other byte order is recognised by its first value") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    writeFloats(folder / "grid.0000000",
                {50, 150, 250, 350, 0, 100, 200, 300, 50, 150, 250, 0, 100, 200, 25, 75, 0, 50},
                true);
    writeFloats(folder / "ql.0003600", std::vector<float>(24, 0.5f), true);
    const auto dataset = openFiles({path});
    CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 50, 100});
    CHECK(dataset->read("ql", 0).values[5] == 0.5f);
}

TEST_CASE("Temperature and vapour of a MicroHH case follow from thl and qt where they are there") {
    const TemporaryFolder folder;
    const auto path = writeMicrohh(folder.path(), {});
    writeFloats(folder / "thermo_basestate.0000000",
                {290,  290,    0.01f, 0.01f, 291, 291, 291, 291,  291,  1e5f,  9.9e4f, 1e5f,
                 1e5f, 9.8e4f, 1,     1,     1,   1,   1,   1.2f, 1.1f, 1.25f, 1.15f,  1.05f});
    for (const char* time : {"0003600", "0007200"}) {
        writeFloats(folder / (std::string("thl.") + time), std::vector<float>(24, 290.0f));
        writeFloats(folder / (std::string("qt.") + time), std::vector<float>(24, 0.012f));
    }
    const auto dataset = openFiles({path});
    const VariableInfo* vapour = dataset->info().find(VariableRole::waterVapour);
    REQUIRE(vapour != nullptr);
    CHECK(vapour->name == "qt-ql");
    CHECK(vapour->standardName == "humidity_mixing_ratio");
    // Level 0 has no cloud, level 1 has 1 g/kg; per kg of dry air.
    const Array3f ratio = dataset->read(vapour->name, 0);
    CHECK(ratio.at(1, 1, 0) == doctest::Approx(0.012145749));
    CHECK(ratio.at(1, 1, 1) == doctest::Approx(0.011133603));
    // 290 K 0.99^(287.04 / 1005) + 2.501e6 / 1005 K of latent heat
    const VariableInfo* temperature = dataset->info().find(VariableRole::airTemperature);
    REQUIRE(temperature != nullptr);
    const Array3f kelvin = dataset->read(temperature->name, 1);
    CHECK(kelvin.at(2, 0, 0) == doctest::Approx(290.0));
    CHECK(kelvin.at(2, 0, 1) == doctest::Approx(291.657297).epsilon(1e-6));
    CHECK(dataset->info().find("tref")->role == VariableRole::other);

    std::filesystem::remove(folder / "qt.0007200");
    const DatasetInfo without = openFiles({path})->info();
    CHECK(without.find(VariableRole::waterVapour) == nullptr);
    CHECK(without.find(VariableRole::airTemperature)->name == "tref");
}
