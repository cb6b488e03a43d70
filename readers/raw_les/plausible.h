// plausible.h: whether the numbers of a file make sense, from a sample of them: this shows a wrong
// byte order, and a descriptor that belongs to other data.
#pragma once
#include <string>
#include <vector>

#include "readers/les/quantity.h"
#include "readers/raw_les/raw_values.h"

namespace les {

/// A field whose values are known to be of a quantity, in SI.
struct Probe {
    RawField field;
    Quantity quantity;
};

/// Share of the sampled values other than zero that are possible; nothing if all are zero.
struct Shares {
    std::size_t sampled = 0;               ///< values other than zero
    double asStated = 0.0, swapped = 0.0;  ///< in the byte order of the probes and in the other
};
/// Reads some rows of every probe, more where the first are zero.
Shares sharesOf(const std::vector<Probe>& probes);

/// Whether the other byte order fits the sample and that of the probes does not.
bool isOtherOrder(const Shares& shares);

/// Sentence of a message: "4 % of the values of the sample are possible as little-endian numbers
/// …".
std::string sharesText(const Shares& shares, bool statedBig);

}  // namespace les
