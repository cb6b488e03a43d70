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

/// The bytes of a CF NetCDF file with a dimension `row`, a coordinate variable of whose name is the
/// first column of numbers; each further one is a variable. Names are those of the columns with
/// underscores, units what they have in brackets; texts are left out.
std::string netcdfOf(const Table& table, const std::string& row, const std::string& title);

}  // namespace neph::plot
