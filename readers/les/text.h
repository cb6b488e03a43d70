// text.h: text of descriptors: reading it, splitting it into lines and words, parsing numbers.
//
// Any bytes give a result or an Error, in time linear in their number.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace les {

using neph::plugin::Error;

/// No descriptor comes near this size; larger files are not read.
inline constexpr std::size_t kMaxTextBytes = 4U << 20U;

/// The whole file, without the UTF-8 mark that some editors put first; nothing if it cannot be
/// read, is longer than `most`, or contains zero bytes and so is not text.
std::optional<std::string> findText(const std::string& path, std::size_t most = kMaxTextBytes);

/// As findText, but throws Error instead of returning nothing.
std::string readText(const std::string& path);

/// Lines without their ends, which may be LF or CR LF.
std::vector<std::string_view> splitLines(std::string_view text);
std::vector<std::string_view> splitWords(std::string_view line);
std::string_view trimmed(std::string_view text);
std::string toLower(std::string_view text);

/// All of `text` as a finite number. Fortran's `1.0D+02` and a leading plus are accepted.
std::optional<double> parseNumber(std::string_view text);
/// All of `text` as an integer. A leading plus is accepted.
std::optional<std::int64_t> parseInteger(std::string_view text);

/// For messages: `text` in quotes, cut to about a line, with unprintable bytes as question marks.
std::string inQuotes(std::string_view text);

/// For messages: names separated by commas; "none" if there are none, "…" after the first dozen.
std::string joined(const std::vector<std::string>& names);

}  // namespace les
