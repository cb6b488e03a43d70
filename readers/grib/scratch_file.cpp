// scratch_file.cpp: in $TMPDIR or /var/tmp, which is on a disk where /tmp may be memory.
#include "readers/grib/scratch_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "readers/grib/bytes.h"

namespace grib {
namespace {

std::string scratchFolder() {
    const char* chosen = std::getenv("TMPDIR");
    return chosen != nullptr && *chosen != '\0' ? chosen : "/var/tmp";
}

[[noreturn]] void failScratch(const char* doing) {
    throw Failure{fmt::format("unpacked fields cannot be {} in {}", doing, scratchFolder()),
                  std::strerror(errno),
                  {},
                  "set TMPDIR to a folder with room, or repack the file: grib_set -r -s "
                  "packingType=grid_simple IN OUT"};
}

}  // namespace

ScratchFile::~ScratchFile() {
    if (file_ >= 0) ::close(file_);
}

std::uint64_t ScratchFile::append(std::span<const float> values) {
    if (file_ < 0) {
        std::string name = scratchFolder() + "/nephoscope-XXXXXX";
        file_ = ::mkostemp(name.data(), O_CLOEXEC);
        if (file_ < 0) failScratch("kept");
        ::unlink(name.c_str());
    }
    const std::uint64_t at = size_;
    const auto bytes = std::as_bytes(values);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t put = ::pwrite(file_, bytes.data() + done, bytes.size() - done,
                                     static_cast<off_t>(at + done));
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) failScratch("kept");
        done += static_cast<std::size_t>(put);
    }
    size_ += bytes.size();
    return at;
}

void ScratchFile::read(std::uint64_t at, std::span<float> values) const {
    const auto bytes = std::as_writable_bytes(values);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t got =
            ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) failScratch("read");
        done += static_cast<std::size_t>(got);
    }
}

void ScratchFile::clear() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
    size_ = 0;
}

}  // namespace grib
