// header_cache_test.cpp: what is remembered comes back as it was, and nothing that has changed
// does.
#include "core/dataset/header_cache.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "tests/temporary_folder.h"

using namespace neph;

namespace {

DatasetInfo described(double seconds) {
    DatasetInfo description;
    description.model = "WRF V4.2.2";
    description.scheme = "Thompson";
    description.microphysics = Microphysics::thompson;
    description.cloudDropletsPerM3 = 1.0 / 3.0;
    description.size = {3, 4, 5};
    description.spacingM = {1000.0, 0.1};
    description.map = {"+proj=merc", {-1.0 / 3.0, 2e6}, {1.5, 2.0}};
    description.noPlace = "none";
    description.rowsTogether = 267;
    description.nest = {.number = 3, .parent = 2, .cornerCells = {30, 41}, .ratio = 5};
    description.times = {{"t\xC3\xA9", seconds, {}, 0}};
    description.times[0].gridOffsetM = {22500.0, -1.0 / 3.0};
    if (seconds > 0.0) description.times[0].utc = UtcTime(UtcTime::duration(seconds / 3.0));
    description.variables = {{"QCLOUD",
                              "cloud",
                              "kg kg-1",
                              "text",
                              VariableRole::mixingRatio,
                              Species::cloud,
                              {3, 4, 5}}};
    description.notes = {"a note"};
    description.attributes = {{"DX", "1000"}};
    return description;
}

void checkSame(const DatasetInfo& a, const DatasetInfo& b) {
    CHECK(a.model == b.model);
    CHECK(a.scheme == b.scheme);
    CHECK(a.microphysics == b.microphysics);
    CHECK(a.cloudDropletsPerM3 == b.cloudDropletsPerM3);
    CHECK(a.size == b.size);
    CHECK(a.spacingM == b.spacingM);
    CHECK(a.map == b.map);
    CHECK(a.noPlace == b.noPlace);
    CHECK(a.rowsTogether == b.rowsTogether);
    CHECK(a.nest == b.nest);
    REQUIRE(a.times.size() == 1);
    CHECK(a.times[0].label == b.times[0].label);
    CHECK(a.times[0].seconds == b.times[0].seconds);
    CHECK(a.times[0].utc == b.times[0].utc);
    CHECK(a.times[0].gridOffsetM == b.times[0].gridOffsetM);
    REQUIRE(a.variables.size() == 1);
    CHECK(a.variables[0].name == b.variables[0].name);
    CHECK(a.variables[0].standardName == b.variables[0].standardName);
    CHECK(a.variables[0].units == b.variables[0].units);
    CHECK(a.variables[0].description == b.variables[0].description);
    CHECK(a.variables[0].role == b.variables[0].role);
    CHECK(a.variables[0].species == b.variables[0].species);
    CHECK(a.variables[0].size == b.variables[0].size);
    CHECK(a.notes == b.notes);
    CHECK(a.attributes == b.attributes);
}

/// A folder of data, one of cache files, and a reader.
struct Place {
    TemporaryFolder data, cache;
    ReaderName reader;

    Place() {
        reader.id = "some";
        reader.version = "1.0";
    }
    HeaderCache open() const { return {cache.path(), data.path(), reader}; }
    HeaderStamp write(const char* name, const std::string& text) const {
        std::ofstream(data / name) << text;
        return headerStampOf(data / name).value();
    }
    std::filesystem::path onlyCacheFile() const {
        return std::filesystem::directory_iterator(cache.path())->path();
    }
};

}  // namespace

TEST_CASE("A description comes back from the cache as it was") {
    const Place place;
    const HeaderStamp a = place.write("a", "1"), b = place.write("b", "22");
    HeaderCache first = place.open();
    CHECK(!first.find(place.data / "a", a));
    first.put(place.data / "a", a, described(0.1));
    first.put(place.data / "b", b, described(3600.0));
    first.save();
    const HeaderCache again = place.open();
    const auto found = again.find(place.data / "b", b);
    REQUIRE(found);
    checkSame(*found, described(3600.0));
    REQUIRE(again.find(place.data / "a", a));
    CHECK(again.find(place.data / "a", a)->times[0].seconds == 0.1);
}

