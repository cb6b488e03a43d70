// input_file.cpp: pread and mmap.
#include "readers/grib/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace grib {

Mapping::~Mapping() {
    ::munmap(start_, mapped_);
}

InputFile::InputFile(const std::string& path) : path_(path) {
    file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat about {};
    if (file_ < 0 || ::fstat(file_, &about) != 0 || !S_ISREG(about.st_mode)) {
        const int reason = file_ < 0 || !S_ISDIR(about.st_mode) ? errno : EISDIR;
        if (file_ >= 0) ::close(file_);
        throw Failure{"the file cannot be opened", std::strerror(reason), "a GRIB file", {}};
    }
    size_ = static_cast<std::uint64_t>(about.st_size);
}

InputFile::~InputFile() {
    ::close(file_);
}

std::size_t InputFile::read(std::uint64_t at, std::span<std::uint8_t> to) const {
    std::size_t done = 0;
    while (done < to.size()) {
        const ssize_t got =
            ::pread(file_, to.data() + done, to.size() - done, static_cast<off_t>(at + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            throw Failure{fmt::format("the file cannot be read at byte {}", at + done),
                          std::strerror(errno),
                          {},
                          "check the disk or the network it is on"};
        }
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

Bytes InputFile::read(Extent extent) const {
    Bytes bytes(static_cast<std::size_t>(extent.length));
    if (read(extent.at, bytes) == bytes.size()) return bytes;
    throw Failure{"the file has become shorter since it was opened",
                  {},
                  fmt::format("at least {} bytes", extent.at + extent.length),
                  "open it again"};
}

std::unique_ptr<Mapping> InputFile::map(Extent extent) const {
    struct stat about {};
    if (::fstat(file_, &about) != 0 ||
        static_cast<std::uint64_t>(about.st_size) < extent.at + extent.length) {
        throw Failure{"the file has become shorter since it was opened",
                      fmt::format("{} bytes", about.st_size),
                      fmt::format("at least {} bytes", extent.at + extent.length), "open it again"};
    }
    const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    const std::uint64_t from = extent.at / page * page;
    const auto skipped = static_cast<std::size_t>(extent.at - from);
    const std::size_t length = skipped + static_cast<std::size_t>(extent.length);
    void* start = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, file_, static_cast<off_t>(from));
    if (start == MAP_FAILED) {
        throw Failure{"its data cannot be brought into memory",
                      fmt::format("{} bytes: {}", length, std::strerror(errno)),
                      {},
                      {}};
    }
    return std::make_unique<Mapping>(start, length, skipped,
                                     static_cast<std::size_t>(extent.length));
}

}  // namespace grib
