// options.cpp: global attributes, and MONC's table of options, pairs of texts.
#include "readers/cf_les/options.h"

#include <array>
#include <string>

#include "readers/cf_les/axes.h"
#include "readers/les/text.h"

namespace cf {
namespace {

constexpr std::size_t kMostCharacters = 1U << 22U;  // a thousand options take a few 100 kB

/// The value of an option of options_database(options, 2, characters); nothing if it is not there.
std::optional<double> optionOf(const nc::NcFile& file, std::string_view key) {
    const nc::NcVariable* table = named(file, "options_database");
    if (table == nullptr || !table->text || table->axes.size() != 3 || table->axes[1].length != 2) {
        return {};
    }
    const std::size_t rows = table->axes[0].length, length = table->axes[2].length;
    if (rows == 0 || length == 0 || length > kMostCharacters ||
        rows > kMostCharacters / length / 2) {
        return {};
    }
    const std::array<std::size_t, 3> start{0, 0, 0}, count{rows, 2, length};
    const std::string texts = file.readText(*table, start, count);
    const auto part = [&](std::size_t at) {
        const std::string_view text = std::string_view(texts).substr(at * length, length);
        return les::trimmed(text.substr(0, text.find('\0')));
    };
    for (std::size_t row = 0; row < rows; ++row) {
        if (part(2 * row) == key) return les::parseNumber(part(2 * row + 1));
    }
    return {};
}

}  // namespace

std::optional<double> statedSpacing(const nc::NcFile& file, std::size_t axis) {
    auto width = optionOf(file, axis == 0 ? "dxx" : "dyy");
    for (const char* name : {axis == 0 ? "dx" : "dy", axis == 0 ? "DX" : "DY"}) {
        if (!width) width = file.number(name);
    }
    if (!width || !(*width > 0.0 && *width < 1e6)) return {};
    return width;
}

}  // namespace cf
