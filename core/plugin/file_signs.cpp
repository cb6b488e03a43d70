// file_signs.cpp: tests of the first bytes of a file. Files are untrusted: every offset is checked.
#include "core/plugin/file_signs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>

namespace neph {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
constexpr std::size_t kTarHeader = 512, kTarSumAt = 148, kTarSumBytes = 8;
constexpr std::size_t kMostHeading = 512;  // of a bulletin, before GRIB
constexpr std::size_t kShownOfLine = 60;

unsigned byteAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
}

std::uint32_t wordAt(std::string_view text, std::size_t at, bool bigEndian) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        word |= byteAt(text, at + i) << (8U * static_cast<unsigned>(bigEndian ? 3 - i : i));
    }
    return word;
}

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Without space and a mark of UTF-8 in front.
std::string_view trimmedFront(std::string_view text) {
    if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    return text;
}

bool beginsAnyCase(std::string_view text, std::string_view with) {
    return text.size() >= with.size() &&
           std::equal(with.begin(), with.end(), text.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) ==
                      std::tolower(static_cast<unsigned char>(b));
           });
}

/// What stands between `before` and the next `end`.
std::string between(std::string_view text, std::string_view before, char end) {
    const std::size_t at = text.find(before);
    if (at == text.npos) return {};
    text.remove_prefix(at + before.size());
    return std::string(text.substr(0, text.find(end)));
}

/// HDF5 allows 512 bytes, 1 KiB, 2 KiB, ... of something else before its signature.
bool isHdf5(const FileSigns& signs) {
    constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
    for (std::size_t at = 0; at < signs.head.size(); at = at == 0 ? 512 : 2 * at) {
        if (std::string_view(signs.head).substr(at).starts_with(kSignature)) return true;
    }
    return false;
}

bool holdsAny(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](auto word) { return text.find(word) != text.npos; });
}

/// Lines of text that are neither empty nor comments of Fortran.
std::string_view firstStatement(std::string_view text) {
    text = trimmedFront(text);
    while (text.starts_with('!')) {
        text.remove_prefix(std::min(text.find('\n'), text.size()));
        text = trimmedFront(text);
    }
    return text;
}

}  // namespace

bool folderHolds(const FileSigns& signs, std::initializer_list<const char*> names) {
    std::error_code error;
    return signs.folder && std::ranges::all_of(names, [&](const char* name) {
               return fs::exists(signs.path / name, error);
           });
}

bool isZarrFolder(const FileSigns& signs) {
    constexpr std::array kNames{".zgroup", ".zarray", ".zattrs", ".zmetadata", "zarr.json"};
    return std::ranges::any_of(kNames,
                               [&](const char* name) { return folderHolds(signs, {name}); });
}

/// The sum of the header's bytes, those of the sum itself taken as spaces, in octal. POSIX ustar
bool isTar(const FileSigns& signs) {
    if (signs.head.size() < kTarHeader || signs.head.front() == '\0') return false;
    unsigned sum = 0;
    for (std::size_t i = 0; i < kTarHeader; ++i) {
        const bool own = i >= kTarSumAt && i < kTarSumAt + kTarSumBytes;
        sum += own ? static_cast<unsigned>(' ') : byteAt(signs.head, i);
    }
    std::string_view told = std::string_view(signs.head).substr(kTarSumAt, kTarSumBytes);
    while (told.starts_with(' ')) told.remove_prefix(1);
    unsigned stored = 0;
    const auto end = std::from_chars(told.data(), told.data() + told.size(), stored, 8);
    return end.ec == std::errc{} && stored == sum;
}

bool isBzip2(const FileSigns& signs) {
    const std::string_view head = signs.head;
    return head.starts_with("BZh") && byteAt(head, 3) >= '1' && byteAt(head, 3) <= '9' &&
           head.substr(4, 6) == "1AY&SY"sv;
}

