// mutilation.cpp: kinds of damage: truncation, flipped bits, zeros, noise, swapped, removed and
// repeated blocks, headers of other files, and numbers that are invalid or extreme.
#include "tests/readers/mutilation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/readers/grib_maker.h"
#include "tests/readers/les_maker.h"
#include "tests/readers/raw_maker.h"
#include "tests/readers/wrf_maker.h"

namespace {

namespace fs = std::filesystem;
using Bytes = std::string;

const fs::path kSource = NEPH_TEST_SOURCE_DIR;
constexpr std::size_t kHeaderBytes = 4096;  // contains most of what readers interpret

Bytes contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::ssize(bytes));
}

/// Random numbers that depend only on the seed, not on the machine.
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
    std::size_t below(std::size_t n) { return n == 0 ? 0 : engine_() % n; }
    template <typename T, std::size_t N>
    T oneOf(const std::array<T, N>& list) {
        return list[below(N)];
    }
    char byte() { return static_cast<char>(below(256)); }

  private:
    std::mt19937_64 engine_;
};

/// The file to damage. Seven positions in ten are within its header.
struct Target {
    Bytes& bytes;
    RandomNumbers& random;

    std::size_t position() {
        const std::size_t reach =
            random.below(10) < 7 ? std::min(bytes.size(), kHeaderBytes) : bytes.size();
        return random.below(reach);
    }
    std::size_t within(std::size_t start, std::size_t length) const {
        return std::min(length, bytes.size() - start);
    }
};

std::string truncated(Target w) {
    const std::size_t length = w.position();
    w.bytes.resize(length);
    return fmt::format("cut to {} bytes", length);
}

std::string lengthened(Target w) {
    const std::size_t more = w.random.oneOf(std::array<std::size_t, 4>{1, 4, 512, 4096});
    w.bytes.append(more, w.random.byte());
    return fmt::format("{} bytes appended", more);
}

std::string flipped(Target w) {
    const std::size_t count = w.random.oneOf(std::array<std::size_t, 4>{1, 2, 8, 64});
    std::string places;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = w.position();
        const auto bit = static_cast<unsigned>(w.random.below(8));
        w.bytes[at] = static_cast<char>(static_cast<unsigned char>(w.bytes[at]) ^ (1U << bit));
        places += fmt::format(" {}.{}", at, bit);
    }
    return "bits flipped at" + places;
}

std::string zeroed(Target w) {
    const std::size_t start = w.position();
    const std::size_t length =
        w.within(start, w.random.oneOf(std::array<std::size_t, 5>{1, 4, 64, 512, 4096}));
    std::fill_n(w.bytes.begin() + std::ptrdiff_t(start), length, '\0');
    return fmt::format("{} zeros at {}", length, start);
}

std::string extreme(Target w) {
    const std::size_t start = w.position();
    const std::size_t length = w.within(start, w.random.oneOf(std::array<std::size_t, 3>{1, 4, 8}));
    std::fill_n(w.bytes.begin() + std::ptrdiff_t(start), length, '\xff');
    if (w.random.below(2) == 0 && length > 0) w.bytes[start] = '\x7f';
    return fmt::format("{} bytes of ones at {}", length, start);
}

std::string noise(Target w) {
    const std::size_t start = w.position();
    const std::size_t length =
        w.within(start, w.random.oneOf(std::array<std::size_t, 3>{4, 64, 512}));
    for (std::size_t i = 0; i < length; ++i) w.bytes[start + i] = w.random.byte();
    return fmt::format("{} bytes of noise at {}", length, start);
}

std::string swapped(Target w) {
    std::size_t a = w.position(), b = w.position();
    if (a > b) std::swap(a, b);
    std::size_t length = w.random.oneOf(std::array<std::size_t, 4>{4, 64, 512, 4096});
    length = std::min(w.within(b, length), b - a);
    std::swap_ranges(w.bytes.begin() + std::ptrdiff_t(a),
                     w.bytes.begin() + std::ptrdiff_t(a + length),
                     w.bytes.begin() + std::ptrdiff_t(b));
    return fmt::format("{} bytes swapped between {} and {}", length, a, b);
}

