// table.cpp: writes comma-separated values.
#include "core/plot/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/classic_netcdf.h"

namespace neph::plot {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string inside;
    for (const char c : text) inside += c == '"' ? "\"\"" : std::string(1, c);
    return '"' + inside + '"';
}

struct NameAndUnit {
    std::string name, unit;
};

/// "w max [m/s]" as w_max and m/s.
NameAndUnit partsOf(const std::string& column) {
    const std::size_t bracket = column.find(" [");
    NameAndUnit parts{column.substr(0, bracket), "1"};
    if (bracket != std::string::npos) {
        parts.unit = column.substr(bracket + 2, column.size() - bracket - 3);
    }
    std::ranges::replace(parts.name, ' ', '_');
    return parts;
}

}  // namespace

std::string netcdfOf(const Table& table, const std::string& row, const std::string& title) {
    NetcdfContents contents;
    contents.attributes = {{"Conventions", "CF-1.8"}, {"title", title}};
    for (const std::string& comment : table.comments) {
        const std::size_t colon = comment.find(": ");
        if (colon == std::string::npos) continue;
        contents.attributes.push_back({comment.substr(0, colon), comment.substr(colon + 2)});
    }
    for (const Column& column : table.columns) {
        if (!column.texts.empty()) continue;
        const bool coordinate = contents.variables.empty();
        if (coordinate) {
            contents.dimensions.push_back({row, static_cast<int>(column.numbers.size())});
        }
        const NameAndUnit parts = partsOf(column.name);
        contents.variables.push_back({coordinate ? row : parts.name,
                                      {0},
                                      {{"long_name", column.name}, {"units", parts.unit}},
                                      column.numbers});
    }
    return formatNetcdf(contents);
}

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
