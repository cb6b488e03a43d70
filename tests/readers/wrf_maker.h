// wrf_maker.h: writes small files with the structure of WRF output, valid or invalid on purpose.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Value of a field at cell x, y, z of time index t.
using FieldFunction = std::function<float(int x, int y, int z, int t)>;

enum class NetcdfFormat { classic, offset64, netcdf4 };

struct WrfSpec {
    NetcdfFormat format = NetcdfFormat::classic;
    int nx = 4, ny = 3, nz = 5;
    float dx = 1000.0f, dy = 2000.0f;
    int mapProjection = 0;
    std::string title = " OUTPUT FROM WRF V4.2.2 MODEL";
    int mpPhysics = 8;
    std::vector<std::string> times{"0001-01-01_00:00:00"};
    std::set<std::string> omit;                   ///< variables and global attributes to leave out
    std::map<std::string, FieldFunction> fields;  ///< replace the default values, or add fields
    bool timesFirst = true;  ///< Times before the fields in the file, as in WRF output

    /// Layers are 100 m deep; air as in the first test value of docs/physics.md §7: p 5e4 Pa, theta
    /// 320 K, q_v 0.002.
    static float defaultValue(const std::string& name, int z);
};

void writeWrf(const std::filesystem::path& path, const WrfSpec& spec);

/// A NetCDF-3 file that is not WRF output: temperature on lat, lon, level.
void writeOtherNetcdf(const std::filesystem::path& path);

/// Truncates a file to its first `bytes` bytes.
void truncateTo(const std::filesystem::path& path, std::uintmax_t bytes);