std::string cutOut(Target w) {
    const std::size_t start = w.position();
    const std::size_t length =
        w.within(start, w.random.oneOf(std::array<std::size_t, 4>{1, 4, 64, 512}));
    w.bytes.erase(start, length);
    return fmt::format("{} bytes cut out at {}", length, start);
}

std::string doubled(Target w) {
    const std::size_t start = w.position();
    const std::size_t length =
        w.within(start, w.random.oneOf(std::array<std::size_t, 4>{1, 4, 64, 512}));
    w.bytes.insert(start, w.bytes.substr(start, length));
    return fmt::format("{} bytes doubled at {}", length, start);
}

/// In text one number is replaced by another; binary data get noise.
std::string renumbered(Target w) {
    const std::size_t start = w.bytes.find_first_of("0123456789", w.position());
    if (start == Bytes::npos || w.bytes.find('\0') != Bytes::npos) return noise(w);
    const std::size_t end = w.bytes.find_first_not_of("0123456789.eE", start);
    const std::string_view value = w.random.oneOf(
        std::array<std::string_view, 10>{"0", "-1", "nan", "inf", "1e308", "4294967296",
                                         "99999999999999999999", "2147483647", "x", "1e-300"});
    w.bytes.replace(start, end - start, value);
    return fmt::format("the number at {} is now {}", start, value);
}

using Damage = std::string (*)(Target);
constexpr std::array<Damage, 10> kDamages{truncated, lengthened, flipped, zeroed,  extreme,
                                          noise,     swapped,    cutOut,  doubled, renumbered};

/// Replaces the header by that of another file.
std::string headerReplaced(Bytes& bytes, const FileSet& set, RandomNumbers& random) {
    const std::string& donor = set.files[random.below(set.files.size())];
    const fs::path other =
        random.below(2) == 0 ? set.folder / donor : kSource / "samples/cumulus/cumulus.json";
    const std::size_t length = random.oneOf(std::array<std::size_t, 4>{8, 64, 512, 4096});
    const Bytes head = contentOf(other).substr(0, length);
    bytes.replace(0, std::min(head.size(), bytes.size()), head);
    return fmt::format("{} bytes of the header of {}", length, other.filename().string());
}

std::string damage(Bytes& bytes, const FileSet& set, RandomNumbers& random) {
    const std::size_t way = random.below(kDamages.size() + 1);
    if (bytes.empty() || way == kDamages.size()) return headerReplaced(bytes, set, random);
    return kDamages[way]({bytes, random});
}

void addIfThere(std::vector<FileSet>& list, FileSet set) {
    for (const std::string& file : set.files) {
        if (!fs::exists(set.folder / file)) return;
    }
    list.push_back(std::move(set));
}

WrfSpec smallWrf(NetcdfFormat format) {
    WrfSpec spec;
    spec.format = format;
    spec.nx = 12;
    spec.ny = 10;
    spec.nz = 8;
    return spec;
}

/// All three ways to the values: unpacked here by row and by group, and by ecCodes.
GribSpec smallGrib(const char* packing) {
    GribSpec spec;
    spec.nx = 12;
    spec.ny = 10;
    spec.nz = 4;
    spec.packing = packing;
    spec.omit = {"SNMR", "GRLE", "CIMIXR"};
    spec.fields["CLMR"] = [](int x, int y, int z, int) { return 1e-5 * ((x * y + z) % 13); };
    spec.fields["HGT"] = [](int x, int y, int z, int) { return 50.0 + x + y + 100.0 * z; };
    spec.ground["HGT"] = [](int x, int y, int, int) { return 0.5 * x + y; };
    return spec;
}

}  // namespace