std::string gzipName(const FileSigns& signs) {
    constexpr unsigned kExtra = 4, kName = 8;  // RFC 1952
    constexpr std::size_t kFlagsAt = 3, kFixed = 10;
    const std::string_view head = signs.head;
    if (!head.starts_with("\x1f\x8b\x08") || (byteAt(head, kFlagsAt) & kName) == 0) return {};
    std::size_t at = kFixed;
    if ((byteAt(head, kFlagsAt) & kExtra) != 0) {
        at += 2 + byteAt(head, at) + (byteAt(head, at + 1) << 8U);
    }
    if (at >= head.size()) return {};
    return std::string(head.substr(at, head.find('\0', at) - at));
}

std::string zipMember(const FileSigns& signs) {
    constexpr std::size_t kLengthAt = 26, kNameAt = 30;
    const std::string_view head = signs.head;
    if (!head.starts_with("PK\x03\x04") || head.size() < kNameAt) return {};
    const std::size_t length = byteAt(head, kLengthAt) + (byteAt(head, kLengthAt + 1) << 8U);
    return std::string(head.substr(kNameAt, length));
}

int gribEdition(const FileSigns& signs) {
    constexpr std::size_t kEditionAt = 7;
    const std::string_view head = signs.head;
    const std::size_t at = head.substr(0, kMostHeading).find("GRIB");
    if (at == head.npos) return 0;
    const bool heading = std::ranges::all_of(head.substr(0, at), [](char c) {
        return std::isprint(static_cast<unsigned char>(c)) != 0 || isSpace(c) || c == '\x01' ||
               c == '\x03' || c == '\0';
    });
    const unsigned edition = byteAt(head, at + kEditionAt);
    return heading && (edition == 1 || edition == 2) ? static_cast<int>(edition) : 0;
}

bool isNetcdf(const FileSigns& signs) {
    const std::string_view head = signs.head;
    if (head.starts_with("CDF\x01") || head.starts_with("CDF\x02") || head.starts_with("CDF\x05")) {
        return true;
    }
    return isHdf5(signs) && holdsAny(head, {"_NCProperties", "_Netcdf4Dimid", "_nc3_strict",
                                            "This is a netCDF dimension"});
}

bool isPlainHdf5(const FileSigns& signs) {
    return isHdf5(signs) && !isNetcdf(signs);
}

bool holdsRamsNames(const FileSigns& signs) {
    const auto has = [&](std::string_view name) {
        return signs.head.find(name) != std::string::npos;
    };
    return (has("RCP\0"sv) || has("RRP\0"sv)) &&
           (has("THETA\0"sv) || has("DN0\0"sv) || has("PI\0"sv));
}

bool beginsWithTag(const FileSigns& signs, std::string_view tag) {
    std::string_view text = trimmedFront(signs.head);
    for (;;) {
        if (beginsAnyCase(text, tag)) return true;
        const bool heading = text.starts_with("<?") || text.starts_with("<!--");
        const bool type = text.starts_with("<!") && !beginsAnyCase(text, "<!DOCTYPE html");
        if (!heading && !type) return false;
        const std::string_view end = text.starts_with("<!--") ? "-->" : ">";
        const std::size_t at = text.find(end);
        if (at == text.npos) return false;
        text = trimmedFront(text.substr(at + end.size()));
    }
}

std::string vtkType(const FileSigns& signs) {
    const std::string_view head = signs.head;
    const std::size_t at = head.find("<VTKFile");
    if (at == head.npos) return {};
    return between(head.substr(at, head.find('>', at) - at), "type=\"", '"');
}

