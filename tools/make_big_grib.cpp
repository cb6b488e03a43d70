// make_big_grib.cpp: makes a GRIB2 file as large as one of HRRR from a small wrfout, for
// measurements.
//
// Repeats the fields in x and y and interpolates them to more levels, linearly in the level index;
// complex packing with second differences, as NCEP packs. Build it with `cmake --build build/dev
// --target make_big_grib`.
#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/readers/grib_maker.h"

namespace {

void require(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

struct Small {
    std::array<std::size_t, 3> size{};  ///< x, y, z
    std::map<std::string, std::vector<float>> fields;

    double at(const char* name, std::size_t cell) const {
        return static_cast<double>(fields.at(name)[cell]);
    }
    /// The quantity that GRIB stores, by its NCEP name.
    double value(const std::string& name, std::size_t cell) const {
        const std::size_t layer = size[0] * size[1];
        const double p = at("P", cell) + at("PB", cell);
        if (name == "PRES") return p;
        if (name == "TMP") return (at("T", cell) + 300.0) * std::pow(p / 1e5, 2.0 / 7.0);
        if (name == "SPFH") return at("QVAPOR", cell) / (1.0 + at("QVAPOR", cell));
        if (name == "HGT") {
            return (at("PH", cell) + at("PHB", cell) + at("PH", cell + layer) +
                    at("PHB", cell + layer)) /
                   (2.0 * 9.81);
        }
        static const std::map<std::string, const char*> sources{{"CLMR", "QCLOUD"},
                                                                {"CIMIXR", "QICE"},
                                                                {"RWMR", "QRAIN"},
                                                                {"SNMR", "QSNOW"},
                                                                {"GRLE", "QGRAUP"}};
        return at(sources.at(name), cell);
    }
};

Small readSmall(const char* path) {
    Small small;
    int file = -1;
    require(nc_open(path, NC_NOWRITE, &file));
    constexpr std::array kAxes{"west_east", "south_north", "bottom_top"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        int id = -1;
        require(nc_inq_dimid(file, kAxes[axis], &id));
        require(nc_inq_dimlen(file, id, &small.size[axis]));
    }
    for (const char* name :
         {"PH", "PHB", "P", "PB", "T", "QVAPOR", "QCLOUD", "QICE", "QRAIN", "QSNOW", "QGRAUP"}) {
        int id = -1;
        require(nc_inq_varid(file, name, &id));
        const bool faces = name[0] == 'P' && name[1] == 'H';
        const std::array<std::size_t, 4> start{0, 0, 0, 0};
        const std::array<std::size_t, 4> count{1, small.size[2] + (faces ? 1 : 0), small.size[1],
                                               small.size[0]};
        std::vector<float>& values = small.fields[name];
        values.resize(count[1] * count[2] * count[3]);
        require(nc_get_vara_float(file, id, start.data(), count.data(), values.data()));
    }
    require(nc_close(file));
    return small;
}

void makeBig(const char* from, const char* to, const GribSpec& size) {
    const Small small = readSmall(from);
    GribSpec spec = size;
    for (const char* name :
         {"HGT", "PRES", "TMP", "SPFH", "CLMR", "CIMIXR", "RWMR", "SNMR", "GRLE"}) {
        spec.fields[name] = [&small, &spec, text = std::string(name)](int x, int y, int z, int) {
            const double level = static_cast<double>(z) * static_cast<double>(small.size[2] - 1) /
                                 static_cast<double>(spec.nz - 1);
            const auto below = static_cast<std::size_t>(level);
            const std::size_t above = std::min(below + 1, small.size[2] - 1);
            const std::size_t column = static_cast<std::size_t>(y) % small.size[1] * small.size[0] +
                                       static_cast<std::size_t>(x) % small.size[0];
            const std::size_t layer = small.size[0] * small.size[1];
            const double lower = small.value(text, below * layer + column);
            const double upper = small.value(text, above * layer + column);
            return lower + (level - static_cast<double>(below)) * (upper - lower);
        };
    }
    writeGrib(to, spec);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 6) {
        fmt::print(stderr, "use: make_big_grib WRFOUT OUT NX NY NZ [PACKING of ecCodes]\n");
        return 2;
    }
    GribSpec spec;
    spec.nx = std::atoi(argv[3]);
    spec.ny = std::atoi(argv[4]);
    spec.nz = std::atoi(argv[5]);
    spec.packing = argc > 6 ? argv[6] : "complex";
    spec.ground["HGT"] = [](int, int, int, int) { return 0.0; };
    try {
        makeBig(argv[1], argv[2], spec);
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_big_grib: {}\n", error.what());
        return 1;
    }
    return 0;
}
