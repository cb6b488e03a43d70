// wrf_maker.cpp: writes files as WRF does, with NetCDF-C.
#include "tests/readers/wrf_maker.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace {

void require(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

struct Axes {
    int time = -1, x = -1, y = -1, z = -1, xStag = -1, zStag = -1, text = -1;
};

int modeOf(NetcdfFormat format, bool allTypes) {
    if (allTypes) return NC_CLOBBER | NC_NETCDF4;
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

/// Whether a file needs more than the classic model: a second unlimited dimension, strings, or
/// types that NetCDF-3 lacks.
bool needsAllTypes(const WrfSpec& spec) {
    return spec.nz == 0 || spec.timesAsStrings ||
           std::ranges::any_of(spec.stored,
                               [](const auto& entry) { return entry.second.type > NC_DOUBLE; });
}

void putText(int file, int variable, const char* name, const std::string& value) {
    require(nc_put_att_text(file, variable, name, value.size(), value.data()));
}

void putNumber(int file, const std::string& name, double value) {
    if (value == std::floor(value)) {
        const int whole = static_cast<int>(value);
        require(nc_put_att_int(file, NC_GLOBAL, name.c_str(), NC_INT, 1, &whole));
    } else {
        require(nc_put_att_double(file, NC_GLOBAL, name.c_str(), NC_DOUBLE, 1, &value));
    }
}

void definePatch(int file, const WrfSpec& spec) {
    const WrfPatch& patch = *spec.patch;
    putNumber(file, "WEST-EAST_GRID_DIMENSION", patch.wholeNx + 1);
    putNumber(file, "SOUTH-NORTH_GRID_DIMENSION", patch.wholeNy + 1);
    putNumber(file, "WEST-EAST_PATCH_START_UNSTAG", patch.x + 1);
    putNumber(file, "WEST-EAST_PATCH_END_UNSTAG", patch.x + spec.nx);
    putNumber(file, "SOUTH-NORTH_PATCH_START_UNSTAG", patch.y + 1);
    putNumber(file, "SOUTH-NORTH_PATCH_END_UNSTAG", patch.y + spec.ny);
}

void defineAttributes(int file, const WrfSpec& spec) {
    const auto wanted = [&](const char* name) { return !spec.omit.contains(name); };
    const auto real = [&](const char* name, float value) {
        if (wanted(name)) require(nc_put_att_float(file, NC_GLOBAL, name, NC_FLOAT, 1, &value));
    };
    if (wanted("TITLE")) putText(file, NC_GLOBAL, "TITLE", spec.title);
    real("DX", spec.dx);
    real("DY", spec.dy);
    if (wanted("MP_PHYSICS")) putNumber(file, "MP_PHYSICS", spec.mpPhysics);
    if (wanted("MAP_PROJ")) putNumber(file, "MAP_PROJ", spec.mapProjection);
    for (const auto& [name, value] : spec.attributes) putNumber(file, name, value);
    for (const auto& [name, value] : spec.texts) putText(file, NC_GLOBAL, name.c_str(), value);
    if (spec.patch) definePatch(file, spec);
}

/// Faces along x: a tile with a neighbour to the east leaves the last one to it.
int facesOf(const WrfSpec& spec) {
    const bool inside = spec.patch && spec.patch->x + spec.nx < spec.patch->wholeNx;
    return spec.nx + (inside ? 0 : 1);
}

std::string nameIn(const WrfSpec& spec, const std::string& name) {
    const auto other = spec.renamed.find(name);
    return other == spec.renamed.end() ? name : other->second;
}

std::vector<std::string> fieldNames(const WrfSpec& spec) {
    std::vector<std::string> names{"PH", "PHB", "P", "PB", "T", "QVAPOR", "QCLOUD", "QRAIN", "U"};
    const auto add = [&](const auto& fields) {
        for (const auto& [name, function] : fields) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    };
    add(spec.fields);
    add(spec.stored);
    add(spec.flat);
    std::erase_if(names, [&](const std::string& name) { return spec.omit.contains(name); });
    return names;
}

/// As WRF writes them, with its blanks.
std::string unitsOf(const WrfSpec& spec, const std::string& name) {
    if (const auto own = spec.units.find(name); own != spec.units.end()) return own->second;
    if (name.starts_with("PH")) return "m2 s-2";
    if (name == "P" || name == "PB") return "Pa";
    if (name == "T") return "K";
    if (name.starts_with("QN")) return "  kg(-1)";
    if (name.starts_with("RE_")) return "m";
    return name.starts_with("Q") ? "kg kg-1" : "m s-1";
}

int defineTimes(int file, const Axes& axes, bool strings) {
    int id = -1;
    const std::array<int, 2> dimensions{axes.time, axes.text};
    require(nc_def_var(file, "Times", strings ? NC_STRING : NC_CHAR, strings ? 1 : 2,
                       dimensions.data(), &id));
    return id;
}

void writeTimes(int file, int id, const WrfSpec& spec) {
    for (std::size_t t = 0; t < spec.times.size(); ++t) {
        const std::array<std::size_t, 2> start{t, 0};
        const std::array<std::size_t, 2> count{1, 19};
        std::string text = spec.times[t];
        if (spec.timesAsStrings) {
            const char* string = text.c_str();
            require(nc_put_vara_string(file, id, start.data(), count.data(), &string));
            continue;
        }
        text.resize(19, ' ');
        require(nc_put_vara_text(file, id, start.data(), count.data(), text.data()));
    }
}

void writeField(int file, int id, const std::string& name, const WrfSpec& spec, std::size_t times) {
    const bool flat = spec.flat.contains(name);
    const int nx = name == "U" ? facesOf(spec) : spec.nx;
    const int nz = flat ? 1 : spec.nz + (spec.onInterfaces.contains(name) ? 1 : 0);
    const auto stored = spec.stored.find(name);
    const auto value = [&](int x, int y, int z, int t) -> double {
        if (stored != spec.stored.end()) return stored->second.number(x, y, z, t);
        const auto& own = flat ? spec.flat : spec.fields;
        const auto found = own.find(name);
        return static_cast<double>(found != own.end() ? found->second(x, y, z, t)
                                                      : WrfSpec::defaultValue(name, z));
    };
    for (int t = 0; t < static_cast<int>(times); ++t) {
        std::vector<double> values;
        for (int z = 0; z < nz; ++z) {
            for (int y = 0; y < spec.ny; ++y) {
                for (int x = 0; x < nx; ++x) values.push_back(value(x, y, z, t));
            }
        }
        std::vector<std::size_t> start{static_cast<std::size_t>(t), 0, 0};
        std::vector<std::size_t> count{1, static_cast<std::size_t>(spec.ny),
                                       static_cast<std::size_t>(nx)};
        if (!flat) {
            start.push_back(0);
            count.insert(count.begin() + 1, static_cast<std::size_t>(nz));
        }
        const int status = nc_put_vara_double(file, id, start.data(), count.data(), values.data());
        if (status != NC_ERANGE) require(status);  // infinities are written as such
    }
}

int defineField(int file, const std::string& name, const WrfSpec& spec, const Axes& axes) {
    std::vector<int> dimensions{axes.time, spec.onInterfaces.contains(name) ? axes.zStag : axes.z,
                                axes.y, name == "U" ? axes.xStag : axes.x};
    if (spec.flat.contains(name)) dimensions.erase(dimensions.begin() + 1);
    const auto stored = spec.stored.find(name);
    int id = -1;
    require(nc_def_var(file, nameIn(spec, name).c_str(),
                       stored == spec.stored.end() ? NC_FLOAT : stored->second.type,
                       static_cast<int>(dimensions.size()), dimensions.data(), &id));
    const std::string units = unitsOf(spec, name);
    if (units != "none") putText(file, id, "units", units);
    if (name == "P" && !spec.omit.contains("description")) {
        putText(file, id, "description", "perturbation pressure");
    }
    if (stored != spec.stored.end() && stored->second.attributes)
        stored->second.attributes(file, id);
    return id;
}

Axes defineAxes(int file, const WrfSpec& spec) {
    Axes axes;
    const auto define = [&](const char* name, int length, int& id) {
        require(
            nc_def_dim(file, nameIn(spec, name).c_str(), static_cast<std::size_t>(length), &id));
    };
    define("Time", NC_UNLIMITED, axes.time);
    define("DateStrLen", 19, axes.text);
    define("west_east", spec.nx, axes.x);
    define("west_east_stag", facesOf(spec), axes.xStag);
    define("south_north", spec.ny, axes.y);
    define("bottom_top", spec.nz, axes.z);
    define("bottom_top_stag", spec.nz + 1, axes.zStag);
    return axes;
}

int defineXtime(int file, const WrfSpec& spec, const Axes& axes) {
    int id = -1;
    require(nc_def_var(file, "XTIME", NC_DOUBLE, 1, &axes.time, &id));
    putText(file, id, "units", spec.xtimeUnits);
    if (!spec.calendar.empty()) putText(file, id, "calendar", spec.calendar);
    return id;
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
    require(nc_create(path.c_str(), modeOf(spec.format, needsAllTypes(spec)), &file));
    const Axes axes = defineAxes(file, spec);
    const bool withTimes = !spec.omit.contains("Times");
    int times = -1;
    if (withTimes && spec.timesFirst) times = defineTimes(file, axes, spec.timesAsStrings);
    const int xtime = spec.xtime.empty() ? -1 : defineXtime(file, spec, axes);
    const std::vector<std::string> names = fieldNames(spec);
    std::vector<int> ids;
    for (const std::string& name : names) {
        ids.push_back(defineField(file, name, spec, axes));
        if (spec.format == NetcdfFormat::netcdf4) {
            require(nc_def_var_deflate(file, ids.back(), spec.shuffled ? 1 : 0, 1, 4));
            const std::array<std::size_t, 4> chunk{1, spec.chunk[0], spec.chunk[1], spec.chunk[2]};
            if (spec.chunk[0] == 0 || spec.flat.contains(name)) continue;
            require(nc_def_var_chunking(file, ids.back(), NC_CHUNKED, chunk.data()));
        }
    }
    if (withTimes && !spec.timesFirst) times = defineTimes(file, axes, spec.timesAsStrings);
    defineAttributes(file, spec);
    require(nc_enddef(file));
    if (withTimes) writeTimes(file, times, spec);
    for (std::size_t t = 0; t < spec.xtime.size(); ++t) {
        require(nc_put_var1_double(file, xtime, &t, &spec.xtime[t]));
    }
    const std::size_t records = std::max(spec.times.size(), spec.xtime.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        writeField(file, ids[i], names[i], spec, records);
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
    age(path);
}

void putReals(int file, int variable, const char* name, const std::vector<double>& values) {
    require(nc_put_att_double(file, variable, name, NC_DOUBLE, values.size(), values.data()));
}

void age(const std::filesystem::path& path) {
    std::filesystem::last_write_time(
        path, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
}
