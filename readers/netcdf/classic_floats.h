// classic_floats.h: reads boxes of big-endian floats directly from a file, in any number of
// threads.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace nc {

/// A file opened for positioned reads. Thread-safe.
class ClassicFloats {
  public:
    /// If the file cannot be opened, usable() is false.
    explicit ClassicFloats(const std::string& path);
    ~ClassicFloats();
    ClassicFloats(const ClassicFloats&) = delete;
    ClassicFloats& operator=(const ClassicFloats&) = delete;
    bool usable() const { return descriptor_ >= 0; }

    /// Fills `values` with the box [start, start + count) of an array of `shape`, slowest axis
    /// first, that begins at byte `begin`. False if the file ends before or cannot be read.
    bool read(std::uint64_t begin, std::span<const std::size_t> shape,
              std::span<const std::size_t> start, std::span<const std::size_t> count,
              std::span<float> values) const;

  private:
    /// Reads contiguous floats from byte `at` on, in the byte order of the file.
    bool readRun(std::uint64_t at, std::span<float> run) const;
    int descriptor_ = -1;
};

}  // namespace nc
