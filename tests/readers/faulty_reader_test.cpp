// faulty_reader_test.cpp: a reader that violates the ABI causes an error and nothing worse.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "core/plugin/plugin_file.h"
#include "tests/environment.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

struct NephFile {
    int unused;
};

namespace {

// What the reader under test does; each test sets it before opening.
struct Behaviour {
    NephDescription description{};
    NephStatus openStatus = NEPH_OK;
    bool noHandle = false, throws = false, nullDescription = false;
    std::uint64_t written = 0;
    NephStatus readStatus = NEPH_OK;
};
Behaviour behaviour;
NephTime theTime{{NEPH_READER_ABI_VERSION, sizeof(NephTime)}, "t0", 0.0, {}};
NephVariable theVariable{{NEPH_READER_ABI_VERSION, sizeof(NephVariable)},
                         "q",
                         "",
                         "kg kg-1",
                         "",
                         NEPH_ROLE_MIXING_RATIO,
                         NEPH_SPECIES_CLOUD,
                         {2, 2, 2},
                         ""};
std::array<const NephTime*, 1> times{&theTime};
std::array<const NephVariable*, 2> variables{&theVariable, &theVariable};
NephFile handle{0};

NephStatus openFaulty(const char*, NephFile** file, NephError*) {
    if (behaviour.throws) throw std::runtime_error("boo");
    *file = behaviour.noHandle ? nullptr : &handle;
    return behaviour.openStatus;
}
const NephDescription* describeFaulty(NephFile*) {
    return behaviour.nullDescription ? nullptr : &behaviour.description;
}
NephStatus readFaulty(NephFile*, NephReadRequest* request, NephError* error) {
    request->values_written = behaviour.written;
    if (behaviour.readStatus != NEPH_OK) {
        // A text without an end: the host must not read beyond it.
        std::fill(std::begin(error->what), std::end(error->what), 'x');
    }
    return behaviour.readStatus;
}
const NephReader faultyReader{{NEPH_READER_ABI_VERSION, sizeof(NephReader)},
                              "faulty",
                              "0",
                              "nothing",
                              "",
                              [](const char*) -> std::int32_t { return 50; },
                              &openFaulty,
                              &describeFaulty,
                              &readFaulty,
                              [](NephFile*) {},
                              nullptr};

PluginFile open() {
    return {faultyReader, "faulty", "some.file"};
}

/// Restores a description that is valid in every way.
void resetToValid() {
    behaviour = {};
    theTime.seconds = 0.0;
    theTime.grid_offset_m[0] = theTime.grid_offset_m[1] = 0.0;
    theVariable.header = {NEPH_READER_ABI_VERSION, sizeof(NephVariable)};
    theTime.header = {NEPH_READER_ABI_VERSION, sizeof(NephTime)};
    theVariable.name = "q";
    theVariable.size[2] = 2;
    NephDescription& d = behaviour.description;
    d.header = {NEPH_READER_ABI_VERSION, sizeof(NephDescription)};
    d.size[0] = d.size[1] = d.size[2] = 2;
    d.spacing_m[0] = d.spacing_m[1] = 100.0;
    d.time_count = 1;
    d.times = times.data();
    d.variable_count = 1;
    d.variables = variables.data();
    behaviour.written = 8;
}

std::string openFault() {
    return errorOf([] { open(); }).what;
}

std::string readFault() {
    std::vector<float> buffer(8 + PluginFile::kGuardValues);
    return errorOf([&] { open().read(0, 0, {{0, 0, 0}, {2, 2, 2}}, buffer, {}); }).what;
}

}  // namespace

TEST_CASE("A reader that follows the ABI is accepted") {
    resetToValid();
    const PluginFile file = open();
    CHECK(file.description().size == glm::ivec3(2));
    CHECK(file.description().variables.at(0).name == "q");
    CHECK(readFault().empty());
}

