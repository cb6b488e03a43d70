// classic_floats.cpp: reads a box as the longest contiguous runs that it has in the file.
#include "readers/netcdf/classic_floats.h"

#include <fcntl.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>

namespace nc {
namespace {

void fromBigEndian(std::span<float> values) {
    if constexpr (std::endian::native == std::endian::little) {
        for (float& value : values) {
            value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
        }
    }
}

}  // namespace

ClassicFloats::ClassicFloats(const std::string& path)
    : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}

ClassicFloats::~ClassicFloats() {
    if (usable()) close(descriptor_);
}

bool ClassicFloats::readRun(std::uint64_t at, std::span<float> run) const {
    auto* target = reinterpret_cast<char*>(run.data());
    for (std::size_t left = run.size_bytes(); left > 0;) {
        const ssize_t got = pread(descriptor_, target, left, static_cast<off_t>(at));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        target += got;
        at += static_cast<std::uint64_t>(got);
        left -= static_cast<std::size_t>(got);
    }
    return true;
}

bool ClassicFloats::read(std::uint64_t begin, std::span<const std::size_t> shape,
                         std::span<const std::size_t> start, std::span<const std::size_t> count,
                         std::span<float> values) const {
    if (shape.empty()) {
        if (!readRun(begin, values)) return false;
        fromBigEndian(values);
        return true;
    }
    // From axis `inner` on, the box is one run in the file: all faster axes are read whole.
    std::size_t inner = shape.size() - 1;
    std::size_t run = count[inner];
    while (inner > 0 && count[inner] == shape[inner]) run *= count[--inner];
    for (std::size_t done = 0; done < values.size(); done += run) {
        std::size_t cell = 0;
        std::size_t runIndex = done / run;
        std::size_t stride = 1;
        for (std::size_t axis = shape.size(); axis-- > 0;) {
            std::size_t at = start[axis];
            if (axis < inner) {
                at += runIndex % count[axis];
                runIndex /= count[axis];
            }
            cell += at * stride;
            stride *= shape[axis];
        }
        if (!readRun(begin + cell * sizeof(float), values.subspan(done, run))) return false;
    }
    fromBigEndian(values);
    return true;
}

}  // namespace nc
