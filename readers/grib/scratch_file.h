// scratch_file.h: a file without a name for fields that can only be unpacked whole.
#pragma once
#include <cstdint>
#include <span>

namespace grib {

class ScratchFile {
  public:
    ScratchFile() = default;
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Appends values and returns where they begin. Throws Failure that names the folder.
    std::uint64_t append(std::span<const float> values);
    /// Values that begin at `at`. Throws Failure.
    void read(std::uint64_t at, std::span<float> values) const;
    void clear();

  private:
    int file_ = -1;
    std::uint64_t size_ = 0;  ///< in bytes
};

}  // namespace grib
