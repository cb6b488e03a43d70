// raw_les_brick_test.cpp: bricks with a JSON sidecar: every number type, every way to give heights,
// and what is refused and why.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/geo/map_place.h"
#include "core/plugin/reader_file.h"
#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;
using Json = nlohmann::json;

namespace {

/// 2 x 1 x 3 cells, cloud water 1 to 6 g/kg in two bytes, one time.
Json small() {
    return Json::parse(R"({
        "type": "nephoscope-brick", "version": 1, "shape": [2, 1, 3], "spacing_m": [50, 60, 70],
        "byte_order": "little", "times": [{"seconds": 60}],
        "variables": [{"name": "qc", "role": "mixing_ratio", "species": "cloud", "unit": "g/kg",
                       "numbers": "uint16", "scale": 0.5, "offset": -1, "missing": 65535,
                       "file": "qc.raw"}]})");
}

const std::string kNumbers("\x04\x00\x06\x00\x08\x00\x0a\x00\x0c\x00\xff\xff", 12);

std::filesystem::path write(const TemporaryFolder& folder, const Json& sidecar,
                            const std::string& numbers = kNumbers) {
    writeText(folder / "qc.raw", numbers);
    writeText(folder / "brick.json", sidecar.dump());
    return folder / "brick.json";
}

ErrorParts errorWith(const std::function<void(Json&)>& change) {
    const TemporaryFolder folder;
    Json sidecar = small();
    change(sidecar);
    const auto path = write(folder, sidecar);
    return errorOf([&] { openFiles({path}); });
}

}  // namespace

TEST_CASE("A brick reads as scale times number plus offset, in SI, with missing values") {
    const TemporaryFolder folder;
    for (const auto& path : {write(folder, small()), folder.path()}) {
        const auto dataset = openFiles({path});
        CHECK(dataset->info().size == glm::ivec3(2, 1, 3));
        CHECK(dataset->info().spacingM == glm::dvec2(50.0, 60.0));
        CHECK(dataset->info().times[0].label == "60 s");
        const Array3f qc = dataset->read("qc", 0);
        for (int i = 0; i < 5; ++i) {
            CHECK(qc.values[static_cast<std::size_t>(i)] == doctest::Approx(1e-3 * (i + 1)));
        }
        CHECK(std::isnan(qc.values[5]));
        CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 70, 140, 210});
        CHECK(contains(dataset->info().notes.at(0), "Standard Atmosphere 1976"));
    }
}

TEST_CASE("A brick reads the same in both byte orders and all number types") {
    for (const bool big : {false, true}) {
        const TemporaryFolder folder;
        Json sidecar = small();
        sidecar["byte_order"] = big ? "big" : "little";
        auto& variable = sidecar["variables"][0];
        variable.erase("scale");
        variable.erase("offset");
        variable.erase("missing");
        variable["numbers"] = "float32";
        const auto path = write(folder, sidecar);
        writeFloats(folder / "qc.raw", {1, 2, 3, 4, 5, 6}, big);
        CHECK(openFiles({path})->read("qc", 0).values[5] == doctest::Approx(6e-3));
    }
    const std::vector<std::pair<const char*, std::string>> spellings{
        {"uint8", {"\x01\x02\x03\x04\x05\xfa", 6}},
        {"int16", {"\x01\x00\x02\x00\x03\x00\x04\x00\x05\x00\xfa\x00", 12}},
        {"int32", {"\x01\0\0\0\x02\0\0\0\x03\0\0\0\x04\0\0\0\x05\0\0\0\xfa\0\0\0", 24}}};
    for (const auto& [numbers, bytes] : spellings) {
        const TemporaryFolder folder;
        Json sidecar = small();
        sidecar["variables"][0]["numbers"] = numbers;
        sidecar["variables"][0]["offset"] = 0;
        const auto qc = openFiles({write(folder, sidecar, bytes)})->read("qc", 0);
        const std::string type = numbers;
        CAPTURE(type);
        CHECK(qc.values[1] == doctest::Approx(1e-3));
        CHECK(qc.values[5] == doctest::Approx(125e-3));
    }
    const TemporaryFolder folder;
    Json sidecar = small();
    sidecar["variables"][0]["numbers"] = "float64";
    const auto path = write(folder, sidecar);
    writeDoubles(folder / "qc.raw", {4, 6, 8, 10, 12, 14});
    CHECK(openFiles({path})->read("qc", 0).values[5] == doctest::Approx(6e-3));
}

