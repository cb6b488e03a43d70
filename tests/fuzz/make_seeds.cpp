// make_seeds.cpp: writes valid inputs of every kind, one folder per fuzz target, from which the
// search starts. Argument: the folder to write to.
#include <fmt/format.h>
#include <netcdf.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/resources.h"
#include "core/plugin/reader_wire.h"
#include "core/session/session_file.h"
#include "tests/fuzz/case_files.h"
#include "tests/readers/grib_maker.h"
#include "tests/readers/les_maker.h"
#include "tests/readers/raw_maker.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

fs::path corpus;

void seed(const std::string& target, const std::string& name, const std::string& bytes) {
    fs::create_directories(corpus / target);
    std::ofstream(corpus / target / name, std::ios::binary) << bytes;
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes a folder as one input of fuzz_raw_les.
void seedCase(const std::string& name, const fs::path& folder) {
    std::string input;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string bytes = contentOf(entry.path());
        input += std::string(fuzz::kFileMark) + entry.path().filename().string() + " " +
                 std::to_string(bytes.size()) + "\n" + bytes;
    }
    seed("raw_les", name, input);
}

void seedGrads() {
    GradsSpec plain;
    GradsSpec templates;
    templates.isTemplate = templates.bigEndianOption = true;
    GradsSpec records;
    records.times = 1;
    records.sequential = records.yrev = records.zrev = true;
    records.zdef = "zdef 3 levels 0.05 0.15 0.3";
    GradsSpec terrain;
    terrain.times = 1;
    terrain.swappedUnsaid = true;
    terrain.variables = {"zs 0 99 ground (m)",        "zh {} 99 height (m)",
                         "prs {} 99 pressure (hPa)",  "tc {} 99 temperature (C)",
                         "QCLOUD {} 99 cloud (g/kg)", "qi1 {} 99 ice (kg/kg)",
                         "qi2 {} 99 ice (kg/kg)",     "qx {} 99 x (kg/kg)"};
    GradsSpec stretched;
    stretched.times = 1;
    stretched.xdef = "xdef 5 levels 0.1 0.3 0.4 0.5 0.7\n";
    stretched.ydef = "ydef 4 levels 3 2 1.5 1\n";
    GradsSpec round;
    round.times = round.ny = 1;
    round.xdef = "xdef 5 linear 0.05 0.1\n";
    int number = 0;
    for (const GradsSpec& spec : {plain, templates, records, terrain, stretched, round}) {
        const TemporaryFolder folder;
        const fs::path ctl = writeGrads(folder.path(), spec);
        const std::string namelist =
            fmt::format(" ptype = {},\n ihail = 1,\n axisymm = {}, ! {}\n terrain_flag = .{}.,\n",
                        50 + number, spec.ny == 1 ? 1 : 0, "flat", number == 3 ? "true" : "false");
        if (number >= 3) writeText(folder / "namelist.input", namelist);
        seed("ini", "namelist" + std::to_string(number), namelist);
        const std::string name = "grads" + std::to_string(number++);
        seed("ctl", name, contentOf(ctl));
        seedCase(name, folder.path());
    }
}

void seedMicrohh() {
    for (const bool doubles : {false, true}) {
        const TemporaryFolder folder;
        const fs::path path = writeMicrohh(folder.path(), {.doubles = doubles, .more = ""});
        const std::string name = doubles ? "microhh64" : "microhh32";
        seedCase(name, folder.path());
        for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
            if (entry.path().extension() == ".ini") seed("ini", name, contentOf(entry.path()));
        }
    }
}

void seedBricks() {
    const std::string small = R"({
 "type": "nephoscope-brick", "version": 1, "shape": [2, 1, 3], "spacing_m": [50, 60, 70],
 "byte_order": "big", "times": [{"seconds": 60, "label": "a minute"}],
 "variables": [{"name": "qc", "role": "mixing_ratio", "species": "cloud", "unit": "g/kg",
   "numbers": "uint16", "scale": 0.5, "offset": -1, "missing": 65535, "file": "qc.raw"}]})";
    seed("sidecar", "small", small);
    std::string uneven = small;
    uneven.insert(uneven.find("\"byte_order\""), R"("edges_m": {"x": [0, 10, 60]}, )");
    seed("sidecar", "uneven", uneven);
    seed("sidecar", "cumulus", contentOf(neph::resourcePath("samples/cumulus/cumulus.json")));
    seed("raw_les", "brick", "\n=== brick.json\n" + small + "\n=== qc.raw 12\n");
}

