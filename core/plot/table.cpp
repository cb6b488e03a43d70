// table.cpp: writes comma-separated values.
#include "core/plot/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph::plot {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string inside;
    for (const char c : text) inside += c == '"' ? "\"\"" : std::string(1, c);
    return '"' + inside + '"';
}

}  // namespace

std::string csvOf(const Table& table) {
    std::string csv;
    for (const std::string& comment : table.comments) csv += "# " + comment + '\n';
    std::size_t rows = 0;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        csv += (c == 0 ? "" : ",") + quoted(table.columns[c].name);
        rows = std::max(rows, table.columns[c].size());
    }
    csv += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const Column& column = table.columns[c];
            if (c > 0) csv += ',';
            if (row < column.texts.size()) csv += quoted(column.texts[row]);
            if (row < column.numbers.size() && std::isfinite(column.numbers[row])) {
                csv += fmt::format("{:.7g}", column.numbers[row] + 0.0);  // no -0
            }
        }
        csv += '\n';
    }
    return csv;
}

}  // namespace neph::plot
