// old_reader_test.cpp: a reader that was built for an earlier version of the ABI still serves.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("A reader of version 1 of the ABI loads, describes and reads as it did") {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "old";
    const PluginHost host(std::vector<std::filesystem::path>{NEPH_TEST_OLD_READER});
    REQUIRE(host.readers().size() == 1);
    CHECK(host.readers()[0]->id == "old");
    CHECK(host.readers()[0]->abiVersion == 1);
    const std::vector<std::filesystem::path> files{folder / "file"};
    const auto dataset = Dataset::open(files, host, {}, {});
    const DatasetInfo& info = dataset->info();
    CHECK(info.model == "Old 1");
    CHECK(info.domain == "domain 1");
    CHECK(info.times.at(0).label == "noon");
    // What it could not state is not known, and not a fault.
    CHECK(info.map.projection.empty());
    CHECK_FALSE(info.times.at(0).utc);
    CHECK(info.nest == NestNumbers{});
    CHECK(info.notes.empty());
    CHECK(dataset->read("cloud", 0).values == std::vector<float>(8, 1e-3f));
}
