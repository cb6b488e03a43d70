// text.cpp: reading, splitting and parsing of text.
#include "readers/les/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace les {
namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

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
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
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

}  // namespace les
