// grads_ctl.h: a GrADS descriptor as values: which file, which grid, which variables in which
// order.
//
// Parsing looks at the text alone; it is total and linear in the length of the text. Facts are
// those of the GrADS documentation ("Elements of a GrADS Data Descriptor File") for gridded binary
// data.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/raw_les/grads_time.h"

namespace raw {

/// Positions in the unit of the descriptor.
struct CtlAxis {
    std::size_t count = 0;
    double start = 0.0, step = 0.0;  ///< of a linear axis
    std::vector<double> levels;      ///< otherwise all of them

    double at(std::size_t i) const {
        return levels.empty() ? start + step * static_cast<double>(i) : levels[i];
    }
};

struct CtlVariable {
    std::string name;
    std::size_t levels = 0;   ///< 0: one horizontal plane that has no height
    std::string description;  ///< without the unit
    std::string unit;         ///< as in parentheses or brackets at the end; may be empty

    std::size_t planes() const { return levels == 0 ? 1 : levels; }
};

enum class ByteOrder { machine, other, little, big };

/// Whether it is another than this machine's.
bool isSwapped(ByteOrder order);

struct Ctl {
    std::string dset;  ///< as written, with ^ and templates
    std::string title;
    bool isTemplate = false, sequential = false, yrev = false, zrev = false;
    ByteOrder byteOrder = ByteOrder::machine;
    std::optional<double> undef;
    CtlAxis x, y, z;
    TimeAxis t;
    std::vector<CtlVariable> variables;
    /// Of x, y and z where title or a comment says "units of x,y,z are …"; nothing when none does.
    std::optional<double> metresPerUnit;

    /// Horizontal planes of one time.
    std::uint64_t planes() const;
};

/// Throws Error with the number and the text of the line.
Ctl parseCtl(std::string_view text);

/// Whether the start of a file could be such a descriptor: cheap, no Error.
bool looksLikeCtl(std::string_view text);

}  // namespace raw
