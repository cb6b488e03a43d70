// numbers.cpp: reads whole files of numbers.
#include "readers/les/numbers.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "readers/les/text.h"

namespace les {
namespace {

template <typename Real>
double realAt(const char* bytes, bool swapped) {
    char number[sizeof(Real)];
    std::memcpy(number, bytes, sizeof(Real));
    if (swapped) std::reverse(number, number + sizeof(Real));
    Real value = 0;
    std::memcpy(&value, number, sizeof(Real));
    return static_cast<double>(value);
}

}  // namespace

std::optional<std::uint64_t> fileSize(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return static_cast<std::uint64_t>(status.st_size);
}

std::vector<double> readReals(const std::string& path, std::size_t bytesEach, bool swapped,
                              std::size_t count) {
    std::vector<char> bytes(count * bytesEach);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error{"cannot be opened", {}, {}, {}, path};
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (file.gcount() != static_cast<std::streamsize>(bytes.size())) {
        throw Error{"is truncated", fmt::format("{} bytes", file.gcount()),
                    fmt::format("{} bytes", bytes.size()),
                    "it may have changed since it was opened: open it again", path};
    }
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* from = bytes.data() + i * bytesEach;
        numbers[i] = bytesEach == sizeof(double) ? realAt<double>(from, swapped)
                                                 : realAt<float>(from, swapped);
    }
    return numbers;
}

}  // namespace les