TEST_CASE("A file that has another size or time of change is not in the cache") {
    const Place place;
    const HeaderStamp stamp = place.write("a", "1");
    HeaderCache cache = place.open();
    cache.put(place.data / "a", stamp, described(0.0));
    cache.save();
    CHECK(!place.open().find(place.data / "a", {stamp.bytes + 1, stamp.changedNs}));
    CHECK(!place.open().find(place.data / "a", {stamp.bytes, stamp.changedNs + 1}));
    CHECK(!place.open().find(place.data / "b", stamp));
    CHECK(place.open().find(place.data / "a", stamp));
}

TEST_CASE("Another version of the reader, or another library, does not trust the cache") {
    Place place;
    const HeaderStamp stamp = place.write("a", "1");
    HeaderCache cache = place.open();
    cache.put(place.data / "a", stamp, described(0.0));
    cache.save();
    place.reader.version = "1.1";
    CHECK(!place.open().find(place.data / "a", stamp));
    place.reader.version = "1.0";
    CHECK(place.open().find(place.data / "a", stamp));
    place.write("reader.so", "code");
    place.reader.library = place.data / "reader.so";
    CHECK(!place.open().find(place.data / "a", stamp));
}

TEST_CASE("Files that are gone are dropped when the cache is written") {
    const Place place;
    const HeaderStamp a = place.write("a", "1"), b = place.write("b", "1");
    HeaderCache cache = place.open();
    cache.put(place.data / "a", a, described(0.0));
    std::filesystem::remove(place.data / "a");
    cache.put(place.data / "b", b, described(1.0));
    cache.save();
    CHECK(!place.open().find(place.data / "a", a));
    CHECK(place.open().find(place.data / "b", b));
}

TEST_CASE("A damaged cache file counts as empty, whichever byte is wrong, and is written again") {
    const Place place;
    const HeaderStamp stamp = place.write("a", "1");
    HeaderCache cache = place.open();
    cache.put(place.data / "a", stamp, described(7.0));
    cache.save();
    const std::filesystem::path file = place.onlyCacheFile();
    std::ifstream in(file);
    const std::string good{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        std::ofstream(file) << bad;
        CHECK(!place.open().find(place.data / "a", stamp));
        std::ofstream(file) << good.substr(0, i);
        CHECK(!place.open().find(place.data / "a", stamp));
    }
    std::ofstream(file) << "[]";
    HeaderCache again = place.open();
    again.put(place.data / "a", stamp, described(8.0));
    again.save();
    CHECK(place.open().find(place.data / "a", stamp)->times[0].seconds == 8.0);
}

TEST_CASE("Without a folder for it, or in one that cannot be written, the cache is silent") {
    const Place place;
    const HeaderStamp stamp = place.write("a", "1");
    for (const std::filesystem::path folder : {"", "/proc/nowhere"}) {
        HeaderCache cache(folder, place.data.path(), place.reader);
        cache.put(place.data / "a", stamp, described(0.0));
        cache.save();
        CHECK(!HeaderCache(folder, place.data.path(), place.reader).find(place.data / "a", stamp));
    }
}

TEST_CASE("No more than 64 folders are remembered") {
    const TemporaryFolder cacheFolder;
    for (int i = 0; i < 70; ++i) {
        const Place place;
        HeaderCache cache(cacheFolder.path(), place.data.path(), place.reader);
        cache.put(place.data / "a", place.write("a", "1"), described(0.0));
        cache.save();
    }
    const auto files = std::filesystem::directory_iterator(cacheFolder.path());
    CHECK(std::distance(begin(files), end(files)) == 64);
}
