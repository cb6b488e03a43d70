// file_kind.cpp: the table of what is recognised but not read. Magic numbers are those of the
// formats' own descriptions. A long table is data: one row, one kind.
#include "core/plugin/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/plugin/file_signs.h"

namespace neph {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::size_t kHeadBytes = std::size_t{64} << 10U;

// What makes numbers readable that a format keeps in its own way.
#define NEPH_BRICK_STEP                                                                         \
    "write each hydrometeor and the density as bare numbers (`q.astype('f4').tofile('q.bin')` " \
    "of q[z, y, x] in numpy), and describe them in a `nephoscope-brick` sidecar (docs/raw-les.md)"

constexpr auto kKinds = std::to_array<FileKindRow>({
    {.id = "empty",
     .what = "an empty file",
     .sign = "no bytes",
     .step = "copy it again, or look into the log of the run that should have written it "
             "(`rsl.error.0000` of WRF); `df -h` tells whether the disk is full",
     .is = [](const FileSigns& s) { return !s.folder && s.bytes == 0; },
     .aside = true},
    {.id = "zarr",
     .what = "a Zarr store",
     .sign = "a folder with `.zgroup`, `.zarray`, `.zattrs`, `.zmetadata` or `zarr.json`",
     .step = "write it as NetCDF: `python3 -c \"import sys, xarray; "
             "xarray.open_zarr(sys.argv[1]).to_netcdf(sys.argv[2])\" FILE STEM.nc`; output of WRF "
             "can then be opened",
     .is = isZarrFolder},
    {.id = "adios",
     .what = "an ADIOS2 folder (WRF's io_form 22)",
     .sign = "a folder with `md.idx` and `data.0`",
     .step = "write NetCDF instead (`io_form_history = 2`), or convert it: `bpls FILE` lists what "
             "it holds, and WRF's `converter` for ADIOS2 writes NetCDF",
     .is =
         [](const FileSigns& s) {
             return folderHolds(s, {"md.idx", "data.0"});
         }},
    {.id = "zarr-part",
     .what = "a part of a Zarr store",
     .sign = "JSON with the key `zarr_format`",
     .step = "the store is the folder around it; write that as NetCDF with "
             "`xarray.open_zarr(...).to_netcdf(...)`",
     .is =
         [](const FileSigns& s) {
             return isJson(s) && s.head.find("\"zarr_format\"") != s.head.npos;
         }},
    {.id = "gzip-tar",
     .what = "a tar archive compressed with gzip",
     .sign = "bytes 1F 8B 08, and a name that was stored in it with the ending .tar",
     .step = "unpack it, then open what was in it: `tar -xf FILE`",
     .is = [](const FileSigns& s) { return gzipName(s).ends_with(".tar"); }},
    {.id = "gzip",
     .what = "a file compressed with gzip",
     .sign = "bytes 1F 8B",
     .step = "`gunzip -k FILE` writes STEM, which can be opened; of a .tar.gz `tar -xf FILE` does",
     .suffix = ".gz",
     .otherwise = "`gzip -dc FILE > FILE.out` writes a file that can be opened; if that is a tar "
                  "archive, `tar -xf FILE` unpacks it",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x1f\x8b"); }},
    {.id = "compress",
     .what = "a file compressed with compress",
     .sign = "bytes 1F 9D",
     .step = "`gzip -dc FILE > STEM` writes a file that can be opened",
     .suffix = ".Z",
     .otherwise = "`gzip -dc FILE > FILE.out` writes a file that can be opened",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x1f\x9d"); }},
    {.id = "zstd",
     .what = "a file compressed with Zstandard",
     .sign = "bytes 28 B5 2F FD",
     .step = "`unzstd FILE` writes STEM, which can be opened",
     .suffix = ".zst",
     .otherwise = "`zstd -dc FILE > FILE.out` writes a file that can be opened",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x28\xb5\x2f\xfd"); }},
    {.id = "bzip2",
     .what = "a file compressed with bzip2",
     .sign = "`BZh`, a digit, and the first block's mark",
     .step = "`bunzip2 -k FILE` writes STEM, which can be opened",
     .suffix = ".bz2",
     .otherwise = "`bzip2 -dc FILE > FILE.out` writes a file that can be opened",
     .is = isBzip2},
    {.id = "xz",
     .what = "a file compressed with xz",
     .sign = "bytes FD 37 7A 58 5A 00",
     .step = "`unxz -k FILE` writes STEM, which can be opened",
     .suffix = ".xz",
     .otherwise = "`xz -dc FILE > FILE.out` writes a file that can be opened",
     .is =
         [](const FileSigns& s) {
             return s.head.starts_with(
                 "\xfd"
                 "7zXZ\0"sv);
         }},
    {.id = "lz4",
     .what = "a file compressed with LZ4",
     .sign = "bytes 04 22 4D 18",
     .step = "`unlz4 FILE` writes STEM, which can be opened",
     .suffix = ".lz4",
     .otherwise = "`lz4 -dc FILE > FILE.out` writes a file that can be opened",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x04\x22\x4d\x18"); }},
    {.id = "numpy-zip",
     .what = "a NumPy archive (.npz)",
     .sign = "a zip archive whose first member is a `.npy`",
     .step = "`unzip FILE` writes its arrays as .npy; a `nephoscope-brick` sidecar makes each "
             "readable, with \"first_byte\" behind its header (docs/raw-les.md)",
     .is = [](const FileSigns& s) { return zipMember(s).ends_with(".npy"); }},
    {.id = "zip",
     .what = "a zip archive",
     .sign = "`PK` and bytes 03 04 or 05 06",
     .step = "unpack it, then open what was in it: `unzip FILE`",
     .is =
         [](const FileSigns& s) {
             return s.head.starts_with("PK\x03\x04") || s.head.starts_with("PK\x05\x06");
         }},
    {.id = "7z",
     .what = "a 7-Zip archive",
     .sign = "bytes 37 7A BC AF 27 1C",
     .step = "unpack it, then open what was in it: `7z x FILE`",
     .is = [](const FileSigns& s) { return s.head.starts_with("7z\xbc\xaf\x27\x1c"); }},
    {.id = "tar",
     .what = "a tar archive",
     .sign = "a header whose checksum is right",
     .step = "unpack it, then open what was in it: `tar -xf FILE`",
     .is = isTar},
    {.id = "grib2",
     .what = "GRIB, edition 2",
     .sign = "`GRIB` and the edition, perhaps behind a bulletin's heading",
     .step =
         "open it by itself: the reader `grib` says what it lacks; if `nephoscope readers` does "
         "not list that reader, reinstall Nephoscope, or name the folder of its readers with "
         "--reader",
     .is = [](const FileSigns& s) { return gribEdition(s) >= 2; }},
    {.id = "grib1",
     .what = "GRIB, edition 1",
     .sign = "`GRIB` and the edition, perhaps behind a bulletin's heading",
     .step = "convert it to edition 2 with NCEP's tool: `cnvgrib -g12 FILE STEM.grib2`",
     .is = [](const FileSigns& s) { return gribEdition(s) == 1; }},
    {.id = "bufr",
     .what = "BUFR, which holds observations",
     .sign = "`BUFR`",
     .step = "open output of a model; BUFR holds no fields on a grid",
     .is = [](const FileSigns& s) { return s.head.starts_with("BUFR"); }},
    {.id = "hdf4",
     .what = "HDF4, as ARPS and many satellites write it",
     .sign = "bytes 0E 03 13 01",
     .step = "have ARPS write NetCDF (`hdmpfmt = 7`), or read it with python (pyhdf, xarray) "
             "and " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return s.head.starts_with("\x0e\x03\x13\x01"); }},
    {.id = "matlab",
     .what = "a MATLAB file",
     .sign = "`MATLAB` and a version",
     .step = "in MATLAB `fwrite(f, q, 'float32')` writes q(x, y, z) as bare numbers, x fastest; "
             "describe them in a `nephoscope-brick` sidecar (docs/raw-les.md)",
     .is =
         [](const FileSigns& s) {
             return s.head.starts_with("MATLAB 5.0") || s.head.starts_with("MATLAB 7.3");
         }},
    {.id = "rams",
     .what = "HDF5 of RAMS or OLAM, without NetCDF's dimensions",
     .sign = "HDF5 without NetCDF's marks, with names such as `RCP`, `RRP`, `DN0`",
     .step = "read it with python (h5py) and " NEPH_BRICK_STEP "; `h5ls FILE` lists what it holds",
     .is = [](const FileSigns& s) { return isPlainHdf5(s) && holdsRamsNames(s); }},
    {.id = "hdf5",
     .what = "HDF5 without NetCDF's dimensions",
     .sign = "HDF5's signature, without NetCDF's marks",
     .step = "`h5ls -r FILE` lists what it holds; read it with python (h5py, xarray) "
             "and " NEPH_BRICK_STEP,
     .is = isPlainHdf5},
    {.id = "netcdf",
     .what = "NetCDF",
     .sign = "`CDF` and a version, or HDF5 with NetCDF's marks",
     .step = "`nephoscope readers` lists the readers: none of them takes NetCDF; reinstall "
             "Nephoscope, or name the folder of its readers with --reader",
     .is = isNetcdf,
     .aside = true},
    {.id = "openvdb",
     .what = "an OpenVDB file",
     .sign = "bytes 20 42 44 56 00 00 00 00",
     .step = "go back to the model's output it was made of; else python's openvdb "
             "(`copyToArray`) reads it: " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return s.head.starts_with(" BDV\0\0\0\0"sv); }},
    {.id = "nanovdb",
     .what = "a NanoVDB file",
     .sign = "`NanoVDB`",
     .step = "go back to the model's output it was made of; else `nanovdb_convert FILE STEM.vdb` "
             "and python's openvdb (`copyToArray`) reads it: " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return s.head.starts_with("NanoVDB"); }},
    {.id = "vtk-xml",
     .what = "VTK XML",
     .sign = "an element `VTKFile`",
     .step = "go back to the model's output it was made of; else python's pyvista "
             "(`pyvista.read`) reads it: " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return beginsWithTag(s, "<VTKFile"); },
     .detail = vtkType},
    {.id = "vtk-legacy",
     .what = "VTK's older format",
     .sign = "`# vtk DataFile Version`",
     .step = "go back to the model's output it was made of; else python's pyvista "
             "(`pyvista.read`) reads it: " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return s.head.starts_with("# vtk DataFile Version"); }},
    {.id = "xdmf",
     .what = "XDMF, which describes data in another file",
     .sign = "an element `Xdmf`",
     .step = "the numbers stand in the files it names: read those with python (h5py) "
             "and " NEPH_BRICK_STEP,
     .is = [](const FileSigns& s) { return beginsWithTag(s, "<Xdmf"); }},
    {.id = "numpy",
     .what = "a NumPy array",
     .sign = "byte 93 and `NUMPY`",
     .step = "write a `nephoscope-brick` sidecar for it (docs/raw-les.md), with \"first_byte\" as "
             "found",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x93NUMPY"); },
     .detail = numpyText},
    {.id = "lfs",
     .what = "a Git LFS pointer: a note of where the data are, not the data",
     .sign = "`version https://git-lfs.github.com/spec/`",
     .step = "in the repository it is from: `git lfs install`, then `git lfs pull`",
     .is =
         [](const FileSigns& s) {
             return s.head.starts_with("version https://git-lfs.github.com/spec/") ||
                    s.head.starts_with("version https://hawser.github.com/spec/");
         },
     .detail = lfsSize},
    {.id = "annex",
     .what = "a git-annex pointer: a note of where the data are, not the data",
     .sign = "a short text that begins with `/annex/objects/`",
     .step = "in the repository it is from: `git annex get FILE`",
     .is = [](const FileSigns& s) { return s.head.starts_with("/annex/objects/"); }},
    {.id = "html",
     .what = "an HTML page",
     .sign = "`<!DOCTYPE html` or `<html`",
     .step = "a server sent this page instead of the data, often to ask for a login: read it in a "
             "browser, then download the data again (`curl -fLO ADDRESS` fails rather than keep a "
             "page)",
     .is =
         [](const FileSigns& s) {
             return beginsWithTag(s, "<!DOCTYPE html") || beginsWithTag(s, "<html");
         }},
    {.id = "xml",
     .what = "XML",
     .sign = "`<?xml`, or an element `Error` as cloud stores send it",
     .step = "read it in an editor: a server may have sent it instead of the data; then give the "
             "model's own output files",
     .is =
         [](const FileSigns& s) {
             return beginsWithTag(s, "<?xml") || beginsWithTag(s, "<Error");
         }},
    {.id = "apple-double",
     .what = "the shadow that macOS keeps beside a file, not the file",
     .sign = "bytes 00 05 16 07",
     .step = "open the file of the same name without the leading `._`; copy it again if it is not "
             "there",
     .is = [](const FileSigns& s) { return s.head.starts_with("\x00\x05\x16\x07"sv); }},
    {.id = "image",
     .what = "an image or a document",
     .sign = "the signature of PNG, JPEG, GIF, TIFF, OpenEXR or PDF",
     .step = "give the model's own output files",
     .is = isImage,
     .aside = true},
    {.id = "utf16",
     .what = "text in UTF-16, as editors on Windows save it",
     .sign = "the byte order mark FF FE or FE FF",
     .step = "save it as UTF-8, or `iconv -f UTF-16 -t UTF-8 FILE > STEM.utf8`",
     .is =
         [](const FileSigns& s) {
             return s.head.starts_with("\xff\xfe") || s.head.starts_with("\xfe\xff");
         }},
    {.id = "utf8-bom",
     .what = "text that begins with a byte order mark (EF BB BF)",
     .sign = "the byte order mark EF BB BF",
     .step = "save it without the mark: `sed -i '1s/^\\xEF\\xBB\\xBF//' FILE`",
     .is = [](const FileSigns& s) { return s.head.starts_with("\xef\xbb\xbf"); }},
    {.id = "cdl",
     .what = "NetCDF as text (CDL), as `ncdump` prints it",
     .sign = "text that begins with `netcdf NAME {`",
     .step = "make a NetCDF file of it: `ncgen -k nc4 -o STEM.nc FILE`",
     .is = isCdl},
    {.id = "namelist",
     .what = "a Fortran namelist: the settings of a run, not its output",
     .sign = "text whose first line that is no comment begins with `&`",
     .step = "open the output of the run, or the folder that holds it",
     .is = isNamelist,
     .aside = true},
    {.id = "json",
     .what = "JSON that is no `nephoscope-brick`",
     .sign = "text that begins with `{` or `[`",
     .step = "a sidecar needs \"type\": \"nephoscope-brick\" (docs/raw-les.md); if a server sent "
             "this instead of data, read it and download them again",
     .is = isJson,
     .aside = true},
    {.id = "text",
     .what = "text",
     .sign = "nothing but printable characters",
     .step = "give the model's own output files, or a descriptor that a reader knows (a GrADS "
             "`.ctl`, a MicroHH `.ini`, a `nephoscope-brick` sidecar: docs/raw-les.md)",
     .is = isText,
     .aside = true,
     .detail = firstLine},
    {.id = "zeros",
     .what = "a file that begins with zeros alone",
     .sign = "64 KiB of zeros, or a whole file",
     .step = "compare its size and `cksum` with the original's: a copy that broke off leaves "
             "zeros; if it is bare numbers, a `nephoscope-brick` sidecar describes them "
             "(docs/raw-les.md)",
     .is = isZeros},
    {.id = "fortran",
     .what = "Fortran records without a description",
     .sign = "the length of the first record before and behind it",
     .step = "describe them with a GrADS `.ctl` with `options sequential`, or write bare numbers "
             "and a `nephoscope-brick` sidecar (docs/raw-les.md)",
     .is = [](const FileSigns& s) { return fortranRecord(s).has_value(); },
     .detail = fortranText},
});

