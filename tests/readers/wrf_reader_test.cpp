// wrf_reader_test.cpp: what the WRF reader returns for valid files.
#include <doctest/doctest.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

#include "core/volume/lowest_air.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// Bytes that this process has read so far; nothing if the system does not count them.
std::optional<std::uint64_t> bytesRead() {
    std::ifstream io("/proc/self/io");
    std::string key;
    std::uint64_t value = 0;
    if (io >> key >> value && key == "rchar:") return value;
    return {};
}

}  // namespace

TEST_CASE("NetCDF-3 classic, 64-bit offset and NetCDF-4 files read the same") {
    const TemporaryFolder folder;
    for (const NetcdfFormat format :
         {NetcdfFormat::classic, NetcdfFormat::offset64, NetcdfFormat::netcdf4}) {
        CAPTURE(static_cast<int>(format));
        WrfSpec spec;
        spec.format = format;
        spec.mpPhysics = 8;
        spec.times = {"2024-05-06_21:00:00", "2024-05-06_21:15:00"};
        spec.fields["QCLOUD"] = marked;
        const auto path = folder / "wrfout_d01_2024-05-06_21:00:00";
        writeWrf(path, spec);
        const auto dataset = openFiles({path});
        const DatasetInfo& info = dataset->info();
        CHECK(info.reader == "wrf_netcdf");
        CHECK(info.model == "WRF V4.2.2");
        CHECK(info.scheme == "Thompson (MP_PHYSICS 8)");
        CHECK(info.size == glm::ivec3(4, 3, 5));
        CHECK(info.spacingM == glm::dvec2(1000.0, 2000.0));
        REQUIRE(info.times.size() == 2);
        CHECK(info.times[1].label == "2024-05-06_21:15:00");
        CHECK(info.times[1].seconds == 900.0);
        const Array3f cloud = dataset->read("QCLOUD", 1);
        REQUIRE(cloud.size == glm::ivec3(4, 3, 5));
        CHECK(cloud.at(3, 2, 4) == marked(3, 2, 4, 1));
        CHECK(cloud.at(1, 0, 2) == marked(1, 0, 2, 1));
        CHECK(dataset->read("QCLOUD", 0).at(3, 2, 4) == marked(3, 2, 4, 0));
    }
}

TEST_CASE("A box of a variable equals that part of the whole field") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QCLOUD"] = marked;
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const Array3f part = dataset->read("QCLOUD", 0, CellBox{{1, 1, 2}, {3, 3, 5}});
    REQUIRE(part.size == glm::ivec3(2, 2, 3));
    CHECK(part.at(0, 0, 0) == marked(1, 1, 2, 0));
    CHECK(part.at(1, 1, 2) == marked(2, 2, 4, 0));
    for (const CellBox& box : {CellBox{{0, 0, 0}, {5, 3, 5}}, CellBox{{-1, 0, 0}, {1, 1, 1}},
                               CellBox{{2, 0, 0}, {2, 1, 1}}}) {
        CHECK(contains(errorOf([&] { dataset->read("QCLOUD", 0, box); }).what, "box"));
    }
}

TEST_CASE("Dry air density, temperature and pressure are those of docs/physics.md section 7") {
    struct Case {
        float pressure, theta, vapour, temperatureK, densityKgPerM3;
    };
    for (const Case& c : {Case{5e4f, 320.0f, 0.002f, 262.5073f, 0.661534f},
                          Case{9e4f, 300.0f, 0.015f, 291.1037f, 1.051864f}}) {
        const TemporaryFolder folder;
        WrfSpec spec;
        spec.fields["PB"] = [&](int, int, int, int) { return c.pressure - 1000.0f; };
        spec.fields["P"] = [&](int, int, int, int) { return 1000.0f; };
        spec.fields["T"] = [&](int, int, int, int) { return c.theta - 300.0f; };
        spec.fields["QVAPOR"] = [&](int, int, int, int) { return c.vapour; };
        writeWrf(folder / "a", spec);
        const auto dataset = openFiles({folder / "a"});
        CHECK(dataset->read("air_pressure", 0).at(2, 1, 3) == doctest::Approx(c.pressure));
        CHECK(dataset->read("air_temperature", 0).at(2, 1, 3) ==
              doctest::Approx(c.temperatureK).epsilon(1e-6));
        CHECK(dataset->read("dry_air_density", 0).at(2, 1, 3) ==
              doctest::Approx(c.densityKgPerM3).epsilon(2e-6));
        const VariableInfo* vapour = dataset->info().find(VariableRole::waterVapour);
        REQUIRE(vapour != nullptr);
        CHECK(vapour->name == "QVAPOR");
        CHECK(vapour->standardName == "humidity_mixing_ratio");
        CHECK(vapour->units == "kg kg-1");
        CHECK(dataset->read("QVAPOR", 0).at(2, 1, 3) == c.vapour);
    }
}

