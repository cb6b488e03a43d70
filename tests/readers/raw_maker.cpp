// raw_maker.cpp: writes numbers into files, byte by byte.
#include "tests/readers/raw_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>

namespace {

namespace fs = std::filesystem;

template <typename Number>
void append(std::string& bytes, Number number, bool swapped) {
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &number, sizeof(Number));
    if (swapped) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

float valueOf(const GradsSpec& spec, std::size_t v, std::size_t x, std::size_t y, std::size_t z,
              std::size_t t) {
    return spec.value ? spec.value(v, x, y, z, t) : gradsValue(v, x, y, z, t);
}

/// All variables at one time.
std::string recordOf(const GradsSpec& spec, std::size_t t) {
    std::string bytes;
    const bool swapped = spec.swapped || spec.swappedUnsaid;
    for (std::size_t v = 0; v < spec.variables.size(); ++v) {
        const std::size_t nz = spec.variables[v].find("{}") == std::string::npos ? 1 : spec.nz;
        for (std::size_t k = 0; k < nz; ++k) {
            const std::size_t z = spec.zrev ? nz - 1 - k : k;
            const auto length = static_cast<std::uint32_t>(spec.nx * spec.ny * 4);
            if (spec.sequential) append(bytes, length, swapped);
            for (std::size_t j = 0; j < spec.ny; ++j) {
                const std::size_t y = spec.yrev ? spec.ny - 1 - j : j;
                for (std::size_t x = 0; x < spec.nx; ++x) {
                    append(bytes, valueOf(spec, v, x, y, z, t), swapped);
                }
            }
            if (spec.sequential) append(bytes, length, swapped);
        }
    }
    return bytes;
}

std::string optionsOf(const GradsSpec& spec) {
    std::string options = spec.options;
    if (spec.isTemplate) options += " template";
    if (spec.sequential) options += " sequential";
    if (spec.yrev) options += " yrev";
    if (spec.zrev) options += " zrev";
    if (spec.swapped) options += spec.bigEndianOption ? " big_endian" : " byteswapped";
    return options.empty()
               ? ""
               : "options" + (options.starts_with(' ') ? options : " " + options) + "\n";
}

}  // namespace

float gradsValue(std::size_t v, std::size_t x, std::size_t y, std::size_t z, std::size_t t) {
    const auto place = static_cast<float>(x + 8 * y + 64 * z + 512 * t);
    switch (v) {
        case 1:
            return 300.0f + place / 64.0f;
        case 2:
            return 90000.0f - place;
        case 3:
            return 0.0078125f;
        default:
            return place / 1048576.0f;
    }
}

void writeText(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

void writeFloats(const fs::path& path, const std::vector<float>& values, bool swapped) {
    std::string bytes;
    for (const float value : values) append(bytes, value, swapped);
    writeText(path, bytes);
}

void writeDoubles(const fs::path& path, const std::vector<double>& values) {
    std::string bytes;
    for (const double value : values) append(bytes, value, false);
    writeText(path, bytes);
}

fs::path writeGrads(const fs::path& folder, const GradsSpec& spec) {
    std::string all;
    for (std::size_t t = 0; t < spec.times; ++t) {
        const std::string record = recordOf(spec, t);
        if (spec.isTemplate) {
            writeText(folder / fmt::format("cm1out_{:06}_s.dat", t + 1), record);
        }
        all += record;
    }
    if (!spec.isTemplate) writeText(folder / "cm1out_s.dat", all);
    std::string dset = spec.isTemplate ? "^cm1out_00%y4_s.dat" : "^cm1out_s.dat";
    if (!spec.dset.empty()) dset = spec.dset;
    std::string text =
        fmt::format("dset {}\n{}title {}\nundef -999999.9\n", dset, optionsOf(spec), spec.title);
    text += spec.xdef.empty() ? fmt::format("xdef {} linear -0.2 0.1\n", spec.nx) : spec.xdef;
    text += spec.ydef.empty() ? fmt::format("ydef {} linear 0.1 0.2\n", spec.ny) : spec.ydef;
    text += spec.zdef.empty() ? fmt::format("zdef {} linear 0.05 0.1\n", spec.nz) : spec.zdef;
    text += spec.tdef.empty() ? fmt::format("tdef {} linear 00:00Z01JAN0001 1YR\n", spec.times)
                              : spec.tdef;
    text += fmt::format("vars {}\n", spec.variables.size());
    for (const std::string& variable : spec.variables) {
        text += fmt::format(fmt::runtime(variable), spec.nz) + "\n";
    }
    writeText(folder / "cm1out_s.ctl", text + "endvars\n");
    if (spec.metadata) {
        writeText(folder / "cm1out_metadata.ctl",
                  fmt::format("dset ^cm1out_metadata.dat\ntitle CM1 metadata\nundef -999999.9\n"
                              "xdef 1 linear 0 1\nydef 1 linear 0 1\nzdef 1 linear 0 1\n"
                              "tdef {} linear 00:00Z01JAN0001 1YR\nvars {}\nmtime 0 99 seconds\n"
                              "nwrite 0 99 number\n{}endvars\n",
                              spec.times, spec.locations.empty() ? 2 : 4,
                              spec.locations.empty() ? ""
                                                     : "domainlocx 0 99 x (m)\n"
                                                       "domainlocy 0 99 y (m)\n"));
        std::vector<float> metadata;
        for (std::size_t t = 0; t < spec.times; ++t) {
            metadata.push_back(540.0f + 180.0f * static_cast<float>(t));
            metadata.push_back(static_cast<float>(t + 1));
            for (std::size_t i = 2 * t; i < 2 * t + 2 && i < spec.locations.size(); ++i) {
                metadata.push_back(spec.locations[i]);
            }
        }
        writeFloats(folder / "cm1out_metadata.dat", metadata);
    }
    return folder / "cm1out_s.ctl";
}

fs::path writeMicrohh(const fs::path& folder, const MicrohhSpec& spec) {
    const auto write = [&](const char* name, const std::vector<double>& values) {
        if (spec.doubles) return writeDoubles(folder / name, values);
        writeFloats(folder / name, {values.begin(), values.end()});
    };
    writeText(folder / "case.ini",
              "[grid]\nitot=4\njtot=3\nktot=2\nxsize=400 # m\nysize=300\nzsize=100\n"
              "[micro]\nswmicro=2mom_warm\nNc0=70e6\n" +
                  spec.more);
    write("grid.0000000",
          {50, 150, 250, 350, 0, 100, 200, 300, 50, 150, 250, 0, 100, 200, 25, 75, 0, 50});
    std::vector<double> ql(24, 0.0);
    std::fill(ql.begin() + 12, ql.end(), 1e-3);
    write("ql.0003600", ql);
    write("ql.0007200", ql);
    for (const char* name : {"qr.0003600", "qr.0007200"}) {
        if (spec.rain) write(name, std::vector<double>(24, 1e-5));
    }
    if (spec.density) write("rhoref.0000000", {1.2, 1.1, 1.25, 1.15, 1.05});
    write("time.0003600", {3600.0});
    write("thl_bot.0003600", std::vector<double>(12, 300.0));
    return folder;
}
