// input_file.h: a file that is read in pieces: small ones copied, large ones mapped.
#pragma once
#include <memory>
#include <string>

#include "readers/grib/bytes.h"

namespace grib {

/// Bytes [at, at + length) of a file.
struct Extent {
    std::uint64_t at = 0, length = 0;
};

/// Bytes of a file in memory, which the system reads when they are touched.
class Mapping {
  public:
    Mapping(void* start, std::size_t mapped, std::size_t skipped, std::size_t length)
        : start_(start), mapped_(mapped), skipped_(skipped), length_(length) {}
    ~Mapping();
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    ByteSpan bytes() const {
        return {static_cast<const std::uint8_t*>(start_) + skipped_, length_};
    }

  private:
    void* start_;
    std::size_t mapped_, skipped_, length_;
};

class InputFile {
  public:
    /// Throws Failure if the file cannot be opened.
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }
    std::uint64_t size() const { return size_; }

    /// Copies bytes; fewer where the file ends. Throws Failure where it cannot be read.
    std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const;
    Bytes read(Extent extent) const;
    /// Throws Failure if the file has become shorter, or there is no memory to map it in.
    std::unique_ptr<Mapping> map(Extent extent) const;

  private:
    std::string path_;
    int file_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace grib
