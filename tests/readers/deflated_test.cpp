// deflated_test.cpp: chunks of NetCDF-4 files that deflate has compressed.
#include <doctest/doctest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include "readers/netcdf/deflated_floats.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// 12 x 11 x 10 cells of two times in chunks that divide none of these.
WrfSpec chunkedSpec(bool shuffled) {
    WrfSpec spec;
    spec.format = NetcdfFormat::netcdf4;
    spec.nx = 12;
    spec.ny = 11;
    spec.nz = 10;
    spec.times = {"0001-01-01_00:00:00", "0001-01-01_00:10:00"};
    spec.fields["QCLOUD"] = [](int x, int y, int z, int t) {
        return x == 5 && y == 6 && z == 7 ? std::nanf("") : marked(x, y, z, t);
    };
    spec.chunk = {4, 5, 7};
    spec.shuffled = shuffled;
    return spec;
}

/// Whether every bit is the same, so that NaN equals NaN.
bool sameBits(const Array3f& a, const Array3f& b) {
    return a.size == b.size &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

int openedWithNetcdf(const std::filesystem::path& path) {
    int file = -1;
    REQUIRE(nc_open(path.c_str(), NC_NOWRITE, &file) == NC_NOERR);
    return file;
}

/// The variable QCLOUD of a file of chunkedSpec(), opened as readers do and read without NetCDF.
struct OpenCloud {
    explicit OpenCloud(const std::filesystem::path& path)
        : netcdf(openedWithNetcdf(path)),
          file(nc::DeflatedFloats::fileOf(path.string())),
          floats(nc::DeflatedFloats::of(file, "QCLOUD", shape, chunk)) {}
    ~OpenCloud() {
        floats.reset();
        H5Fclose(file);
        nc_close(netcdf);
    }
    OpenCloud(const OpenCloud&) = delete;
    OpenCloud& operator=(const OpenCloud&) = delete;

    static constexpr std::array<std::size_t, 4> shape{2, 10, 11, 12}, chunk{1, 4, 5, 7};
    int netcdf;  ///< HDF5 refuses some ways of opening a file that NetCDF has open
    hid_t file;
    std::unique_ptr<nc::DeflatedFloats> floats;
};

}  // namespace

TEST_CASE("Boxes across compressed chunks have the values of a file that is not compressed") {
    for (const bool shuffled : {true, false}) {
        const TemporaryFolder folder;
        WrfSpec spec = chunkedSpec(shuffled);
        writeWrf(folder / "deflated", spec);
        spec.format = NetcdfFormat::classic;
        writeWrf(folder / "classic", spec);
        const auto deflated = openFiles({folder / "deflated"});
        const auto classic = openFiles({folder / "classic"});
        CHECK(deflated->info().rowsTogether == 5);
        CHECK(classic->info().rowsTogether < 2);
        for (const CellBox& box :
             {CellBox{{0, 0, 0}, {12, 11, 10}}, CellBox{{0, 0, 0}, {12, 3, 10}},
              CellBox{{0, 3, 0}, {12, 6, 10}}, CellBox{{6, 4, 3}, {8, 11, 9}},
              CellBox{{11, 10, 9}, {12, 11, 10}}, CellBox{{0, 0, 0}, {1, 1, 1}}}) {
            for (const char* name : {"QCLOUD", "interface_height", "dry_air_density"}) {
                for (const int time : {1, 0}) {
                    CAPTURE(name);
                    CHECK(
                        sameBits(deflated->read(name, time, box), classic->read(name, time, box)));
                }
            }
        }
    }
}

TEST_CASE("Bands from south to north inflate every chunk once and hold two rows of chunks") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", chunkedSpec(true));
    OpenCloud cloud(folder / "a");
    REQUIRE(cloud.floats != nullptr);
    std::multiset<std::size_t> inflated;
    std::vector<float> values(10 * 3 * 12);
    // Two threads, each a band behind the other, ask for bands of three rows.
    for (const std::size_t y : {0U, 3U, 0U, 6U, 3U, 8U, 6U, 8U}) {
        const std::array<std::size_t, 4> start{0, 0, y, 0}, count{1, 10, 3, 12};
        const auto chunks = cloud.floats->fetch(start, count);
        REQUIRE(chunks);
        for (const auto& chunk : *chunks) inflated.insert(chunk.index);
        REQUIRE(cloud.floats->inflate(*chunks));
        cloud.floats->copy(start, count, values);
        CHECK(values[12] == marked(0, static_cast<int>(y) + 1, 0, 0));
    }
    CHECK(inflated.size() == 3 * 3 * 2);
    CHECK(std::set<std::size_t>(inflated.begin(), inflated.end()).size() == inflated.size());
    // Two of three rows of six chunks are held: one of three times two has to be fetched again.
    const std::array<std::size_t, 4> start{0, 0, 0, 0}, count{1, 10, 11, 12};
    const auto again = cloud.floats->fetch(start, count);
    REQUIRE(again);
    CHECK(again->size() == 6);
}

TEST_CASE("A damaged compressed chunk is an error that names the variable") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", chunkedSpec(true));
    std::vector<std::byte> stored;
    {
        OpenCloud cloud(folder / "a");
        REQUIRE(cloud.floats != nullptr);
        const std::array<std::size_t, 4> start{0, 4, 5, 7}, one{1, 1, 1, 1};
        stored = cloud.floats->fetch(start, one)->front().bytes;
    }
    std::string bytes;
    {
        std::ifstream file(folder / "a", std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    const std::string_view chunk(reinterpret_cast<const char*>(stored.data()), stored.size());
    const std::size_t at = bytes.find(chunk);
    REQUIRE(at != std::string::npos);
    bytes[at + chunk.size() - 1] ^= 1;  // the checksum
    std::ofstream(folder / "a", std::ios::binary) << bytes;
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->read("QCLOUD", 0, CellBox{{0, 0, 0}, {7, 5, 4}}).values.front() ==
          marked(0, 0, 0, 0));
    const ErrorParts error = errorOf([&] { dataset->read("QCLOUD", 0); });
    CHECK(error.what == "variable QCLOUD cannot be read: NetCDF: HDF error");
    CHECK(error.hint == "the file is damaged: copy it again, or leave this time out");
}
