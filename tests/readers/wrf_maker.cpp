// wrf_maker.cpp: writes files as WRF does, with NetCDF-C.
#include "tests/readers/wrf_maker.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace {

void require(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

struct Axes {
    int time = -1, x = -1, y = -1, z = -1, xStag = -1, zStag = -1, text = -1;
};

int modeOf(NetcdfFormat format, bool severalUnlimited) {
    if (severalUnlimited) return NC_CLOBBER | NC_NETCDF4;
    switch (format) {
        case NetcdfFormat::classic:
            return NC_CLOBBER;
        case NetcdfFormat::offset64:
            return NC_CLOBBER | NC_64BIT_OFFSET;
        case NetcdfFormat::netcdf4:
            return NC_CLOBBER | NC_NETCDF4 | NC_CLASSIC_MODEL;
    }
    return NC_CLOBBER;
}

void defineAttributes(int file, const WrfSpec& spec) {
    const auto wanted = [&](const char* name) { return !spec.omit.contains(name); };
    const auto text = [&](const char* name, const std::string& value) {
        if (wanted(name))
            require(nc_put_att_text(file, NC_GLOBAL, name, value.size(), value.data()));
    };
    const auto real = [&](const char* name, float value) {
        if (wanted(name)) require(nc_put_att_float(file, NC_GLOBAL, name, NC_FLOAT, 1, &value));
    };
    const auto whole = [&](const char* name, int value) {
        if (wanted(name)) require(nc_put_att_int(file, NC_GLOBAL, name, NC_INT, 1, &value));
    };
    text("TITLE", spec.title);
    real("DX", spec.dx);
    real("DY", spec.dy);
    whole("MP_PHYSICS", spec.mpPhysics);
    whole("MAP_PROJ", spec.mapProjection);
}

std::vector<std::string> fieldNames(const WrfSpec& spec) {
    std::vector<std::string> names{"PH", "PHB", "P", "PB", "T", "QVAPOR", "QCLOUD", "QRAIN", "U"};
    for (const auto& [name, function] : spec.fields) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::erase_if(names, [&](const std::string& name) { return spec.omit.contains(name); });
    return names;
}

bool onInterfaces(const std::string& name) {
    return name == "PH" || name == "PHB" || name == "W";
}

/// As WRF writes them, with its blanks.
std::string unitsOf(const std::string& name) {
    if (name == "PH" || name == "PHB") return "m2 s-2";
    if (name == "P" || name == "PB") return "Pa";
    if (name == "T") return "K";
    if (name.starts_with("QN")) return "  kg(-1)";
    if (name.starts_with("RE_")) return "m";
    return name.starts_with("Q") ? "kg kg-1" : "m s-1";
}

int defineTimes(int file, const Axes& axes) {
    int id = -1;
    const std::array<int, 2> dimensions{axes.time, axes.text};
    require(nc_def_var(file, "Times", NC_CHAR, 2, dimensions.data(), &id));
    return id;
}

void writeField(int file, int id, const std::string& name, const WrfSpec& spec) {
    const int nx = spec.nx + (name == "U" ? 1 : 0);
    const int nz = spec.nz + (onInterfaces(name) ? 1 : 0);
    const auto own = spec.fields.find(name);
    for (int t = 0; t < static_cast<int>(spec.times.size()); ++t) {
        std::vector<float> values;
        for (int z = 0; z < nz; ++z) {
            for (int y = 0; y < spec.ny; ++y) {
                for (int x = 0; x < nx; ++x) {
                    values.push_back(own != spec.fields.end() ? own->second(x, y, z, t)
                                                              : WrfSpec::defaultValue(name, z));
                }
            }
        }
        const std::array<std::size_t, 4> start{static_cast<std::size_t>(t), 0, 0, 0};
        const std::array<std::size_t, 4> count{1, static_cast<std::size_t>(nz),
                                               static_cast<std::size_t>(spec.ny),
                                               static_cast<std::size_t>(nx)};
        require(nc_put_vara_float(file, id, start.data(), count.data(), values.data()));
    }
}

Axes defineAxes(int file, const WrfSpec& spec) {
    Axes axes;
    const auto define = [&](const char* name, int length, int& id) {
        require(nc_def_dim(file, name, static_cast<std::size_t>(length), &id));
    };
    define("Time", NC_UNLIMITED, axes.time);
    define("DateStrLen", 19, axes.text);
    define("west_east", spec.nx, axes.x);
    define("west_east_stag", spec.nx + 1, axes.xStag);
    define("south_north", spec.ny, axes.y);
    define("bottom_top", spec.nz, axes.z);
    define("bottom_top_stag", spec.nz + 1, axes.zStag);
    return axes;
}

}  // namespace

float WrfSpec::defaultValue(const std::string& name, int z) {
    if (name == "PHB") return 9.81f * 100.0f * static_cast<float>(z);
    if (name == "PB") return 5.0e4f;
    if (name == "T") return 20.0f;
    if (name == "QVAPOR") return 0.002f;
    return 0.0f;
}

void writeWrf(const std::filesystem::path& path, const WrfSpec& spec) {
    int file = -1;
    require(nc_create(path.c_str(), modeOf(spec.format, spec.nz == 0), &file));
    const Axes axes = defineAxes(file, spec);
    const bool withTimes = !spec.omit.contains("Times");
    int times = -1;
    if (withTimes && spec.timesFirst) times = defineTimes(file, axes);
    const std::vector<std::string> names = fieldNames(spec);
    std::vector<int> ids;
    for (const std::string& name : names) {
        const std::array<int, 4> dimensions{axes.time, onInterfaces(name) ? axes.zStag : axes.z,
                                            axes.y, name == "U" ? axes.xStag : axes.x};
        int id = -1;
        require(nc_def_var(file, name.c_str(), NC_FLOAT, 4, dimensions.data(), &id));
        const std::string units = unitsOf(name);
        require(nc_put_att_text(file, id, "units", units.size(), units.data()));
        if (spec.format == NetcdfFormat::netcdf4) require(nc_def_var_deflate(file, id, 1, 1, 4));
        ids.push_back(id);
    }
    if (withTimes && !spec.timesFirst) times = defineTimes(file, axes);
    defineAttributes(file, spec);
    require(nc_enddef(file));
    for (std::size_t t = 0; withTimes && t < spec.times.size(); ++t) {
        const std::array<std::size_t, 2> start{t, 0};
        const std::array<std::size_t, 2> count{1, 19};
        std::string text = spec.times[t];
        text.resize(19, ' ');
        require(nc_put_vara_text(file, times, start.data(), count.data(), text.data()));
    }
    for (std::size_t i = 0; i < names.size(); ++i) writeField(file, ids[i], names[i], spec);
    require(nc_close(file));
}

void writeOtherNetcdf(const std::filesystem::path& path) {
    int file = -1;
    int id = -1;
    std::array<int, 3> axes{};
    require(nc_create(path.c_str(), NC_CLOBBER, &file));
    require(nc_def_dim(file, "level", 2, &axes[0]));
    require(nc_def_dim(file, "lat", 3, &axes[1]));
    require(nc_def_dim(file, "lon", 4, &axes[2]));
    require(nc_def_var(file, "temperature", NC_FLOAT, 3, axes.data(), &id));
    require(nc_close(file));
}

void truncateTo(const std::filesystem::path& path, std::uintmax_t bytes) {
    std::filesystem::resize_file(path, bytes);
}