std::string numpyText(const FileSigns& signs) {
    const std::string_view head = signs.head;
    const bool longer = byteAt(head, 6) >= 2;  // version of the format
    const std::size_t header = longer ? 12 : 10;
    const std::size_t first =
        header + (longer ? wordAt(head, 8, false) : byteAt(head, 8) + (byteAt(head, 9) << 8U));
    const std::string type = between(head, "'descr': '", '\'');
    const std::string shape = between(head, "'shape': (", ')');
    if (type.empty() || shape.empty()) return {};
    const bool fortran = head.substr(0, first).find("'fortran_order': True") != head.npos;
    return fmt::format("numbers {} of shape ({}), {} fastest, from byte {} on", type, shape,
                       fortran ? "the first index" : "the last index", first);
}

std::string lfsSize(const FileSigns& signs) {
    const std::string size = between(signs.head, "\nsize ", '\n');
    return size.empty() ? "" : fmt::format("{} bytes are elsewhere", size);
}

bool isImage(const FileSigns& signs) {
    constexpr std::array kSigns{"\x89PNG\r\n"sv, "\xff\xd8\xff"sv,     "GIF8"sv, "II*\0"sv,
                                "MM\0*"sv,       "\x76\x2f\x31\x01"sv, "%PDF-"sv};
    return std::ranges::any_of(kSigns, [&](auto sign) { return signs.head.starts_with(sign); });
}

/// Bytes above 127 are letters of UTF-8 or Latin-1.
bool isText(const FileSigns& signs) {
    return !signs.head.empty() && std::ranges::none_of(signs.head, [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return (code < ' ' && !isSpace(c) && c != '\x1b') || code == 0x7f;
    });
}

bool isJson(const FileSigns& signs) {
    const std::string_view text = trimmedFront(signs.head);
    const bool opened = text.starts_with('{') || text.starts_with('[');
    if (!opened || !isText(signs)) return false;
    const std::string_view inside = trimmedFront(text.substr(1));
    return inside.empty() || holdsAny(inside.substr(0, 1), {"\"", "{", "[", "}", "]"}) ||
           std::isdigit(static_cast<unsigned char>(inside.front())) != 0;
}

bool isCdl(const FileSigns& signs) {
    const std::string_view text = trimmedFront(signs.head);
    return isText(signs) && text.starts_with("netcdf ") &&
           text.substr(0, text.find('\n')).find('{') != text.npos;
}

bool isNamelist(const FileSigns& signs) {
    const std::string_view text = firstStatement(signs.head);
    return isText(signs) && text.size() > 1 && text.front() == '&' &&
           std::isalpha(static_cast<unsigned char>(text[1])) != 0;
}

std::string firstLine(const FileSigns& signs) {
    const std::string_view text = trimmedFront(signs.head);
    std::string line(text.substr(0, std::min(text.find_first_of("\r\n"), kShownOfLine)));
    std::ranges::replace_if(
        line, [](char c) { return std::isprint(static_cast<unsigned char>(c)) == 0; }, '.');
    return line.empty() ? "" : fmt::format("\"{}\"", line);
}

bool isZeros(const FileSigns& signs) {
    return !signs.head.empty() && std::ranges::all_of(signs.head, [](char c) { return c == '\0'; });
}

std::optional<FortranRecord> fortranRecord(const FileSigns& signs) {
    for (const bool big : {false, true}) {
        const std::uint64_t length = wordAt(signs.head, 0, big);
        if (length == 0 || signs.bytes < 8 || length > signs.bytes - 8) continue;
        std::array<char, 4> after{};
        std::ifstream in(signs.path, std::ios::binary);
        in.seekg(static_cast<std::streamoff>(length + 4));
        if (!in.read(after.data(), after.size())) continue;
        if (wordAt({after.data(), after.size()}, 0, big) == length) return {{length, big}};
    }
    return {};
}

std::string fortranText(const FileSigns& signs) {
    const auto record = fortranRecord(signs);
    if (!record) return {};
    return fmt::format("the first is of {} bytes, {}-endian", record->bytes,
                       record->bigEndian ? "big" : "little");
}

std::string shellWord(const std::string& text) {
    const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("/._-+:,=@%").find(c) != std::string_view::npos;
    });
    if (plain) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

}  // namespace neph