TEST_CASE("What cannot be a domain of a nested run counts as none, or as one without a place") {
    const auto nestOf = [](std::uint32_t number, std::int32_t corner, std::uint32_t ratio) {
        resetToValid();
        NephDescription& d = behaviour.description;
        d.domain_number = number;
        d.parent_number = 1;
        d.parent_corner[0] = d.parent_corner[1] = corner;
        d.parent_ratio = ratio;
        const NestNumbers nest = open().description().nest;
        d.domain_number = d.parent_number = d.parent_ratio = 0;
        d.parent_corner[0] = d.parent_corner[1] = 0;
        return nest;
    };
    CHECK(nestOf(2, 30, 3) ==
          NestNumbers{.number = 2, .parent = 1, .cornerCells = {30, 30}, .ratio = 3});
    CHECK(nestOf(4'000'000'000U, 30, 3) == NestNumbers{});
    CHECK(nestOf(2, -1, 3).ratio == 0);
    CHECK(nestOf(2, 2'000'000'000, 3).ratio == 0);
    CHECK(nestOf(2, 30, 4'000'000'000U).ratio == 0);
}

TEST_CASE("Times and variables of readers that do not state what was added since are accepted") {
    resetToValid();
    theTime.grid_offset_m[0] = 5.0;
    theVariable.reason = "its name";
    CHECK(open().description().times[0].gridOffsetM == glm::dvec2(5.0, 0.0));
    CHECK(open().description().variables[0].reason == "its name");
    theTime.header.struct_size = offsetof(NephTime, grid_offset_m);
    theVariable.header.struct_size = offsetof(NephVariable, reason);
    CHECK(open().description().times[0].gridOffsetM == glm::dvec2(0.0));
    CHECK(open().description().variables[0].reason.empty());
    theVariable.reason = "";
    resetToValid();
}

TEST_CASE("Impossible sizes, numbers and counts are reported as faults of the reader") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto faulty = [](auto&& falsify) {
        resetToValid();
        falsify(behaviour.description);
        const std::string what = openFault();
        CHECK(contains(what, "reader faulty is faulty"));
        return what;
    };
    CHECK(contains(faulty([](auto& d) { d.size[1] = -2; }), "size 2 x -2 x 2"));
    CHECK(contains(faulty([](auto& d) { d.size[0] = 0; }), "size 0"));
    CHECK(contains(faulty([](auto& d) { d.size[0] = d.size[1] = d.size[2] = 1 << 20; }), "cells"));
    CHECK(contains(faulty([&](auto& d) { d.spacing_m[0] = nan; }), "spacing"));
    CHECK(contains(faulty([](auto& d) { d.spacing_m[1] = 0.0; }), "spacing"));
    CHECK(contains(faulty([](auto& d) { d.time_count = 0; }), "no times"));
    CHECK(contains(faulty([](auto& d) { d.time_count = 4'000'000'000U; }), "claimed"));
    CHECK(contains(faulty([](auto& d) { d.times = nullptr; }), "null"));
    CHECK(contains(faulty([](auto& d) { d.variable_count = 2; }), "twice"));
    CHECK(contains(faulty([](auto& d) { d.header.struct_size = 8; }), "bytes"));
    CHECK(contains(faulty([](auto& d) { d.header.abi_version = 99; }), "ABI 99"));
    CHECK(contains(faulty([&](auto&) { theTime.seconds = nan; }), "finite"));
    CHECK(contains(faulty([](auto&) { theVariable.header.struct_size = 8; }), "bytes"));
    CHECK(contains(faulty([](auto&) { theTime.header.struct_size = 0; }), "a time"));
    CHECK(contains(faulty([&](auto&) { theTime.grid_offset_m[1] = nan; }), "the grid has moved"));
    CHECK(contains(faulty([&](auto&) { theTime.grid_offset_m[0] = -1e30; }), "the grid has moved"));
    CHECK(contains(faulty([](auto&) { theVariable.name = ""; }), "no name"));
    CHECK(contains(faulty([](auto&) { theVariable.name = nullptr; }), "no name"));
    CHECK(contains(faulty([](auto&) { theVariable.size[2] = -1; }), "of q"));
    CHECK(contains(faulty([](auto&) { behaviour.nullDescription = true; }), "null"));
}

TEST_CASE("A place or a date that cannot be used is left out with a note, and the rest is taken") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto described = [](auto&& change) {
        resetToValid();
        NephDescription& d = behaviour.description;
        d.projection = "+proj=merc +lon_0=10 +R=6370000";
        d.utc_of_zero = "2021-08-14T18:00:00Z";
        change(d);
        return open().description();
    };
    const DatasetInfo good = described([](auto& d) { d.map_origin_m[1] = 5e6; });
    CHECK(good.map.projection == "+proj=merc +lon_0=10 +R=6370000");
    CHECK(good.map.originM.y == 5e6);
    CHECK(good.map.mapPerGrid == glm::dvec2(1.0));  // 0 stands for 1
    CHECK(utcText(good.times.at(0).utc.value()) == "2021-08-14T18:00:00Z");
    CHECK(good.notes.empty());
    const auto refused = [&](auto&& change) {
        const DatasetInfo info = described(change);
        CHECK(info.map.projection.empty());
        CHECK(info.size == glm::ivec3(2));
        REQUIRE(info.notes.size() == 1);
        CHECK(contains(info.notes[0], "The place on the earth is not known"));
        return info.notes[0];
    };
    CHECK(contains(refused([](auto& d) { d.projection = "+proj=nonsense"; }), "+proj=nonsense"));
    CHECK(contains(refused([](auto& d) { d.projection = "EPSG:4326"; }), "EPSG:4326"));
    refused([&](auto& d) { d.map_origin_m[0] = nan; });
    refused([](auto& d) { d.map_per_grid[0] = -1.0; });
    refused([](auto& d) { d.projection = "+proj=merc +nadgrids=@null"; });
    const DatasetInfo undated = described([](auto& d) { d.utc_of_zero = "last Tuesday"; });
    CHECK_FALSE(undated.times.at(0).utc);
    CHECK(contains(undated.notes.at(0), "last Tuesday is no time in UTC"));
    // A time that is beyond any calendar has no date, and is no fault.
    theTime.seconds = 0.0;
    const DatasetInfo far = described([](auto&) { theTime.seconds = 1e300; });
    CHECK_FALSE(far.times.at(0).utc);
    const DatasetInfo ideal = described([](auto& d) {
        d.projection = nullptr;
        d.no_place = "the run is idealised";
    });
    CHECK(ideal.noPlace == "the run is idealised");
    CHECK(ideal.notes.empty());
}

TEST_CASE("Calls that throw, give no handle or fail without a reason are errors") {
    resetToValid();
    behaviour.throws = true;
    CHECK(contains(openFault(), "threw boo"));
    resetToValid();
    behaviour.noHandle = true;
    CHECK(contains(openFault(), "no handle"));
    resetToValid();
    behaviour.openStatus = NEPH_FAILED;
    CHECK(contains(openFault(), "no reason"));
}

TEST_CASE("A short read and an error text without an end are errors") {
    resetToValid();
    behaviour.written = 7;
    CHECK(contains(readFault(), "7 values of q, 8"));
    resetToValid();
    behaviour.readStatus = NEPH_FAILED;
    CHECK(readFault() == std::string(sizeof(NephError::what), 'x'));
}

TEST_CASE("Libraries that are not readers are rejected with a reason, and the others still work") {
    const TemporaryFolder folder;
    std::ofstream(folder / "broken.so") << "not a library";
    std::filesystem::copy_file(std::filesystem::path(NEPH_TEST_READER_DIR) / "wrf_netcdf.so",
                               folder / "z_copy.so");
    const PluginHost host(std::vector<std::filesystem::path>{NEPH_TEST_READER_DIR, folder.path(),
                                                             folder / "nowhere", "libm.so.6"});
    REQUIRE(host.readers().size() == readerHost().readers().size());
    for (std::size_t i = 0; i < host.readers().size(); ++i) {
        CHECK(host.readers()[i]->id == readerHost().readers()[i]->id);
        CHECK(host.readers()[i]->abiVersion == NEPH_READER_ABI_VERSION);
    }
    CHECK(host.readers().back()->id == "wrf_netcdf");
    REQUIRE(host.rejected().size() == 2);
    CHECK(host.rejected()[0].library == folder / "broken.so");
    CHECK(!host.rejected()[0].reason.empty());
    CHECK(contains(host.rejected()[1].reason, "already found"));
}

TEST_CASE("A library without the entry point is rejected; without any reader the error says so") {
    // The mathematics library of the system, wherever the loader found it.
    std::filesystem::path library;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t start = line.find('/');
        if (start != std::string::npos && line.find("libm.so") != std::string::npos) {
            library = line.substr(start);
        }
    }
    REQUIRE(!library.empty());
    const PluginHost host(std::vector<std::filesystem::path>{library});
    CHECK(host.readers().empty());
    REQUIRE(host.rejected().size() == 1);
    CHECK(contains(host.rejected()[0].reason, "nephReader"));
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    CHECK(
        contains(errorOf([&] { host.pick(folder / "file"); }).what, "no reader plugin was found"));
}

TEST_CASE(
    "Standard places are those of the path variable, the user's data folder, and next to the "
    "program") {
    const Environment readers("NEPHOSCOPE_READER_PATH", "/one::/two");
    const Environment data("XDG_DATA_HOME", "/data");
    const auto places = PluginHost::standardPlaces();
    REQUIRE(places.size() == 4);
    CHECK(places[0] == "/one");
    CHECK(places[1] == "/two");
    CHECK(places[2] == "/data/nephoscope/readers");
    CHECK(places[3].parent_path().filename() == "nephoscope");
}
