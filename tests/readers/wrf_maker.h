// wrf_maker.h: writes small files with the structure of WRF output, valid or invalid on purpose.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Value of a field at cell x, y, z of time index t.
using FieldFunction = std::function<float(int x, int y, int z, int t)>;

enum class NetcdfFormat { classic, offset64, netcdf4 };

/// A field in another type, with attributes of its own.
struct StoredField {
    int type = 0;                                              ///< nc_type
    std::function<double(int x, int y, int z, int t)> number;  ///< as stored
    std::function<void(int file, int variable)> attributes;
};

/// Part of a domain that one MPI rank writes: cells [x, x + nx) of the domain.
struct WrfPatch {
    int x = 0, y = 0;
    int wholeNx = 0, wholeNy = 0;
};

struct WrfSpec {
    NetcdfFormat format = NetcdfFormat::classic;
    int nx = 4, ny = 3, nz = 5;
    float dx = 1000.0f, dy = 2000.0f;
    int mapProjection = 0;
    std::string title = " OUTPUT FROM WRF V4.2.2 MODEL";
    int mpPhysics = 1;  ///< Kessler: cloud water and rain
    std::vector<std::string> times{"0001-01-01_00:00:00"};
    std::set<std::string> omit;                   ///< variables and global attributes to leave out
    std::map<std::string, FieldFunction> fields;  ///< replace the default values, or add fields
    std::map<std::string, StoredField> stored;    ///< fields that are not floats
    std::map<std::string, std::string> units;     ///< replace WRF's; "none": without the attribute
    std::map<std::string, std::string> renamed;   ///< dimensions and variables: another name
    std::map<std::string, double> attributes;     ///< further global numbers
    std::map<std::string, std::string> texts;     ///< further global texts
    std::map<std::string, FieldFunction> flat;    ///< fields on (Time, south_north, west_east)
    std::set<std::string> onInterfaces{"PH", "PHB", "W"};
    std::vector<double> xtime;  ///< a CF time in the variable XTIME
    std::string xtimeUnits = "minutes since 2021-08-14 00:00:00";
    std::string calendar;
    bool timesAsStrings = false;  ///< NC_STRING, in NetCDF-4 only
    std::optional<WrfPatch> patch;
    /// Cells per chunk in z, y, x of the fields, in NetCDF-4 only; 0: the library's.
    std::array<std::size_t, 3> chunk{};
    bool shuffled = true;    ///< before deflate, in NetCDF-4 only
    bool timesFirst = true;  ///< Times before the fields in the file, as in WRF output

    /// Layers are 100 m deep; air as in the first test value of docs/physics.md §7: p 5e4 Pa, theta
    /// 320 K, q_v 0.002.
    static float defaultValue(const std::string& name, int z);
};

void writeWrf(const std::filesystem::path& path, const WrfSpec& spec);

/// A NetCDF-3 file that is not WRF output: temperature on lat, lon, level.
void writeOtherNetcdf(const std::filesystem::path& path);

/// A number that identifies the cell and time that it belongs to.
inline float marked(int x, int y, int z, int t) {
    return 1e-6f * static_cast<float>(1 + x + 10 * y + 100 * z + 1000 * t);
}

inline FieldFunction everywhere(float value) {
    return [value](int, int, int, int) { return value; };
}

/// An attribute of real numbers, while the file is being defined.
void putReals(int file, int variable, const char* name, const std::vector<double>& values);

/// Makes a file look as if nobody had written to it for an hour.
void age(const std::filesystem::path& path);

/// Truncates a file to its first `bytes` bytes, an hour ago.
void truncateTo(const std::filesystem::path& path, std::uintmax_t bytes);