std::vector<FileSet> fileSets(const fs::path& scratch) {
    fs::create_directories(scratch);
    writeWrf(scratch / "wrfout_nc4", smallWrf(NetcdfFormat::netcdf4));
    writeWrf(scratch / "wrfout_cdf2", smallWrf(NetcdfFormat::offset64));
    LesFile cm1 = cm1Sample();
    cm1.netcdf4 = true;
    writeLes(scratch / "cm1out_000001.nc", cm1);
    writeLes(scratch / "monc.nc", moncSample());
    fs::create_directories(scratch / "microhh");
    for (const char* name : {"ql", "qr"}) {
        writeLes(scratch / "microhh" / (std::string(name) + ".nc"), microhhSample(name));
    }
    for (const char* packing : {"grid_simple", "complex", "grid_ccsds"}) {
        writeGrib(scratch / packing, smallGrib(packing));
    }
    std::vector<FileSet> list{
        {"CM1 in NetCDF-4", scratch, {"cm1out_000001.nc"}, "cm1out_000001.nc"},
        {"MONC, classic", scratch, {"monc.nc"}, "monc.nc"},
        {"MicroHH in NetCDF", scratch / "microhh", {"ql.nc", "qr.nc"}, "ql.nc"},
        {"GRIB2, simple", scratch, {"grid_simple"}, "grid_simple"},
        {"GRIB2, complex", scratch, {"complex"}, "complex"},
        {"GRIB2, CCSDS", scratch, {"grid_ccsds"}, "grid_ccsds"},
        {"small NetCDF-4", scratch, {"wrfout_nc4"}, "wrfout_nc4"},
        {"classic CDF-2", scratch, {"wrfout_cdf2"}, "wrfout_cdf2"},
        {"supercell sample",
         kSource / "samples/supercell",
         {"wrfout_d01_0001-01-01_00:30:00"},
         "wrfout_d01_0001-01-01_00:30:00"},
        {"cumulus sample",
         kSource / "samples/cumulus",
         {"cumulus.json", "qc.000540.raw", "qc.000720.raw", "qr.000720.raw", "qg.000720.raw",
          "qc.000900.raw", "qr.000900.raw", "qs.000900.raw", "qg.000900.raw"},
         "cumulus.json"}};
    const fs::path data = kSource / "../shared/data";
    addIfThere(list, {"WRF supercell",
                      data / "wrf-supercell",
                      {"wrfout_d01_0001-01-01_00:00:00"},
                      "wrfout_d01_0001-01-01_00:00:00"});
    addIfThere(list, {"MicroHH RICO",
                      data / "microhh-rico",
                      {"rico.ini", "grid.0000000", "rhoref.0000000", "thermo_basestate.0000000",
                       "time.0007200", "ql.0007200", "qr.0007200"},
                      ""});
    addIfThere(list, {"CM1",
                      data / "cm1-cumulus",
                      {"cm1out_s.ctl", "cm1out_metadata.ctl", "cm1out_metadata.dat",
                       "cm1out_000001_s.dat", "cm1out_000002_s.dat", "cm1out_000003_s.dat"},
                      "cm1out_s.ctl"});
    return list;
}

std::string writeDamaged(const FileSet& set, std::uint64_t number, const fs::path& folder) {
    RandomNumbers random(number * 0x9e3779b97f4a7c15U + set.name.size());
    // The descriptor, which is the first file, is damaged most often.
    const std::size_t damagedIndex = random.below(2) == 0 ? 0 : random.below(set.files.size());
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (std::size_t i = 0; i < set.files.size(); ++i) {
        const std::string& name = set.files[i];
        if (i != damagedIndex) fs::create_symlink(fs::absolute(set.folder / name), folder / name);
    }
    const std::string& name = set.files[damagedIndex];
    Bytes bytes = contentOf(set.folder / name);
    const std::string what = damage(bytes, set, random);
    write(folder / name, bytes);
    return fmt::format("{} #{}: {}: {}", set.name, number, name, what);
}
