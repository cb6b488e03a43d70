// raw_maker.h: writes small raw model output, valid or invalid on purpose: GrADS files in every
// layout of the same numbers, and MicroHH cases.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// A GrADS descriptor and its files, as CM1 writes them. The flags change the layout and not the
/// values: every combination must read the same.
struct GradsSpec {
    std::size_t nx = 5, ny = 4, nz = 3, times = 2;
    bool isTemplate = false, sequential = false, swapped = false, yrev = false, zrev = false;
    bool bigEndianOption = false;  ///< option big_endian instead of byteswapped
    std::string dset;              ///< instead of the one that follows from the flags
    std::string title =
        "CM1 output, using version cm1r21.1; units of x,y,z are km; time is generic";
    std::string zdef;  ///< instead of a linear axis of 100 m steps
    std::string xdef, ydef, tdef, options;
    /// Value at cell x, y, z of variable number v at time t; gradsValue if empty.
    std::function<float(std::size_t v, std::size_t x, std::size_t y, std::size_t z, std::size_t t)>
        value;
    bool swappedUnsaid = false;  ///< in the other byte order, which the descriptor does not state
    std::vector<std::string> variables{
        "rain 0 99 accumulated surface rainfall (cm)", "th {} 99 potential temperature (K)",
        "prs {} 99 pressure (Pa)", "qv {} 99 water vapor mixing ratio (kg/kg)",
        "qc {} 99 qc (kg/kg)"};    ///< {} stands for nz
    bool metadata = true;          ///< also writes cm1out_metadata
    std::vector<float> locations;  ///< domainlocx and domainlocy of each time, for the metadata
};

/// Value at cell x, y, z of variable number v at time t; exact in float.
float gradsValue(std::size_t v, std::size_t x, std::size_t y, std::size_t z, std::size_t t);

/// Writes <folder>/cm1out_s.ctl and its data; returns the descriptor's path.
std::filesystem::path writeGrads(const std::filesystem::path& folder, const GradsSpec& spec);

/// Files of plain numbers, in the byte order of this machine unless `swapped`.
void writeFloats(const std::filesystem::path& path, const std::vector<float>& values,
                 bool swapped = false);
void writeDoubles(const std::filesystem::path& path, const std::vector<double>& values);
void writeText(const std::filesystem::path& path, const std::string& text);

/// A MicroHH case of 4 x 3 x 2 cells of 100 m, 100 m, 50 m, with ql = 1e-3 · z-index at two times.
struct MicrohhSpec {
    bool rain = true;  ///< qr = 1e-5 at both times
    bool doubles = false;
    bool density = true;
    std::string more;  ///< appended to the .ini
};
std::filesystem::path writeMicrohh(const std::filesystem::path& folder, const MicrohhSpec& spec);
