// raw_values.h: numbers in files without headers: their location, their encoding, and reading boxes
// of them.
//
// A field is a stack of horizontal planes, x fastest. Failures are
// thrown as Error or Cancelled.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "readers/les/box.h"
#include "readers/les/contents.h"
#include "readers/les/numbers.h"
#include "readers/les/text.h"

namespace les {

enum class NumberType { float32, float64, uint8, int16, uint16, int32 };

std::size_t bytesOf(NumberType type);
/// Type by its name in a sidecar, such as "uint16"; nothing for an unknown name.
std::optional<NumberType> numberTypeNamed(std::string_view name);

/// Location and encoding of one variable at one time. `size` was checked against the file.
struct RawField {
    std::string path;  ///< empty: zero everywhere
    std::uint64_t firstByte = 0;
    std::array<std::size_t, 3> size{1, 1, 1};
    NumberType type = NumberType::float32;
    bool swapped = false;  ///< byte order differs from this machine's
    bool records = false;  ///< each plane is a Fortran record, between two 4-byte lengths
    bool flipY = false, flipZ = false;  ///< stored from north to south, from top to bottom
    std::optional<double> missing;      ///< the number that marks a missing value
    double scale = 1.0, offset = 0.0;   ///< value = scale · number + offset

    std::uint64_t planeBytes() const { return size[0] * size[1] * bytesOf(type); }
    /// Bytes from the start of one plane to the start of the next.
    std::uint64_t planeStride() const { return planeBytes() + (records ? 8 : 0); }
};

/// Fills `values`, one for each cell of the box, in SI with NaN for missing values. Reads pieces of
/// about one megabyte.
void readBox(const RawField& field, const Box& box, std::span<float> values, const Tick& tick);

/// Where a variable is at a time. Throws Error if it lacks that time.
using Locate = std::function<RawField(std::size_t time)>;

/// Reads a variable wherever it is at a time.
Source storedAt(Locate locate);

/// Whether a file changed within the last two minutes, so that a model may be writing it.
bool changedLately(const std::string& path);

/// For a file whose size is wrong: `what` ("is shorter than its descriptor states") and `hint`, or,
/// if it changed lately, that it is being written.
void describeSize(const std::string& path, Error& error);

/// Folder of a path; "." for a bare name.
std::string folderOf(const std::string& path);

/// Reads `count` numbers from the start of a file, for small files only. Throws Error.
std::vector<double> readNumbers(const std::string& path, NumberType type, bool swapped,
                                std::size_t count);

/// Throws Error unless the first record of a field has the length of a plane.
void checkFirstRecord(const RawField& field);

/// The first four bytes as a length of a Fortran record.
struct RecordLength {
    std::uint32_t bytes = 0;
    bool swapped = false;
};
/// Whether the first record of a file is `expected` bytes long, in either byte order.
std::optional<RecordLength> firstRecordOf(const std::string& path, std::uint64_t expected);

}  // namespace les
