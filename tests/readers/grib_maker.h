// grib_maker.h: writes small GRIB2 files with ecCodes, valid or invalid on purpose.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Value of a field at cell x, y, level z (from the ground up) of time index t.
using GribFunction = std::function<double(int x, int y, int z, int t)>;

/// A message as ecCodes wrote it.
using GribMessage = std::vector<std::uint8_t>;

struct GribSpec {
    int nx = 5, ny = 4, nz = 3;
    /// regular_ll, rotated_ll, mercator, polar_stereographic, lambert, or one that is refused.
    std::string grid = "lambert";
    bool westward = false, northward = true, alongY = false, alternating = false;
    /// Of ecCodes; "complex" is packed by grib_packer_maker.h.
    std::string packing = "grid_simple";
    int bits = 16;
    int decimals = 0;  ///< of complex packing: decimal scale factor
    int order = 2;     ///< of spatial differencing
    int marked = 0;    ///< missing values are marked in complex packing this way, not by a bitmap
    bool isobaric = false;         ///< 1000, 900, ... hPa instead of hybrid levels
    bool downward = false;         ///< hybrid level 1 at the top, as some models count
    std::vector<int> hours{0};     ///< of the forecast
    int process = 83, centre = 7;  ///< HRRR
    bool severalFields = false;    ///< all fields of a level in one message
    /// By short names of NCEP: HGT, PRES, TMP, SPFH, CLMR, CIMIXR, RWMR, SNMR, GRLE, ...
    std::map<std::string, GribFunction> fields;  ///< replace the default values, or add fields
    std::map<std::string, GribFunction> ground;  ///< fields at the ground
    std::set<std::string> omit;
    std::function<bool(const std::string& name, int z, int t)> lacks;  ///< levels to leave out
    std::function<bool(const std::string& name, int x, int y, int z)> missing;  ///< by a bitmap
    /// Further keys of ecCodes for every message, after all others.
    std::map<std::string, long> keys;

    /// Layers are 100 m deep from 50 m on; air of 5e4 Pa and 262.5 K.
    static double defaultValue(const std::string& name, int z);
};

/// All messages of a file.
std::vector<GribMessage> gribMessages(const GribSpec& spec);

void writeMessages(const std::filesystem::path& path, const std::vector<GribMessage>& messages);

void writeGrib(const std::filesystem::path& path, const GribSpec& spec);

/// Values, latitudes and longitudes of message number `index` (from 0) as ecCodes reads them, in
/// the order of the message.
struct GribPoints {
    std::vector<double> latitude, longitude, value;
};
GribPoints gribPoints(const std::filesystem::path& path, std::size_t index);

/// x and y of every point in the order of the message.
std::vector<std::array<int, 2>> gribOrder(const GribSpec& spec);

/// Takes the bitmap of field number `field` (from 0) out of a message with several, and refers to
/// that of the field before.
void referToBitmap(GribMessage& message, std::size_t field);

/// Writes a sample that comes with ecCodes, such as "GRIB1".
void writeGribSample(const std::filesystem::path& path, const char* name);
