// table.h: the numbers behind a plot, as text that other programs read.
#pragma once
#include <string>
#include <vector>

namespace neph::plot {

/// Columns of equal length. A column of texts has `texts` and no `numbers`.
struct Column {
    std::string name;  ///< with the unit: "height [m]"
    std::vector<double> numbers;
    std::vector<std::string> texts;

    std::size_t size() const { return texts.empty() ? numbers.size() : texts.size(); }
};

struct Table {
    std::vector<std::string> comments;  ///< lines before the header, each after "# "
    std::vector<Column> columns;
};

/// Comma-separated values by RFC 4180 after the comments; missing numbers are empty, others have
/// seven digits.
std::string csvOf(const Table& table);

}  // namespace neph::plot
