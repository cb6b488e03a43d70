// raw_values.h: numbers in files without headers: where they lie, how they are spelt, boxes of
// them.
//
// A field is a stack of horizontal planes, x fastest. Boxes are x, y, z, half-open. Everything
// fails by throwing Error or Cancelled.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "readers/raw_les/text.h"

namespace raw {

enum class NumberType { float32, float64, uint8, int16, uint16, int32 };

std::size_t bytesOf(NumberType type);
std::optional<NumberType> numberTypeNamed(std::string_view name);

/// Called between pieces with a fraction; throws Cancelled to stop.
using Tick = std::function<void(double)>;

struct Box {
    std::array<std::size_t, 3> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t plane() const { return length(0) * length(1); }
    std::size_t count() const { return plane() * length(2); }
};

/// One variable at one time as it lies in a file. `size` has been checked against the file.
struct RawField {
    std::string path;  ///< empty: zero everywhere
    std::uint64_t firstByte = 0;
    std::array<std::size_t, 3> size{1, 1, 1};
    NumberType type = NumberType::float32;
    bool swapped = false;  ///< the other byte order than this machine's
    bool records = false;  ///< every plane between two 4-byte lengths, as Fortran writes them
    bool flipY = false, flipZ = false;  ///< the file counts from the other end
    std::optional<double> missing;      ///< the number that stands for no value
    double scale = 1.0, offset = 0.0;   ///< value = scale · number + offset, missing values aside

    std::uint64_t planeBytes() const { return size[0] * size[1] * bytesOf(type); }
    /// From one plane to the next.
    std::uint64_t planeStride() const { return planeBytes() + (records ? 8 : 0); }
};

/// Fills `values` (as many as the box has) with SI values, NaN where missing, in pieces of about
/// one megabyte.
void readBox(const RawField& field, const Box& box, std::span<float> values, const Tick& tick);

/// Size of a regular file; nothing when there is no such file.
std::optional<std::uint64_t> fileSize(const std::string& path);

/// "." for a bare name.
std::string folderOf(const std::string& path);

/// `count` numbers from the start of a small file, all of it. Throws Error.
std::vector<double> readNumbers(const std::string& path, NumberType type, bool swapped,
                                std::size_t count);

/// Throws Error unless the first plane of a field with records has the length that it should have.
void checkFirstRecord(const RawField& field);

}  // namespace raw