#undef NEPH_BRICK_STEP

FileSigns signsOf(const fs::path& path) {
    FileSigns signs;
    signs.path = path;
    std::error_code error;
    signs.folder = fs::is_directory(path, error);
    if (signs.folder) return signs;
    signs.bytes = fs::file_size(path, error);
    signs.head.resize(kHeadBytes);
    std::ifstream in(path, std::ios::binary);
    in.read(signs.head.data(), static_cast<std::streamsize>(signs.head.size()));
    signs.head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return signs;
}

/// The step for one file; in one pass, because a path may hold the words itself.
std::string filledIn(std::string_view step, const std::string& file, const std::string& stem) {
    std::string text;
    while (!step.empty()) {
        if (step.starts_with("FILE") || step.starts_with("STEM")) {
            text += step.front() == 'F' ? file : stem;
            step.remove_prefix(4);
        } else {
            text += step.front();
            step.remove_prefix(1);
        }
    }
    return text;
}

/// Without its ending; with "out" for one where it has none.
std::string stemOf(const fs::path& path, std::string_view suffix) {
    const std::string name = path.string();
    if (!suffix.empty() && name.ends_with(suffix)) {
        return name.substr(0, name.size() - suffix.size());
    }
    const std::string bare = (path.has_filename() ? path : path.parent_path()).string();
    const std::string ending = fs::path(bare).extension().string();
    const bool plain = ending.size() > 1 && ending.size() < 6 && ending.find(':') == ending.npos;
    return plain ? bare.substr(0, bare.size() - ending.size()) : bare;
}

}  // namespace

std::span<const FileKindRow> fileKinds() {
    return kKinds;
}

std::optional<RecognisedFile> recogniseFile(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error || !(fs::is_regular_file(status) || fs::is_directory(status))) return {};
    const FileSigns signs = signsOf(path);
    const auto row = std::ranges::find_if(kKinds, [&](const auto& each) { return each.is(signs); });
    if (row == kKinds.end()) return {};
    RecognisedFile known{&*row, std::string(row->what), {}};
    if (row->detail != nullptr) {
        if (const std::string detail = row->detail(signs); !detail.empty()) {
            known.what += ": " + detail;
        }
    }
    const bool named = row->suffix.empty() || path.string().ends_with(row->suffix);
    known.step = filledIn(named ? row->step : row->otherwise, shellWord(path.string()),
                          shellWord(stemOf(path, row->suffix)));
    return known;
}

}  // namespace neph