/// A packed and marked hydrometeor, a CF time, map scale factors, heights of centres; and a tile.
void seedWrfVariants(const TemporaryFolder& folder) {
    WrfSpec spec;
    spec.nx = spec.ny = spec.nz = 2;
    spec.mpPhysics = 3;
    spec.mapProjection = 1;
    spec.omit = {"Times", "PH", "PHB"};
    spec.xtime = {0.0, 10.0};
    spec.fields["Z"] = [](int, int, int z, int) { return 50.0f + 100.0f * static_cast<float>(z); };
    spec.units["Z"] = "m";
    spec.flat["MAPFAC_M"] = spec.flat["HGT"] = [](int, int, int, int) { return 1.1f; };
    spec.stored["QCLOUD"] = {NC_SHORT, [](int x, int, int, int) { return x - 1.0; },
                             [](int file, int id) {
                                 const double scale = 1e-4;
                                 nc_put_att_double(file, id, "scale_factor", NC_DOUBLE, 1, &scale);
                                 nc_put_att_text(file, id, "_Unsigned", 4, "true");
                             }};
    writeWrf(folder / "variant", spec);
    seed("wrf", "variant", contentOf(folder / "variant"));
    WrfSpec tile;
    tile.nx = tile.ny = tile.nz = 2;
    tile.patch = WrfPatch{0, 0, 4, 2};
    writeWrf(folder / "tile", tile);
    seed("wrf", "tile", contentOf(folder / "tile"));
}

void seedWrf() {
    for (const auto& [name, format] : {std::pair{"classic", NetcdfFormat::classic},
                                       std::pair{"offset64", NetcdfFormat::offset64}}) {
        const TemporaryFolder folder;
        WrfSpec spec;
        spec.format = format;
        spec.nx = spec.ny = spec.nz = 2;
        spec.times = {"0001-01-01_00:00:00", "0001-01-01_00:10:00"};
        writeWrf(folder / "wrfout", spec);
        seed("wrf", name, contentOf(folder / "wrfout"));
    }
    const TemporaryFolder folder;
    writeOtherNetcdf(folder / "other");
    seed("wrf", "other", contentOf(folder / "other"));
    seedWrfVariants(folder);
}

void seedReaderTexts() {
    int number = 0;
    for (const char* text :
         {"g kg-1", "  kg(-1)", "#/kg", "mb", "degC", "1e-3 kg/m^3", "2021-08-14_18:00:00",
          "2000-02-30T12:00:00.5Z", "minutes since 2021-08-14 00:00:00", "days since 0001-01-01"}) {
        seed("reader_texts", std::to_string(number++), text);
    }
}

void seedDocuments() {
    for (const auto& entry : fs::directory_iterator(neph::resourcePath("presets"))) {
        const std::string text = contentOf(entry.path());
        seed("preset", entry.path().filename().string(), text);
        seed("camera", entry.path().filename().string(), text);
    }
    seed("preset", "with_sampling", R"({"type": "nephoscope-look", "version": 1,
 "look": {"view.engine": "reference", "view.quality": 2, "view.target_error": 0.01, "view.seed": 7}})");
    seed("camera", "alone", R"({"target": [0.5, 0.5, 0.3], "distance": 1.2, "azimuth_deg": 200,
 "elevation_deg": 10, "fov_deg": 40})");
    seed("camera", "path", R"({"type": "nephoscope-camera-path", "version": 1, "with_time": true,
 "keys": [{"at_s": 0, "camera": {"azimuth_deg": 350}}, {"at_s": 2.5, "camera": {"azimuth_deg": 20}},
 {"at_s": 4, "camera": {"distance": 0.2, "fov_deg": 60}}]})");
    for (const auto& entry : fs::directory_iterator(neph::resourcePath("tests/validation"))) {
        seed("validation", entry.path().filename().string(), contentOf(entry.path()));
    }
    for (const std::string memory : {"2GiB", "50%", "800M", ""}) {
        seed("settings", "memory" + memory,
             R"({"type": "nephoscope-settings", "version": 1, "memory": ")" + memory +
                 R"(", "later": [1]})");
    }
}

/// Beginnings of formats that are recognised but not read.
void seedFileKinds() {
    using namespace std::string_literals;
    seed("file_kind", "gzip", "\x1f\x8b\x08\x0c\0\0\0\0\0\3\2\0abrun.tar\0 and more"s);
    seed("file_kind", "zip", "PK\3\4"s + std::string(22, '\0') + "\6\0\0\0qc.npy"s);
    seed("file_kind", "grib", "\1\r\r\n001 \r\r\nYTQA50 ECMF\r\r\nGRIB\0\4\0\1"s);
    seed("file_kind", "hdf5", std::string(512, '\0') + "\x89HDF\r\n\x1a\nRCP\0THETA\0"s);
    seed("file_kind", "vti", "<?xml?>\n<!-- a --><VTKFile type=\"ImageData\">");
    seed("file_kind", "npy", "\x93NUMPY\1\0\x76\0{'descr': '<f4', 'shape': (2, 3), }"s);
    seed("file_kind", "lfs", "version https://git-lfs.github.com/spec/v1\noid a\nsize 12\n");
    seed("file_kind", "fortran", "\4\0\0\0abcd\4\0\0\0"s);
    seed("file_kind", "namelist", "! a\n &time_control\n");
}

