// abi_versions.h: which versions of the reader ABI this program serves.
#pragma once
#include <cstdint>
#include <string>

#include "core/plugin/reader_abi.h"

namespace neph {

inline constexpr std::uint32_t kOldestReaderAbi = 1;

constexpr bool servesAbi(std::uint32_t version) {
    return version >= kOldestReaderAbi && version <= NEPH_READER_ABI_VERSION;
}

/// "ABI 1 to 2", for messages.
inline std::string servedAbiText() {
    return "ABI " + std::to_string(kOldestReaderAbi) + " to " +
           std::to_string(NEPH_READER_ABI_VERSION);
}

}  // namespace neph
