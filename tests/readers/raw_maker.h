// raw_maker.h: writes small raw model output, right or wrong on purpose: GrADS in every spelling of
// the same numbers, MicroHH cases.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// A GrADS descriptor and its files, as CM1 lays them out. Values do not depend on how they are
/// spelt: what is read must be the same for every combination of the flags.
struct GradsSpec {
    std::size_t nx = 5, ny = 4, nz = 3, times = 2;
    bool isTemplate = false, sequential = false, swapped = false, yrev = false, zrev = false;
    bool bigEndianOption = false;  ///< says big_endian instead of byteswapped
    std::string dset;              ///< in place of the one that the flags ask for
    std::string title =
        "CM1 output, using version cm1r21.1; units of x,y,z are km; time is generic";
    std::string zdef;  ///< in place of a linear axis of 100 m steps
    std::string xdef, tdef, options;
    std::vector<std::string> variables{
        "rain 0 99 accumulated surface rainfall (cm)", "th {} 99 potential temperature (K)",
        "prs {} 99 pressure (Pa)", "qv {} 99 water vapor mixing ratio (kg/kg)",
        "qc {} 99 qc (kg/kg)"};  ///< {} stands for nz
    bool metadata = true;        ///< cm1out_metadata beside it
};

/// Value at cell x, y, z of variable number v at time t; exact in float.
float gradsValue(std::size_t v, std::size_t x, std::size_t y, std::size_t z, std::size_t t);

/// Writes <folder>/cm1out_s.ctl and its data; returns the descriptor's path.
std::filesystem::path writeGrads(const std::filesystem::path& folder, const GradsSpec& spec);

/// Files of plain numbers in this machine's order or the other.
void writeFloats(const std::filesystem::path& path, const std::vector<float>& values,
                 bool swapped = false);
void writeDoubles(const std::filesystem::path& path, const std::vector<double>& values);
void writeText(const std::filesystem::path& path, const std::string& text);

/// A MicroHH case of 4 x 3 x 2 cells of 100 m, 100 m, 50 m, with ql = 1e-3 · z-index at two times.
struct MicrohhSpec {
    bool doubles = false;
    bool density = true;
    std::string more;  ///< of the .ini
};
std::filesystem::path writeMicrohh(const std::filesystem::path& folder, const MicrohhSpec& spec);
