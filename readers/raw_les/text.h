// text.h: descriptors as text: reading them, cutting them into lines and words, numbers.
//
// Everything here is total: any bytes give a result or an Error, in time linear in their number.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace raw {

using neph::plugin::Error;

/// No descriptor comes near this; what is longer is not read.
inline constexpr std::size_t kMostTextBytes = 4U << 20U;

/// The whole file, or nothing when it cannot be read, is longer than `most` or holds zero bytes,
/// which no text does.
std::optional<std::string> findText(const std::string& path, std::size_t most = kMostTextBytes);

/// As findText; throws Error.
std::string readText(const std::string& path);

/// Without line ends; CR LF is taken as well.
std::vector<std::string_view> linesOf(std::string_view text);
std::vector<std::string_view> wordsOf(std::string_view line);
std::string_view trimmed(std::string_view text);
std::string lower(std::string_view text);

/// The whole of `text` as a finite number; Fortran's `1.0D+02` and a leading plus are taken.
std::optional<double> numberIn(std::string_view text);
std::optional<std::int64_t> integerIn(std::string_view text);

/// For messages: at most a line's worth of `text`, in quotes.
std::string inQuotes(std::string_view text);

/// For messages: separated by commas; "none" when there are none, "…" after the first dozen.
std::string listed(const std::vector<std::string>& names);

/// 1.0 where `unit` is `base` itself, 1e-3 for its thousandth and so on; nothing for a unit that is
/// not known. Kinds of units are those that readers turn into SI.
enum class Quantity { ratio, density, pressure, temperature, radius, number };
std::optional<double> siFactor(Quantity quantity, std::string_view unit);

/// What `quantity` is in, as the host is told, and what a file may spell, for messages.
const char* siUnit(Quantity quantity);
const char* acceptedUnits(Quantity quantity);

}  // namespace raw
