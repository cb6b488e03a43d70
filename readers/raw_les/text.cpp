// text.cpp: reading, splitting and parsing of text; the table of units.
#include "readers/raw_les/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace raw {
namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

/// A spelling of a unit, and its factor to SI.
struct Unit {
    Quantity quantity;
    std::string_view spelling;  // without blanks, in lower case
    double factor;
};
constexpr std::array kUnits{
    Unit{Quantity::ratio, "kg/kg", 1.0},
    Unit{Quantity::ratio, "kgkg-1", 1.0},
    Unit{Quantity::ratio, "g/kg", 1e-3},
    Unit{Quantity::ratio, "gkg-1", 1e-3},
    Unit{Quantity::density, "kg/m^3", 1.0},
    Unit{Quantity::density, "kg/m3", 1.0},
    Unit{Quantity::density, "kgm-3", 1.0},
    Unit{Quantity::density, "g/m3", 1e-3},
    Unit{Quantity::pressure, "pa", 1.0},
    Unit{Quantity::pressure, "hpa", 100.0},
    Unit{Quantity::pressure, "mb", 100.0},
    Unit{Quantity::temperature, "k", 1.0},
    Unit{Quantity::radius, "m", 1.0},
    Unit{Quantity::radius, "micron", 1e-6},
    Unit{Quantity::radius, "microns", 1e-6},
    Unit{Quantity::radius, "micrometer", 1e-6},
    Unit{Quantity::radius, "micrometers", 1e-6},
    Unit{Quantity::radius, "um", 1e-6},
    Unit{Quantity::number, "#/kg", 1.0},
    Unit{Quantity::number, "1/kg", 1.0},
    Unit{Quantity::number, "/kg", 1.0},
    Unit{Quantity::number, "kg-1", 1.0},
};

}  // namespace

std::optional<std::string> findText(const std::string& path, std::size_t most) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};  // a pipe would block for ever
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return {};
    std::string text;
    std::array<char, 16384> piece{};
    while (stream.read(piece.data(), piece.size()) || stream.gcount() > 0) {
        text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > most || text.find('\0') != std::string::npos) return {};
    }
    if (stream.bad()) return {};
    return text;
}

std::string readText(const std::string& path) {
    auto text = findText(path);
    if (text) return *std::move(text);
    throw Error{"cannot be read as text", "binary data, or a file that cannot be read",
                fmt::format("text of at most {} MiB", kMaxTextBytes >> 20U), "", path};
}

std::vector<std::string_view> splitLines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::vector<std::string_view> splitWords(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < line.size();) {
        if (isSpace(line[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < line.size() && !isSpace(line[end])) ++end;
        words.push_back(line.substr(i, end - i));
        i = end;
    }
    return words;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
    return text;
}

std::string toLower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

std::optional<double> parseNumber(std::string_view text) {
    std::string digits = toLower(text);
    std::ranges::replace(digits, 'd', 'e');  // Fortran's double precision exponent
    const char* begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
    const char* end = digits.data() + digits.size();
    double value = 0.0;
    const auto [stop, code] = std::from_chars(begin, end, value);
    if (code != std::errc() || stop != end || !std::isfinite(value)) return {};
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || stop != text.data() + text.size()) return {};
    return value;
}

std::string inQuotes(std::string_view text) {
    constexpr std::size_t kMax = 80;
    std::string shown;
    for (const char c : trimmed(text.substr(0, kMax))) {
        shown += c >= ' ' && c <= '~' ? c : '?';
    }
    return '"' + shown + (text.size() > kMax ? "…\"" : "\"");
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t kMax = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMax); ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    if (names.size() > kMax) text += fmt::format(" … ({} in all)", names.size());
    return text.empty() ? "none" : text;
}

std::optional<double> siFactor(Quantity quantity, std::string_view unit) {
    std::string spelling;
    for (const char c : toLower(unit)) {
        if (!isSpace(c)) spelling += c;
    }
    for (const Unit& known : kUnits) {
        if (known.quantity == quantity && known.spelling == spelling) return known.factor;
    }
    return {};
}

const char* siUnit(Quantity quantity) {
    switch (quantity) {
        case Quantity::ratio:
            return "kg kg-1";
        case Quantity::density:
            return "kg m-3";
        case Quantity::pressure:
            return "Pa";
        case Quantity::temperature:
            return "K";
        case Quantity::radius:
            return "m";
        case Quantity::number:
            return "kg-1";
    }
    return "";
}

const char* acceptedUnits(Quantity quantity) {
    switch (quantity) {
        case Quantity::ratio:
            return "kg/kg or g/kg";
        case Quantity::density:
            return "kg/m3 or g/m3";
        case Quantity::pressure:
            return "Pa or hPa";
        case Quantity::temperature:
            return "K";
        case Quantity::radius:
            return "m or micron";
        case Quantity::number:
            return "#/kg or 1/kg";
    }
    return "";
}

}  // namespace raw
