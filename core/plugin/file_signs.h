// file_signs.h: the beginning of a file, and what can be told from it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace neph {

/// What a file shows of itself without being read as a whole.
struct FileSigns {
    std::filesystem::path path;
    bool folder = false;
    std::uint64_t bytes = 0;
    std::string head;  ///< the first 64 KiB; of a folder nothing
};

bool folderHolds(const FileSigns& signs, std::initializer_list<const char*> names);
bool isZarrFolder(const FileSigns& signs);

bool isTar(const FileSigns& signs);
bool isBzip2(const FileSigns& signs);
/// The name that gzip stored of the file it compressed; empty where it stored none.
std::string gzipName(const FileSigns& signs);
/// The name of the first member of a zip archive; empty where it is none.
std::string zipMember(const FileSigns& signs);

/// 1 or 2; 0 where it is no GRIB.
int gribEdition(const FileSigns& signs);
bool isPlainHdf5(const FileSigns& signs);
bool isNetcdf(const FileSigns& signs);
/// Whether names of variables stand in the beginning that RAMS and OLAM give.
bool holdsRamsNames(const FileSigns& signs);

/// Whether it begins with `tag`, upper or lower case, behind space, a mark of UTF-8, and an XML
/// heading.
bool beginsWithTag(const FileSigns& signs, std::string_view tag);
/// "ImageData".
std::string vtkType(const FileSigns& signs);
/// "float32, shape (64, 32, 16), the numbers from byte 128 on".
std::string numpyText(const FileSigns& signs);
/// "of 1.4 GB".
std::string lfsSize(const FileSigns& signs);

bool isImage(const FileSigns& signs);
bool isText(const FileSigns& signs);
bool isJson(const FileSigns& signs);
bool isCdl(const FileSigns& signs);
bool isNamelist(const FileSigns& signs);
/// The first line of text in quotes.
std::string firstLine(const FileSigns& signs);

bool isZeros(const FileSigns& signs);
/// Bytes of the first record of a Fortran file with the mark of its length on both sides.
struct FortranRecord {
    std::uint64_t bytes = 0;
    bool bigEndian = false;
};
std::optional<FortranRecord> fortranRecord(const FileSigns& signs);
std::string fortranText(const FileSigns& signs);

/// As a shell takes it: in quotes where it needs them.
std::string shellWord(const std::string& text);

}  // namespace neph