TEST_CASE("Times are stored one after another in a file, or in separate files, or are zero") {
    const TemporaryFolder folder;
    Json sidecar = small();
    sidecar["times"] = {{{"seconds", 60}}, {{"seconds", 90}, {"label", "later"}}};
    const std::string second("\x02\x00\x02\x00\x02\x00\x02\x00\x02\x00\x04\x00", 12);
    const auto together = openFiles({write(folder, sidecar, kNumbers + second)});
    CHECK(together->info().times[1].label == "later");
    CHECK(together->info().times[1].seconds == 30.0);
    CHECK(together->read("qc", 0).values[0] == doctest::Approx(1e-3));
    CHECK(together->read("qc", 1).values[0] == 0.0f);
    CHECK(together->read("qc", 1).values[5] == doctest::Approx(1e-3));
    auto& variable = sidecar["variables"][0];
    variable.erase("file");
    variable["files"] = {nullptr, "qc.raw"};
    const auto apart = openFiles({write(folder, sidecar)});
    CHECK(apart->read("qc", 0).values == std::vector<float>(6, 0.0f));
    CHECK(apart->read("qc", 1).values[0] == doctest::Approx(1e-3));
}

TEST_CASE("Heights come from level centres or interfaces, air from profiles") {
    const TemporaryFolder folder;
    Json sidecar = small();
    sidecar["spacing_m"] = {50, 60};
    sidecar["level_heights_m"] = {30, 100, 180};
    sidecar["variables"].push_back(
        {{"name", "p"}, {"role", "air_pressure"}, {"unit", "hPa"}, {"profile", {1000, 990, 980}}});
    sidecar["variables"].push_back({{"name", "theta"},
                                    {"role", "potential_temperature"},
                                    {"unit", "K"},
                                    {"profile", {300, 300, 300}}});
    const auto dataset = openFiles({write(folder, sidecar)});
    CHECK(dataset->read("interface_height", 0).values == std::vector<float>{0, 65, 140, 220});
    CHECK(dataset->read("p", 0).values == std::vector<float>{100000, 99000, 98000});
    // Dry air of 300 K at 1000 hPa: 1e5 / (287.04 · 300) kg/m³.
    CHECK(dataset->read("dry_air_density", 0).values[1] ==
          doctest::Approx(1e5 / (287.04 * 300.0)).epsilon(1e-6));
    CHECK(dataset->read("air_temperature", 0).values[5] == doctest::Approx(298.2753).epsilon(1e-6));
    CHECK(contains(dataset->info().notes.at(0), "treated as dry"));
    sidecar.erase("level_heights_m");
    sidecar["interface_heights_m"] = {0, 500, 550, 600};
    CHECK(openFiles({write(folder, sidecar)})->read("interface_height", 0).values ==
          std::vector<float>{0, 500, 550, 600});
}

TEST_CASE("A brick of the wrong size is refused with the actual and the expected size") {
    for (const std::size_t bytes : {0UL, 11UL, 13UL, 24UL}) {
        const TemporaryFolder folder;
        const auto path = write(folder, small(), std::string(bytes, 'x'));
        const ErrorParts error = errorOf([&] { openFiles({path}); });
        CHECK(contains(error.where, "qc.raw"));
        CHECK(contains(error.what, bytes < 12 ? "shorter" : "longer"));
        CHECK(error.found == std::to_string(bytes) + " bytes");
        CHECK(contains(error.expected, "12 bytes: 2 x 1 x 3"));
    }
    CHECK(contains(errorWith([](Json& j) { j["variables"][0]["file"] = "other.raw"; }).what,
                   "missing"));
}

TEST_CASE("Invalid sidecars are refused with an error that names the key") {
    CHECK(contains(errorWith([](Json& j) { j["shpae"] = 1; }).what, "shpae is not known"));
    CHECK(
        contains(errorWith([](Json& j) { j.erase("byte_order"); }).what, "byte_order is missing"));
    CHECK(contains(errorWith([](Json& j) { j["version"] = 2; }).what, "version"));
    CHECK(contains(errorWith([](Json& j) { j["shape"] = {2, 1, 0}; }).what, "shape"));
    CHECK(contains(errorWith([](Json& j) { j["shape"] = {2, 1, 1e30}; }).what, "shape"));
    CHECK(contains(errorWith([](Json& j) { j["shape"] = {2, 1}; }).what, "shape"));
    CHECK(contains(errorWith([](Json& j) { j["spacing_m"] = {0, 1, 1}; }).what, "spacing_m"));
    CHECK(contains(errorWith([](Json& j) { j["spacing_m"] = {1, 1}; }).what, "heights of levels"));
    CHECK(contains(errorWith([](Json& j) { j["times"] = Json::array(); }).what, "times"));
    const auto variable = [](const char* key, const Json& value) {
        return errorWith([&](Json& j) { j["variables"][0][key] = value; });
    };
    CHECK(contains(variable("role", "mixing").expected, "mixing_ratio"));
    CHECK(contains(variable("species", "fog").expected, "cloud"));
    CHECK(contains(variable("unit", "furlong").what, "unit of variable qc"));
    CHECK(contains(variable("numbers", "float16").what, "variable 0, key numbers"));
    CHECK(contains(variable("scale", "big").what, "scale"));
    CHECK(contains(variable("first_byte", -1).what, "first_byte"));
    CHECK(contains(variable("first_byte", 1e300).what, "first_byte"));
    CHECK(contains(variable("profile", {1, 2, 3}).what, "given exactly once"));
    CHECK(contains(variable("role", "other").what, "no variable is a hydrometeor"));
    const TemporaryFolder folder;
    writeText(folder / "brick.json", "{ \"type\": \"nephoscope-brick\", ");
    CHECK(contains(errorOf([&] { openFiles({folder / "brick.json"}); }).what, "not JSON"));
}