TEST_CASE("Aerosol of Thompson's scheme has its roles, and haze its extinction") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mpPhysics = 28;
    spec.fields["QNWFA"] = [](int, int, int z, int) { return z == 0 ? 1e9f : 1e8f; };
    spec.fields["QNIFA"] = [](int, int, int z, int) { return z == 0 ? 2e5f : 1e5f; };
    spec.units["QNWFA"] = spec.units["QNIFA"] = "# kg(-1)";  // as in the Registry
    spec.fields["PB"] = everywhere(9e4f);
    spec.fields["P"] = everywhere(0.0f);
    spec.fields["T"] = everywhere(0.0f);
    spec.fields["QVAPOR"] = everywhere(0.0001f);
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const VariableInfo* aerosol = dataset->info().find(VariableRole::hygroscopicAerosolNumber);
    const VariableInfo* dust = dataset->info().find(VariableRole::dustNumber);
    REQUIRE(aerosol != nullptr);
    REQUIRE(dust != nullptr);
    CHECK(aerosol->name == "QNWFA");
    CHECK(dust->name == "QNIFA");
    CHECK(aerosol->units == "kg-1");
    CHECK_FALSE(aerosol->species.has_value());
    CHECK(dataset->read("QNWFA", 0).at(1, 1, 0) == 1e9f);
    const LowestAir air = readLowestAir(*dataset, 0);
    // 1.077 kg/m³ of air at 291.1 K, almost dry: the cross-sections of [WRF] gt_aod below 10 %.
    CHECK(*air.humidity < 0.01);
    CHECK(air.aerosolPerM.value_or(0.0) ==
          doctest::Approx(1.077 * (1e9 * 5.73936e-15 + 2e5 * 2.63577e-12)).epsilon(0.02));
}

TEST_CASE("Without QVAPOR the air is treated as dry, with a note") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"QVAPOR"};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    // p / (R_d T) at 5e4 Pa and the 262.5073 K of docs/physics.md section 7.
    CHECK(dataset->read("dry_air_density", 0).at(0, 0, 0) ==
          doctest::Approx(5e4 / (287.0 * 262.5073)).epsilon(2e-6));
    CHECK(std::ranges::any_of(dataset->info().notes,
                              [](const std::string& note) { return contains(note, "QVAPOR"); }));
}

TEST_CASE("Interface heights are (PH+PHB)/9.81 on one level more than the cells") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["PH"] = [](int, int, int z, int) { return z == 2 ? 98.1f : 0.0f; };
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const VariableInfo* height = dataset->info().find(VariableRole::interfaceHeight);
    REQUIRE(height != nullptr);
    CHECK(height->size == glm::ivec3(4, 3, 6));
    CHECK(height->standardName == "altitude");
    const Array3f heights = dataset->read(height->name, 0);
    CHECK(heights.at(0, 0, 1) == doctest::Approx(100.0));
    CHECK(heights.at(0, 0, 2) == doctest::Approx(210.0));
    CHECK(heights.at(3, 2, 5) == doctest::Approx(500.0));
}

TEST_CASE("Species that the file lacks are absent; the others have role, species and unit") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QNRAIN"] = marked;
    spec.fields["RE_CLOUD"] = marked;
    spec.fields["QHAIL"] = marked;
    writeWrf(folder / "a", spec);
    const DatasetInfo info = openFiles({folder / "a"})->info();
    for (const Species absent : {Species::ice, Species::snow, Species::graupel}) {
        CHECK(info.find(VariableRole::mixingRatio, absent) == nullptr);
    }
    REQUIRE(info.find(VariableRole::mixingRatio, Species::cloud) != nullptr);
    CHECK(info.find(VariableRole::mixingRatio, Species::cloud)->standardName ==
          "cloud_liquid_water_mixing_ratio");
    REQUIRE(info.find(VariableRole::mixingRatio, Species::hail) != nullptr);
    CHECK(info.find(VariableRole::mixingRatio, Species::hail)->name == "QHAIL");
    REQUIRE(info.find(VariableRole::numberConcentration, Species::rain) != nullptr);
    CHECK(info.find(VariableRole::numberConcentration, Species::rain)->units == "kg-1");
    REQUIRE(info.find(VariableRole::effectiveRadius, Species::cloud) != nullptr);
    CHECK(info.find(VariableRole::effectiveRadius, Species::cloud)->units == "m");
}

TEST_CASE("All other fields are listed and readable, staggered ones with their own size") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["U"] = marked;
    spec.fields["W"] = marked;
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    REQUIRE(dataset->info().find("U") != nullptr);
    CHECK(dataset->info().find("U")->size == glm::ivec3(5, 3, 5));
    CHECK(dataset->read("U", 0).at(4, 2, 4) == marked(4, 2, 4, 0));
    CHECK(dataset->read("W", 0).at(3, 2, 5) == marked(3, 2, 5, 0));
}

