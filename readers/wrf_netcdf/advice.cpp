// advice.cpp: models and programs, recognised by what their files have and others do not.
#include "readers/wrf_netcdf/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "readers/wrf_netcdf/axes.h"

namespace wrf {
namespace {

constexpr const char* kBrick =
    "write its hydrometeors, heights and density as plain numbers (numpy's tofile) with a "
    "nephoscope-brick sidecar: docs/raw-les.md";
constexpr const char* kWrfout = "open the wrfout files that wrf.exe writes";
constexpr const char* kIconStep =
    "remap it to an even grid (cdo remapcon), then write its fields as numbers with a "
    "nephoscope-brick sidecar: docs/raw-les.md";

/// A kind of file, by its marks: all that are given must be there.
struct Kind {
    const char* is;
    const char* hint;
    std::array<const char*, 4> dimensions{};  ///< all of them
    std::array<const char*, 3> variables{};   ///< one of them
    const char* attribute = nullptr;          ///< global
    const char* text = nullptr;               ///< in that attribute
};
constexpr std::array kKinds{
    Kind{.is = "is input of real.exe (met_em) and holds no model output",
         .hint = kWrfout,
         .dimensions = {"num_metgrid_levels"}},
    Kind{.is = "is static geography (geo_em) and holds no model output",
         .hint = kWrfout,
         .variables = {"LU_INDEX"},
         .attribute = "TITLE",
         .text = "GEOGRID"},
    Kind{.is = "is a file of analysis nudging (wrffdda)",
         .hint = kWrfout,
         .variables = {"U_NDG_OLD", "U_NDG_NEW"}},
    Kind{.is = "is a file of lateral boundaries (wrfbdy)",
         .hint = kWrfout,
         .dimensions = {"bdy_width"}},
    Kind{
        .is = "is ICON output on its triangular grid", .hint = kIconStep, .dimensions = {"ncells"}},
    Kind{.is = "is ICON output", .hint = kIconStep, .attribute = "number_of_grid_used"},
    Kind{.is = "is MPAS output on its hexagonal grid",
         .hint = "remap it to an even grid (convert_mpas), then write its fields as numbers with a "
                 "nephoscope-brick sidecar: docs/raw-les.md",
         .dimensions = {"nCells", "nVertLevels"}},
    Kind{.is = "is FV3 (UFS) output, which is not read yet",
         .hint = kBrick,
         .dimensions = {"grid_xt", "grid_yt"}},
    Kind{.is = "is COSMO output, which is not read yet",
         .hint = kBrick,
         .dimensions = {"rlon", "rlat", "level"}},
    Kind{.is = "is a restart file of RAMS or BRAMS, which is not read",
         .hint = kBrick,
         .variables = {"RCP", "RRP", "THP"}},
    Kind{.is = "holds data on pressure levels (a reanalysis or an analysis)",
         .hint = kBrick,
         .dimensions = {"pressure_level"}},
    Kind{.is = "holds data on pressure levels (a reanalysis or an analysis)",
         .hint = kBrick,
         .dimensions = {"isobaricInhPa"}},
    Kind{.is = "holds data on a grid of latitude and longitude",
         .hint = kBrick,
         .dimensions = {"latitude", "longitude", "level"}},
};

bool matches(const Kind& kind, const NcFile& file) {
    bool any = false;
    for (const char* name : kind.dimensions) {
        if (name == nullptr) continue;
        if (file.dimension(name) == nullptr) return false;
        any = true;
    }
    bool wanted = false;
    bool found = false;
    for (const char* name : kind.variables) {
        if (name == nullptr) continue;
        wanted = true;
        const auto same = std::ranges::find(file.variables(), name, &NcVariable::name);
        found = found || same != file.variables().end();
    }
    if (wanted && !found) return false;
    if (kind.attribute != nullptr) {
        const auto text = file.text(kind.attribute);
        if (!text && !file.number(kind.attribute)) return false;
        if (kind.text != nullptr && (!text || text->find(kind.text) == std::string::npos)) {
            return false;
        }
    }
    return any || wanted || kind.attribute != nullptr;
}

const Kind* kindOf(const NcFile& file) {
    const auto found =
        std::ranges::find_if(kKinds, [&](const Kind& kind) { return matches(kind, file); });
    return found == kKinds.end() ? nullptr : &*found;
}

bool hasVariable(const NcFile& file, const char* name) {
    return std::ranges::find(file.variables(), name, &NcVariable::name) != file.variables().end();
}

}  // namespace

bool isForeign(const NcFile& file) {
    return kindOf(file) != nullptr;
}

bool hasWrfNames(const NcFile& file) {
    constexpr std::array kNames{"PH", "PHB", "PB", "QVAPOR", "QCLOUD", "QRAIN", "QICE", "PH_2"};
    return file.text("TITLE").value_or("").find("WRF") != std::string::npos ||
           std::ranges::any_of(kNames, [&](const char* name) { return hasVariable(file, name); });
}

Failure adviceFor(const NcFile& file) {
    constexpr const char* kExpected =
        "fields on (Time, bottom_top, south_north, west_east): heights, pressure, temperature, Q…";
    const std::string found = "dimensions " + listOf(file.dimensions());
    if (const Kind* kind = kindOf(file)) return Failure{kind->is, found, kExpected, kind->hint};
    const bool flat =
        file.dimension("west_east") != nullptr && file.dimension("south_north") != nullptr;
    if (flat) {
        return Failure{"is WRF output without levels: it holds surface and 2-D fields only", found,
                       kExpected, "open the history files with the 3-D fields, wrfout_d…"};
    }
    const bool phony = std::ranges::any_of(file.dimensions(), [](const NcDimension& dimension) {
        return dimension.name.starts_with("phony_dim_");
    });
    if (phony) {
        return Failure{"is an HDF5 file without the dimensions of NetCDF-4", found, kExpected,
                       kBrick};
    }
    return Failure{
        "is a NetCDF file, but neither WRF output nor that of an LES model that is known", found,
        "dimensions west_east, south_north, bottom_top, bottom_top_stag and variables PH, "
        "PHB, P, PB, T, Q…, or what docs/readers.md lists for other models",
        fmt::format("say what its variables are in a nephoscope-map beside it (docs/readers.md), "
                    "or {}",
                    kBrick)};
}

std::string kindNote(const NcFile& file) {
    if (!hasVariable(file, "PH") && hasVariable(file, "PH_2")) {
        return "This is a restart file (wrfrst): of its two time levels the present one is shown.";
    }
    if (file.text("TITLE").value_or("").find("REAL_EM") != std::string::npos) {
        return "This is an initial state (wrfinput): the model has not run yet, and hydrometeors "
               "may "
               "be zero.";
    }
    return {};
}

}  // namespace wrf
