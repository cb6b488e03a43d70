// nc_filters.cpp: ids of filters, as registered with the HDF Group.
#include "readers/netcdf/nc_filters.h"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_filter.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace nc {
namespace {

struct Filter {
    unsigned id;
    std::string_view name;
};
constexpr unsigned kDeflate = 1, kShuffle = 2;
constexpr std::array kRegistered{
    Filter{4, "szip"},
    Filter{307, "bzip2"},
    Filter{32000, "LZF"},
    Filter{32001, "Blosc"},
    Filter{32004, "LZ4"},
    Filter{32008, "bitshuffle"},
    Filter{32013, "ZFP"},
    Filter{32015, "Zstandard"},
    Filter{32017, "SZ"},
    Filter{32022, "BitGroom"},
    Filter{32023, "Granular BitRound"},
    Filter{32024, "SZ3"},
    Filter{32026, "Blosc2"},
};

}  // namespace

std::optional<std::string> missingFilter(int file, int variable) {
    std::size_t count = 0;
    if (nc_inq_var_filter_ids(file, variable, &count, nullptr) != NC_NOERR) return {};
    std::vector<unsigned> ids(count);
    if (nc_inq_var_filter_ids(file, variable, &count, ids.data()) != NC_NOERR) return {};
    for (const unsigned id : ids) {
        if (nc_inq_filter_avail(file, id) == NC_NOERR) continue;
        const auto known = std::ranges::find(kRegistered, id, &Filter::id);
        return fmt::format("{} (id {})", known == kRegistered.end() ? "a filter" : known->name, id);
    }
    return {};
}

bool onlyDeflated(int file, int variable) {
    int shuffled = 0, deflated = 0, checksums = 0;
    std::size_t count = 0;
    if (nc_inq_var_deflate(file, variable, &shuffled, &deflated, nullptr) != NC_NOERR ||
        nc_inq_var_fletcher32(file, variable, &checksums) != NC_NOERR ||
        nc_inq_var_filter_ids(file, variable, &count, nullptr) != NC_NOERR) {
        return false;
    }
    std::vector<unsigned> ids(count);
    if (nc_inq_var_filter_ids(file, variable, &count, ids.data()) != NC_NOERR) return false;
    const bool others =
        std::ranges::any_of(ids, [](unsigned id) { return id != kDeflate && id != kShuffle; });
    return deflated != 0 && checksums == 0 && !others;
}

std::string filterHint() {
    return "where the file can be read, write it with zlib: h5repack -f GZIP=1 IN OUT, or nccopy "
           "-d1 "
           "IN OUT; or install the filter's plugin here (Debian: hdf5-filter-plugin, "
           "hdf5-plugin-lzf) "
           "and name its folder in HDF5_PLUGIN_PATH";
}

}  // namespace nc