TEST_CASE("Opening reads no field: a file without field data still has a description") {
    const TemporaryFolder folder;
    WrfSpec spec;
    writeWrf(folder / "a", spec);
    // Fields follow Times in the only record; 400 bytes less cut off the last fields.
    const auto whole = std::filesystem::file_size(folder / "a");
    truncateTo(folder / "a", whole - 400);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->info().times.size() == 1);
    CHECK(dataset->info().find("QRAIN") != nullptr);
    CHECK(contains(errorOf([&] { dataset->read("QRAIN", 0); }).what, "ends before the end"));
    CHECK(dataset->read("T", 0).at(0, 0, 0) == 20.0f);
}

TEST_CASE("Opening reads no field: of a 4 MB file less than a tenth is read") {
    const auto path = std::filesystem::path(NEPH_TEST_SOURCE_DIR) /
                      "samples/supercell/wrfout_d01_0001-01-01_02:00:00";
    readerHost();
    const auto before = bytesRead();
    if (!before) {
        MESSAGE("this system does not count bytes read");
        return;
    }
    openFiles({path});
    CHECK(*bytesRead() - *before < std::filesystem::file_size(path) / 10);
}

TEST_CASE("Reading reports progress and can be cancelled") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    const auto dataset = openFiles({folder / "a"});
    double last = -1.0;
    dataset->read("dry_air_density", 0, {}, [&](double fraction) {
        CHECK(fraction >= last);
        last = fraction;
        return true;
    });
    CHECK(last == 1.0);
    CHECK_THROWS_AS(dataset->read("T", 0, {}, [](double) { return false; }), Cancelled);
    CHECK_THROWS_AS(dataset->read("T", 0, {}, [](double) -> bool { throw 7; }), int);
    CHECK(dataset->read("T", 0).at(0, 0, 0) == 20.0f);
}

TEST_CASE("Two datasets are read from two threads at once") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.format = NetcdfFormat::netcdf4;
    spec.fields["QCLOUD"] = marked;
    writeWrf(folder / "a", spec);
    writeWrf(folder / "b", spec);
    int wrong = 0;
    std::vector<std::thread> threads;
    std::mutex mutex;
    for (const char* name : {"a", "b"}) {
        threads.emplace_back([&, path = folder / name] {
            for (int i = 0; i < 20; ++i) {
                const float value = openFiles({path})->read("QCLOUD", 0).at(3, 2, 4);
                const std::scoped_lock lock(mutex);
                if (value != marked(3, 2, 4, 0)) ++wrong;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == 0);
}

TEST_CASE("Packed values are unpacked, fill values are missing") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QCLOUD"] = [](int x, int, int, int) { return x == 0 ? -999.0f : 3.0f; };
    spec.fields["QRAIN"] = [](int x, int, int, int) { return x == 0 ? NC_FILL_FLOAT : 3.0f; };
    writeWrf(folder / "a", spec);
    int file = -1;
    int id = -1;
    const float scale = 0.5f, offset = 10.0f, fill = -999.0f;
    REQUIRE(nc_open((folder / "a").c_str(), NC_WRITE, &file) == NC_NOERR);
    REQUIRE(nc_inq_varid(file, "QCLOUD", &id) == NC_NOERR);
    nc_redef(file);
    nc_put_att_float(file, id, "scale_factor", NC_FLOAT, 1, &scale);
    nc_put_att_float(file, id, "add_offset", NC_FLOAT, 1, &offset);
    nc_put_att_float(file, id, "_FillValue", NC_FLOAT, 1, &fill);
    REQUIRE(nc_close(file) == NC_NOERR);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->read("QCLOUD", 0).at(1, 0, 0) == 11.5f);
    CHECK(std::isnan(dataset->read("QCLOUD", 0).at(0, 0, 0)));
    CHECK(dataset->read("QRAIN", 0).at(1, 0, 0) == 3.0f);
    CHECK(std::isnan(dataset->read("QRAIN", 0).at(0, 0, 0)));
}

TEST_CASE("Known schemes are named, unknown ones numbered, and without a title the model is WRF") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mpPhysics = 10;
    writeWrf(folder / "a", spec);
    CHECK(openFiles({folder / "a"})->info().scheme == "Morrison (MP_PHYSICS 10)");
    spec.mpPhysics = 777;
    spec.omit = {"TITLE"};
    writeWrf(folder / "b", spec);
    CHECK(openFiles({folder / "b"})->info().scheme == "MP_PHYSICS 777");
    CHECK(openFiles({folder / "b"})->info().model == "WRF");
}
