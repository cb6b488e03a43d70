// row_span.h: part of a row of nodes.
#pragma once
#include <algorithm>

namespace neph {

/// Neighbouring nodes of a row: `to` is behind the last.
struct RowSpan {
    int from = 0, to = 0;

    bool empty() const { return from >= to; }
    void include(int i) {
        *this = empty() ? RowSpan{i, i + 1} : RowSpan{std::min(from, i), std::max(to, i + 1)};
    }
    void include(const RowSpan& other) {
        if (other.empty()) return;
        include(other.from);
        include(other.to - 1);
    }
    RowSpan within(const RowSpan& other) const {
        return {std::max(from, other.from), std::min(to, other.to)};
    }
};

}  // namespace neph
