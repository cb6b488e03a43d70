// bytes.h: numbers as GRIB stores them: big-endian, negative ones as sign and magnitude.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace grib {

using Failure = neph::plugin::Error;
using neph::plugin::Cancelled;

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

/// The unsigned number in `count` bytes, at most 8, at 0-based `at`. Throws Failure beyond the end.
inline std::uint64_t unsignedAt(ByteSpan bytes, std::size_t at, std::size_t count) {
    if (at > bytes.size() || count > bytes.size() - at)
        throw Failure{"a section ends early", {}, {}, "download the file again"};
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8U | bytes[at + i];
    return value;
}

/// The same with a sign in the first bit. Code tables of GRIB2, regulation 92.1.5.
inline std::int64_t signedAt(ByteSpan bytes, std::size_t at, std::size_t count) {
    const std::uint64_t raw = unsignedAt(bytes, at, count);
    const std::uint64_t sign = std::uint64_t{1} << (8 * count - 1);
    const auto magnitude = static_cast<std::int64_t>(raw & (sign - 1));
    return (raw & sign) != 0 ? -magnitude : magnitude;
}

/// A number of IEEE single precision.
inline double realAt(ByteSpan bytes, std::size_t at) {
    return static_cast<double>(
        std::bit_cast<float>(static_cast<std::uint32_t>(unsignedAt(bytes, at, 4))));
}

/// Unsigned number of `count` bits, at most 32, that begins at bit `at`; the bits must be there.
inline std::uint32_t bitsAt(ByteSpan bytes, std::uint64_t at, unsigned count) {
    if (count == 0) return 0;
    const std::size_t byte = static_cast<std::size_t>(at >> 3U);
    const unsigned shift = static_cast<unsigned>(at & 7U);
    std::uint64_t word = 0;
    if (bytes.size() - byte >= sizeof(word)) {
        std::memcpy(&word, bytes.data() + byte, sizeof(word));
        if constexpr (std::endian::native == std::endian::little) word = __builtin_bswap64(word);
    } else {
        for (std::size_t i = 0; i < sizeof(word); ++i) {
            word = word << 8U | (byte + i < bytes.size() ? bytes[byte + i] : 0U);
        }
    }
    return static_cast<std::uint32_t>(word << shift >> (64U - count));
}

}  // namespace grib
