// hash.h: hashes that identify contents. Not for input that an adversary chooses.
#pragma once
#include <cstdint>
#include <string_view>

namespace neph {

/// FNV-1a, 64 bit. [Fowler]
inline std::uint64_t hashOf(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return hash;
}

}  // namespace neph
