// make_big_wrfout.cpp: makes a large wrfout file from a small one, for measurements.
//
// Repeats the fields in x and y and interpolates them to more levels, linearly in the level index.
// Output is as WRF writes it: 64-bit offset, or NetCDF-4 with deflate and default chunks. Build it
// with `cmake --build build/dev --target make_big_wrfout`.
#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr std::array<const char*, 11> kFields{"PH",     "PHB",   "P",    "PB",    "T",     "QVAPOR",
                                              "QCLOUD", "QRAIN", "QICE", "QSNOW", "QGRAUP"};
constexpr int kTimeLength = 19;

void require(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

struct Sizes {
    std::size_t x = 0, y = 0, z = 0;
};

std::size_t lengthOf(int file, const char* dimension) {
    int id = -1;
    std::size_t length = 0;
    require(nc_inq_dimid(file, dimension, &id));
    require(nc_inq_dimlen(file, id, &length));
    return length;
}

bool onInterfaces(std::string_view name) {
    return name == "PH" || name == "PHB";
}

std::vector<float> readField(int file, int id, Sizes size) {
    std::vector<float> values(size.x * size.y * size.z);
    const std::array<std::size_t, 4> start{0, 0, 0, 0};
    const std::array<std::size_t, 4> count{1, size.z, size.y, size.x};
    require(nc_get_vara_float(file, id, start.data(), count.data(), values.data()));
    return values;
}

/// Level `z` of `to.z`: interpolated between two levels of `field`, repeated in x and y.
std::vector<float> tiledPlane(const std::vector<float>& field, Sizes from, Sizes to,
                              std::size_t z) {
    const double level =
        static_cast<double>(z) * static_cast<double>(from.z - 1) / static_cast<double>(to.z - 1);
    const auto below = static_cast<std::size_t>(level);
    const std::size_t above = below + 1 < from.z ? below + 1 : below;
    const auto share = static_cast<float>(level - static_cast<double>(below));
    std::vector<float> plane;
    plane.reserve(to.x * to.y);
    for (std::size_t y = 0; y < to.y; ++y) {
        const float* lower = field.data() + (below * from.y + y % from.y) * from.x;
        const float* upper = field.data() + (above * from.y + y % from.y) * from.x;
        for (std::size_t x = 0; x < to.x; ++x) {
            const std::size_t i = x % from.x;
            plane.push_back(lower[i] + share * (upper[i] - lower[i]));
        }
    }
    return plane;
}

void copyGlobals(int from, int to) {
    int count = 0;
    require(nc_inq_natts(from, &count));
    for (int i = 0; i < count; ++i) {
        std::array<char, NC_MAX_NAME + 1> name{};
        require(nc_inq_attname(from, NC_GLOBAL, i, name.data()));
        require(nc_copy_att(from, NC_GLOBAL, name.data(), to, NC_GLOBAL));
    }
}

/// Defines dimensions and variables. Returns the ids of the fields in order, then that of Times.
std::vector<int> define(int from, int to, Sizes size, bool netcdf4) {
    int time = -1, text = -1, x = -1, y = -1, z = -1, zStag = -1;
    require(nc_def_dim(to, "Time", NC_UNLIMITED, &time));
    require(nc_def_dim(to, "DateStrLen", kTimeLength, &text));
    require(nc_def_dim(to, "west_east", size.x, &x));
    require(nc_def_dim(to, "south_north", size.y, &y));
    require(nc_def_dim(to, "bottom_top", size.z, &z));
    require(nc_def_dim(to, "bottom_top_stag", size.z + 1, &zStag));
    std::vector<int> ids;
    for (const char* name : kFields) {
        const std::array<int, 4> axes{time, onInterfaces(name) ? zStag : z, y, x};
        ids.push_back(-1);
        require(nc_def_var(to, name, NC_FLOAT, 4, axes.data(), &ids.back()));
        if (netcdf4) require(nc_def_var_deflate(to, ids.back(), 1, 1, 2));
    }
    const std::array<int, 2> axes{time, text};
    ids.push_back(-1);
    require(nc_def_var(to, "Times", NC_CHAR, 2, axes.data(), &ids.back()));
    copyGlobals(from, to);
    require(nc_enddef(to));
    return ids;
}

void make(const char* source, const char* target, Sizes to, bool netcdf4) {
    int in = -1, out = -1;
    require(nc_open(source, NC_NOWRITE, &in));
    require(nc_create(
        target, NC_CLOBBER | (netcdf4 ? NC_NETCDF4 | NC_CLASSIC_MODEL : NC_64BIT_OFFSET), &out));
    const std::vector<int> ids = define(in, out, to, netcdf4);
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        const std::size_t extra = onInterfaces(kFields[i]) ? 1 : 0;
        const Sizes from{lengthOf(in, "west_east"), lengthOf(in, "south_north"),
                         lengthOf(in, "bottom_top") + extra};
        const Sizes size{to.x, to.y, to.z + extra};
        int id = -1;
        require(nc_inq_varid(in, kFields[i], &id));
        const std::vector<float> field = readField(in, id, from);
        for (std::size_t z = 0; z < size.z; ++z) {
            const std::array<std::size_t, 4> start{0, z, 0, 0};
            const std::array<std::size_t, 4> count{1, 1, size.y, size.x};
            const std::vector<float> plane = tiledPlane(field, from, size, z);
            require(nc_put_vara_float(out, ids[i], start.data(), count.data(), plane.data()));
        }
    }
    std::array<char, kTimeLength> time{};
    int times = -1;
    const std::array<std::size_t, 2> start{0, 0};
    const std::array<std::size_t, 2> count{1, kTimeLength};
    require(nc_inq_varid(in, "Times", &times));
    require(nc_get_vara_text(in, times, start.data(), count.data(), time.data()));
    require(nc_put_vara_text(out, ids.back(), start.data(), count.data(), time.data()));
    require(nc_close(out));
    require(nc_close(in));
}

}  // namespace

int main(int count, char** words) {
    if (count != 6 && count != 7) {
        fmt::print(stderr, "usage: make_big_wrfout WRFOUT TARGET NX NY NZ [netcdf4]\n");
        return 2;
    }
    const auto number = [&](int i) { return std::strtoull(words[i], nullptr, 10); };
    try {
        make(words[1], words[2], {number(3), number(4), number(5)}, count == 7);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "error: {}\n", problem.what());
        return 1;
    }
    return 0;
}