TEST_CASE("Faces of uneven cells are stated in the sidecar, from any origin") {
    const TemporaryFolder folder;
    Json sidecar = small();
    sidecar["edges_m"] = {{"x", {-100, 0, 50}}};
    const auto path = write(folder, sidecar);
    const DatasetInfo info = ReaderFile(readerHost().pick(path), path).description();
    CHECK(info.edgesM[0] == std::vector<double>{0, 100, 150});
    CHECK(info.edgesM[1].empty());
    CHECK(info.spacingM.x == 50.0);
    CHECK(contains(errorWith([](Json& j) {
                       j["edges_m"] = {{"x", {0, 1}}};
                   }).expected,
                   "3 positions"));
    CHECK(contains(errorWith([](Json& j) { j["edges_m"] = {{"x", {0, 2, 1}}}; }).what, "key x"));
    CHECK(contains(errorWith([](Json& j) { j["edges_m"] = {{"z", {0, 1}}}; }).what, "not known"));
    CHECK(contains(errorWith([](Json& j) { j["edges_m"] = 3; }).what, "not an object"));
}

TEST_CASE("A sidecar with the wrong byte order is refused with the right one") {
    const TemporaryFolder folder;
    Json sidecar = small();
    auto& variable = sidecar["variables"][0];
    for (const char* key : {"scale", "offset", "missing"}) variable.erase(key);
    variable["numbers"] = "float32";
    const auto path = write(folder, sidecar);
    writeFloats(folder / "qc.raw", {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}, true);
    const ErrorParts error = errorOf([&] { openFiles({path}); });
    CHECK(contains(error.what, "byte order that the sidecar states"));
    CHECK(contains(error.hint, "\"byte_order\": \"big\""));
}

TEST_CASE("Variables of a sidecar with the same species are added up") {
    const TemporaryFolder folder;
    Json sidecar = small();
    Json second = sidecar["variables"][0];
    second["name"] = "qc2";
    second["offset"] = 0;
    sidecar["variables"].push_back(second);
    const auto dataset = openFiles({write(folder, sidecar)});
    const auto* cloud = dataset->info().find(VariableRole::mixingRatio, Species::cloud);
    REQUIRE(cloud->name == "qc+qc2");
    CHECK(dataset->read(cloud->name, 0).values[0] == doctest::Approx(1e-3 + 2e-3));
}

TEST_CASE("A brick may state the place of its middle and the date of its zero") {
    const TemporaryFolder folder;
    Json sidecar = small();
    CHECK(openFiles({write(folder, sidecar)})->info().map.projection.empty());
    sidecar["latitude"] = 52.5;
    sidecar["longitude"] = -1.25;
    sidecar["start_utc"] = "2019-06-20T11:59:30Z";
    const DatasetInfo info = openFiles({write(folder, sidecar)})->info();
    const MapPlace place(info.map);
    const auto middle = place.at(0.5 * info.extentM());
    REQUIRE(middle);
    CHECK(middle->geo.latitudeDeg == doctest::Approx(52.5));
    CHECK(middle->geo.longitudeDeg == doctest::Approx(-1.25));
    CHECK(std::abs(middle->convergenceDeg) < 1e-6);
    CHECK(middle->mapFactor.x == doctest::Approx(1.0));
    CHECK(utcText(info.times.at(0).utc.value()) == "2019-06-20T12:00:30Z");
}

TEST_CASE("A place or a date of a brick that is none is refused by its key") {
    CHECK(contains(errorWith([](Json& s) { s["latitude"] = 1; }).what, "longitude is missing"));
    CHECK(contains(errorWith([](Json& s) { s["latitude"] = 91, s["longitude"] = 0; }).what,
                   "latitude"));
    for (const char* text : {"2019-06-20", "2019-06-20T12:00", "2019-06-20T12:00:00+02:00",
                             "2019-02-29T12:00:00Z", "noon"}) {
        CAPTURE(text);
        const ErrorParts error = errorWith([&](Json& s) { s["start_utc"] = text; });
        CHECK(contains(error.what, "start_utc"));
        CHECK(contains(error.expected, "2021-08-14T18:00:00Z"));
    }
}
