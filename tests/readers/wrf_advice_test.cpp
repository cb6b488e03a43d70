// wrf_advice_test.cpp: NetCDF files of other programs, or without what is drawn, are recognised,
// and the advice fits them.
#include <doctest/doctest.h>
#include <netcdf.h>

#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// A NetCDF-3 file with dimensions, one variable on the first of them, and one global attribute.
struct Foreign {
    const char* kind;  ///< what the message must say
    const char* hint;
    std::vector<const char*> dimensions;
    std::vector<const char*> variables;
    const char* attribute;
    const char* text;
};

void write(const std::filesystem::path& path, const Foreign& foreign) {
    int file = -1;
    REQUIRE(nc_create(path.c_str(), NC_CLOBBER, &file) == NC_NOERR);
    std::vector<int> ids;
    for (const char* name : foreign.dimensions) {
        int id = -1;
        nc_def_dim(file, name, 3, &id);
        ids.push_back(id);
    }
    for (const char* name : foreign.variables) {
        int id = -1;
        nc_def_var(file, name, NC_FLOAT, 1, ids.data(), &id);
    }
    if (foreign.attribute != nullptr) {
        nc_put_att_text(file, NC_GLOBAL, foreign.attribute, std::string_view(foreign.text).size(),
                        foreign.text);
    }
    REQUIRE(nc_close(file) == NC_NOERR);
}

}  // namespace

TEST_CASE("NetCDF files of other programs are named, with a step for their owner") {
    const TemporaryFolder folder;
    for (const Foreign& foreign : {
             Foreign{"met_em", "wrfout", {"num_metgrid_levels", "west_east"}, {}, nullptr, nullptr},
             Foreign{"geo_em",
                     "wrfout",
                     {"west_east", "south_north"},
                     {"LU_INDEX"},
                     "TITLE",
                     "OUTPUT FROM GEOGRID V4.3"},
             Foreign{"wrfbdy", "wrfout", {"bdy_width", "west_east"}, {}, nullptr, nullptr},
             Foreign{"without levels",
                     "3-D fields",
                     {"west_east", "south_north"},
                     {"T2"},
                     nullptr,
                     nullptr},
             Foreign{"CM1", "3-D fields", {"xh", "yh", "zh"}, {"qc"}, nullptr, nullptr},
             Foreign{"PALM", "3-D fields", {"zu_3d", "x", "y"}, {}, nullptr, nullptr},
             Foreign{"DALES", "3-D fields", {"xt", "yt", "zt"}, {"ql"}, nullptr, nullptr},
             Foreign{"MONC", "3-D fields", {"x", "y"}, {"options_database"}, nullptr, nullptr},
             Foreign{"SAM", "3-D fields", {"x", "y", "z"}, {"QN", "TABS"}, nullptr, nullptr},
             Foreign{"ICON", "remapcon", {"ncells", "height"}, {}, nullptr, nullptr},
             Foreign{"MPAS", "convert_mpas", {"nCells", "nVertLevels"}, {}, nullptr, nullptr},
             Foreign{"MicroHH", "3-D fields", {"x", "y", "z"}, {"ql"}, nullptr, nullptr},
             Foreign{"nudging", "wrfout", {"west_east"}, {"U_NDG_OLD"}, nullptr, nullptr},
             Foreign{"latitude and longitude",
                     "nephoscope-brick",
                     {"latitude", "longitude", "level"},
                     {"t"},
                     nullptr,
                     nullptr},
             Foreign{
                 "neither WRF output", "nephoscope-map", {"lat", "lon"}, {"tas"}, nullptr, nullptr},
         }) {
        CAPTURE(foreign.kind);
        write(folder / "a.nc", foreign);
        const ErrorParts error = errorOf([&] { openFiles({folder / "a.nc"}); });
        CHECK(contains(error.what, foreign.kind));
        CHECK(contains(error.hint, foreign.hint));
        CHECK(!contains(error.hint, "copy it again"));
        CHECK(contains(error.found, foreign.dimensions.front()));
    }
}