void seedSessions() {
    neph::SessionState state;
    state.slots.resize(2);
    seed("session", "plain", neph::formatSession(state, "/runs/sessions"));
    neph::SlotState& slot = state.slots.front();
    slot.data = {"/runs/wrf/wrfout_d01", "/far/away", "cumulus"};
    slot.region = neph::BoxM{{0.0, 0.0, 0.0}, {1e4, 2e4, 1e4}};
    slot.document.sampling = {.quality = 2.0f, .targetError = 0.01f, .seed = 7};
    slot.document.bookmarks = {{"south", {}}};
    slot.document.path.keys = {{0.0, {}}, {2.5, {}}};
    seed("session", "full", neph::formatSession(state, "/runs/sessions"));
}

neph::DatasetInfo description() {
    neph::DatasetInfo of;
    of.model = "WRF V4.2.2";
    of.scheme = "Thompson";
    of.size = {3, 4, 5};
    of.spacingM = {1000.0, 2000.0};
    of.times = {{"0001-01-01_00:00:00", 60.0, {}, 0}};
    of.variables = {{"QCLOUD", "cloud", "kg kg-1", "text", neph::VariableRole::mixingRatio,
                     neph::Species::cloud, of.size}};
    of.notes = {"a note"};
    of.attributes = {{"DX", "1000"}};
    return of;
}

template <typename Message>
std::string packed(const Message& message) {
    neph::wire::Packer to;
    neph::wire::pack(to, message);
    return to.take();
}

/// Every grid; simple and complex packing of every order; gaps, scanning modes, several fields.
void seedGrib() {
    const TemporaryFolder folder;
    GribSpec base;
    base.nz = 2;
    base.omit = {"SNMR", "GRLE", "CIMIXR", "RWMR"};
    base.fields["CLMR"] = [](int x, int y, int z, int) { return 1e-5 * ((x * y + z) % 7); };
    base.ground["HGT"] = [](int, int, int, int) { return 3.0; };
    const auto add = [&](const char* name, const GribSpec& spec) {
        writeGrib(folder / "a", spec);
        seed("grib", name, contentOf(folder / "a"));
    };
    GribSpec lambert = base;
    lambert.severalFields = true;
    lambert.missing = [](const std::string& name, int x, int, int) {
        return name == "CLMR" && x == 2;
    };
    add("lambert", lambert);
    GribSpec degrees = base;
    degrees.grid = "regular_ll";
    degrees.packing = "complex";
    degrees.isobaric = true;
    degrees.northward = false;
    add("degrees", degrees);
    GribSpec rotated = lambert;
    rotated.grid = "rotated_ll";
    rotated.packing = "complex";
    rotated.order = rotated.marked = 1;
    add("rotated", rotated);
    GribSpec polar = base;
    polar.grid = "polar_stereographic";
    polar.alongY = true;
    add("polar", polar);
    GribSpec mercator = base;
    mercator.grid = "mercator";
    mercator.alternating = mercator.westward = true;
    add("mercator", mercator);
}

void seedMessages() {
    const std::string described = packed(description());
    seed("messages", "description", '\0' + described);
    seed("messages", "identity", '\1' + packed(neph::wire::Identity{"id", "1", "title", "nc", 1}));
    seed("messages", "error", '\2' + packed(neph::ErrorParts{"file", "is short", "1", "2", "no"}));
    // One description and one entry with one time that uses it, as HeaderCache::save writes them.
    neph::wire::Packer common, cache;
    neph::wire::packBesidesTimes(common, description());
    cache.number(std::uint64_t{1}).text(common.take()).number(std::uint64_t{1}).text("wrfout");
    cache.number(std::uint64_t{60}).number(std::int64_t{7});
    cache.number(std::uint64_t{0}).number(std::int64_t{0}).number(std::uint64_t{0});
    cache.number(std::uint64_t{1}).text("a minute").number(60.0).number(3600.0);
    cache.number(1.0).number(2.0);
    seed("header_cache", "one", cache.take());
}

void seedLes() {
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, LesFile>> samples{
        {"cm1", cm1Sample()},       {"sam", samSample()},   {"dales", dalesSample()},
        {"palm", palmSample()},     {"monc", moncSample()}, {"uclales", uclalesSample()},
        {"mesonh", mesoNhSample()}, {"cf", cfSample()},     {"microhh", microhhSample("ql")}};
    for (const auto& sample : samples) {
        writeLes(folder / "a.nc", sample.second);
        seed("cf_les", sample.first, contentOf(folder / "a.nc"));
    }
    seed("map", "one", R"({"type": "nephoscope-map", "version": 1, "model": "m", "per": "moist_air",
        "axes": {"x": "i", "z": {"dimension": "k", "positions": "h", "faces": "f"}, "time": "t"},
        "length_unit": "km", "variables": [
        {"name": "q", "role": "mixing_ratio", "species": "ice", "unit": "g/kg"},
        {"name": "n", "role": "number_concentration", "species": "rain", "unit": "m-3"},
        {"name": "p", "role": "air_pressure"}]})");
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    corpus = arguments[1];
    seedGrads();
    seedMicrohh();
    seedBricks();
    seedWrf();
    seedLes();
    seedGrib();
    seedReaderTexts();
    seedDocuments();
    seedSessions();
    seedFileKinds();
    seedMessages();
    return 0;
}
