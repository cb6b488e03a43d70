// grads_ctl.h: a parsed GrADS descriptor: the data file, the grid, and the variables in file order.
//
// Parsing uses only the text. Any text gives a descriptor or an Error, in time linear in its
// length. The format is that of the GrADS documentation ("Elements of a GrADS Data Descriptor
// File") for gridded binary data.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/raw_les/grads_time.h"

namespace les {

/// Grid positions along one axis, in the unit of the descriptor.
struct CtlAxis {
    std::size_t count = 0;
    double start = 0.0, step = 0.0;  ///< used if `levels` is empty
    std::vector<double> levels;      ///< every position of an axis that is not linear

    double at(std::size_t i) const {
        return levels.empty() ? start + step * static_cast<double>(i) : levels[i];
    }
};

struct CtlVariable {
    std::string name;
    std::size_t levels = 0;   ///< 0: a single plane without a height, such as surface rain
    std::string description;  ///< without the unit
    std::string unit;         ///< from parentheses or brackets at the end; may be empty

    /// Horizontal planes that the variable occupies in the file.
    std::size_t planes() const { return levels == 0 ? 1 : levels; }
};

/// `unstated` is this machine's, as in GrADS; `other` is the option byteswapped.
enum class ByteOrder { unstated, other, little, big };

/// Whether `order` differs from this machine's.
bool isSwapped(ByteOrder order);

struct Ctl {
    std::string dset;  ///< verbatim, with ^ (the descriptor's folder) and templates
    std::string title;
    bool isTemplate = false, sequential = false, yrev = false, zrev = false;
    ByteOrder byteOrder = ByteOrder::unstated;
    std::optional<double> undef;
    CtlAxis x, y, z;
    TimeAxis t;
    std::vector<CtlVariable> variables;
    /// Unit of x, y and z if the title or a comment states "units of x,y,z are …".
    std::optional<double> metresPerUnit;

    /// Horizontal planes of all variables at one time.
    std::uint64_t planes() const;
};

/// Throws Error with the number and the text of the offending line.
Ctl parseCtl(std::string_view text);

/// The next step where a descriptor was made of WRF's output.
inline constexpr const char* kOpenWrfout =
    "this descriptor was made of WRF output: open the wrfout file itself, which states its grid "
    "and "
    "needs no descriptor";

/// Whether a text could be such a descriptor. Cheap; never throws.
bool looksLikeCtl(std::string_view text);

}  // namespace les
