// numbers.h: real numbers in small files without headers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace les {

/// Size of a regular file in bytes; nothing if there is no such file.
std::optional<std::uint64_t> fileSize(const std::string& path);

/// Reads `count` floats (4 bytes each) or doubles (8) from the start of a file. `swapped`: in the
/// byte order of other machines. Throws Error.
std::vector<double> readReals(const std::string& path, std::size_t bytesEach, bool swapped,
                              std::size_t count);

}  // namespace les
