// strict_json.h: JSON from strangers, read so that its faults become Errors.
//
// Numbers are kept as float, so that a float written in its shortest form reads back bit for bit.
// For core's .cpp files alone.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace neph {

/// Keeps the order of keys; floating-point numbers are float.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

inline constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 20;  // a preset has 8 KiB
inline constexpr int kMaxJsonDepth = 16;                            // a preset has 3

/// Throws Error with line and column for a syntax error, and for duplicate keys, too deep nesting
/// and numbers beyond float.
Json parseStrictJson(std::string_view text, std::string_view where);

/// The whole text of a small file. Throws Error when it is unreadable or larger than kMaxJsonBytes.
std::string readSmallFile(const std::filesystem::path& file);

/// A value in at most about 60 characters, for a message.
std::string excerpt(const Json& value);

}  // namespace neph
