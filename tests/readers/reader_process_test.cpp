// reader_process_test.cpp: a reader in a process of its own gives the same results as in this one.
#include "core/plugin/reader_process.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/plugin/plugin_file.h"
#include "core/plugin/plugin_library.h"

namespace {

using namespace neph;
namespace fs = std::filesystem;

const fs::path kLibrary = fs::path(NEPH_TEST_READER_DIR) / "wrf_netcdf.so";
const fs::path kFile =
    fs::path(NEPH_TEST_SOURCE_DIR) / "samples/supercell/wrfout_d01_0001-01-01_01:00:00";

}  // namespace

TEST_CASE("A reader process reports what the library reports about itself and about a file") {
    ReaderProcess process(kLibrary);
    CHECK(process.identity().id == "wrf_netcdf");
    CHECK(process.identity().abiVersion == NEPH_READER_ABI_VERSION);
    CHECK(process.score(kFile) == 90);
    CHECK(process.score(kLibrary) == 0);
    CHECK_THROWS_AS(process.open(kLibrary, {}), Error);
    CHECK(process.alive());
}

TEST_CASE("Values through shared memory equal those that the library returns directly") {
    const PluginLibrary library = loadPlugin(kLibrary);
    PluginFile within(*library.calls, library.identity.id, kFile);
    ReaderProcess process(kLibrary);
    const ReaderProcess::Opened opened = process.open(kFile, {});
    const DatasetInfo& there = opened.description;
    REQUIRE(there.variables.size() == within.description().variables.size());
    CHECK(there.size == within.description().size);
    CHECK(there.attributes == within.description().attributes);
    for (const char* name : {"QCLOUD", "interface_height"}) {
        const auto found = std::ranges::find(there.variables, name, &VariableInfo::name);
        REQUIRE(found != there.variables.end());
        const auto index = static_cast<std::size_t>(found - there.variables.begin());
        const glm::ivec3 lower(3, 5, 7), upper(60, 71, found->size.z);
        const glm::ivec3 size = upper - lower;
        const auto count = static_cast<std::size_t>(size.x * size.y * size.z);
        std::vector<float> expected(count + PluginFile::kGuardValues);
        within.read(index, 0, {lower, upper}, expected, {});
        expected.resize(count);
        wire::ReadRequest request{opened.handle, index, 0, {lower, upper}};
        CHECK(process.read(request, kFile, name, {}) == expected);
    }
}

TEST_CASE("A library that is not a reader is refused with a reason") {
    CHECK_THROWS_WITH_AS(ReaderProcess("/nonexistent.so"), doctest::Contains("cannot open shared"),
                         Error);
}
