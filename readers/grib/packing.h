// packing.h: unpacks fields of simple packing, complex packing, and complex packing with spatial
// differencing line by line, so that neither a whole field nor the same line twice is unpacked.
//
// A line is one row (or column) in the order of the message. Data representation and data templates
// 5.0, 5.2, 5.3 and 7.0, 7.2, 7.3.
#pragma once
#include <array>
#include <vector>

#include "readers/grib/bytes.h"

namespace grib {

/// What section 5 states.
struct Packing {
    unsigned form = 0;  ///< data representation template
    std::uint64_t values = 0;
    double reference = 0.0, scale = 1.0;  ///< value = reference + scale · number
    unsigned bits = 0;                    ///< of a number, or of a group's reference
    // Complex packing.
    unsigned missing = 0;  ///< code table 5.5: how many numbers of a group mark missing values
    std::uint64_t groups = 0;
    unsigned widthBase = 0, widthBits = 0, lengthStep = 0, lengthBits = 0;
    std::uint64_t lengthBase = 0, lastLength = 0;
    // Spatial differencing.
    unsigned order = 0, extraBytes = 0;
};

/// Whether a form of packing is unpacked here; ecCodes unpacks the others.
bool isUnpackedHere(unsigned form);

/// Throws Failure for numbers that no encoder writes.
Packing packingOf(ByteSpan section);

/// "JPEG 2000 (template 5.40)".
std::string packingName(unsigned form);

/// Unpacks one field. It remembers places within the data, which are of variable length.
class LineUnpacker {
  public:
    LineUnpacker(const Packing& packing, std::size_t lineLength, std::size_t lineCount);

    /// Fills `values` with lines from `first` on; NaN where missing. `bitmap` is section 6, empty
    /// where there is none, and `data` section 7. Throws Failure if the data are too short.
    void read(std::size_t first, ByteSpan bitmap, ByteSpan data, std::span<float> values);

  private:
    /// A place between two lines.
    struct Cursor {
        std::size_t line = 0;
        std::uint64_t value = 0;  ///< values before it
        std::uint64_t group = 0, inGroup = 0, bit = 0;
        unsigned known = 0;                    ///< of `before`: 0 to 2
        std::array<std::int64_t, 2> before{};  ///< the last two numbers, the nearest first
    };
    /// Where the parts of a complex section begin, in bits, and its first numbers.
    struct Layout {
        std::uint64_t references = 0, widths = 0, lengths = 0, numbers = 0;
        std::array<std::int64_t, 2> first{};
        std::int64_t least = 0;
    };
    Layout layoutOf(ByteSpan data) const;
    void seek(std::size_t line);
    void line(ByteSpan bitmap, ByteSpan data, const Layout& layout, std::span<float> values);
    void present(ByteSpan data, const Layout& layout, std::span<float> values);
    void simple(ByteSpan data, std::span<float> values);
    void complex(ByteSpan data, const Layout& layout, std::span<float> values);
    template <unsigned kOrder, bool kMissing>
    void group(ByteSpan data, const Layout& layout, std::uint32_t reference, unsigned width,
               std::span<float> values);

    Packing packing_;
    std::size_t lineLength_, lineCount_;
    Cursor at_;
    std::vector<Cursor> marks_;  ///< every few lines, as far as they have been reached
};

}  // namespace grib
