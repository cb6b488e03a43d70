// grib_supercell_test.cpp: the bundled storm, written as GRIB2 on HRRR's levels and parameters, has
// the air and the condensate that the WRF reader finds in the wrfout.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/readers/grib_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

const std::filesystem::path kStorm = std::filesystem::path(NEPH_TEST_SOURCE_DIR) /
                                     "samples/supercell/wrfout_d01_0001-01-01_01:30:00";

/// Every third column of the wrfout, as functions of GRIB's cells.
struct Storm {
    static constexpr int kStep = 3;
    std::shared_ptr<Dataset> wrf = openFiles({kStorm});
    Array3f heights = wrf->read("interface_height", 0);

    GribFunction stored(const char* name) const {
        return [field = std::make_shared<Array3f>(wrf->read(name, 0))](int x, int y, int z, int) {
            return static_cast<double>(field->at(kStep * x, kStep * y, z));
        };
    }
    double centreM(int x, int y, int z) const {
        return 0.5 * (static_cast<double>(heights.at(kStep * x, kStep * y, z)) +
                      static_cast<double>(heights.at(kStep * x, kStep * y, z + 1)));
    }
    GribSpec spec() const {
        GribSpec spec;
        const glm::ivec3 size = wrf->info().size;
        spec.nx = (size.x + kStep - 1) / kStep;
        spec.ny = (size.y + kStep - 1) / kStep;
        spec.nz = size.z;
        spec.packing = "complex";
        spec.bits = 24;
        spec.fields["PRES"] = stored("air_pressure");
        spec.fields["TMP"] = stored("air_temperature");
        spec.fields["SPFH"] = [vapour = stored("QVAPOR")](int x, int y, int z, int t) {
            const double q = vapour(x, y, z, t);
            return q / (1.0 + q);
        };
        spec.fields["HGT"] = [this](int x, int y, int z, int) { return centreM(x, y, z); };
        for (const auto& pair : kPairs) spec.fields[pair[1]] = stored(pair[0]);
        spec.ground["HGT"] = [this](int x, int y, int, int) {
            return static_cast<double>(heights.at(kStep * x, kStep * y, 0));
        };
        return spec;
    }
    static constexpr std::array<std::array<const char*, 2>, 5> kPairs{{{"QCLOUD", "CLMR"},
                                                                       {"QICE", "CIMIXR"},
                                                                       {"QRAIN", "RWMR"},
                                                                       {"QSNOW", "SNMR"},
                                                                       {"QGRAUP", "GRLE"}}};
};

/// Content of all columns together in kg/m², of every `step`-th native column.
double totalOf(Dataset& dataset, const char* name, int step) {
    const Array3f q = dataset.read(name, 0), density = dataset.read("dry_air_density", 0);
    const Array3f z = dataset.read("interface_height", 0);
    double sum = 0.0;
    for (int k = 0; k < q.size.z; ++k) {
        for (int y = 0; y < q.size.y; y += step) {
            for (int x = 0; x < q.size.x; x += step) {
                const double depth =
                    static_cast<double>(z.at(x, y, k + 1)) - static_cast<double>(z.at(x, y, k));
                sum += static_cast<double>(q.at(x, y, k)) *
                       static_cast<double>(density.at(x, y, k)) * depth;
            }
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("The bundled storm as GRIB2 has the air and the columns of the wrfout") {
    const TemporaryFolder folder;
    const Storm storm;
    writeGrib(folder / "storm.grib2", storm.spec());
    const auto grib = openFiles({folder / "storm.grib2"});
    const Array3f there = storm.wrf->read("dry_air_density", 0);
    const Array3f here = grib->read("dry_air_density", 0);
    const Array3f heights = grib->read("interface_height", 0);
    double density = 0.0, height = 0.0;
    for (int k = 0; k < here.size.z; ++k) {
        for (int y = 0; y < here.size.y; ++y) {
            for (int x = 0; x < here.size.x; ++x) {
                const int u = Storm::kStep * x, v = Storm::kStep * y;
                density = std::max(density, std::abs(static_cast<double>(here.at(x, y, k)) /
                                                         static_cast<double>(there.at(u, v, k)) -
                                                     1.0));
                const double halfway =
                    k == 0 ? static_cast<double>(storm.heights.at(u, v, 0))
                           : 0.5 * (storm.centreM(x, y, k - 1) + storm.centreM(x, y, k));
                height =
                    std::max(height, std::abs(static_cast<double>(heights.at(x, y, k)) - halfway));
            }
        }
    }
    // 24 bits over the range of pressure are 0.006 Pa, 1e-6 of the least of 5 kPa.
    CHECK(density < 3e-6);
    CHECK(height < 2e-3);  // a step of single precision at 16 km
    // Interfaces halfway between centres are up to 6 m off the model's, where layers become deeper.
    for (const auto& pair : Storm::kPairs) {
        CAPTURE(pair[1]);
        const double wrf = totalOf(*storm.wrf, pair[0], Storm::kStep);
        const double ours = totalOf(*grib, pair[1], 1);
        CHECK(wrf > 10.0);
        CHECK(ours == doctest::Approx(wrf).epsilon(5e-4));
    }
}
