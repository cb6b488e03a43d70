// plausible.cpp: samples rows that are spread over a field and counts possible values both ways. It
// reads at most some megabytes of a variable.
#include "readers/raw_les/plausible.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace les {
namespace {

constexpr std::size_t kEnough = 64;  // values other than zero

/// Counts in one byte order. Zero and missing values say nothing.
struct Counts {
    std::size_t seen = 0, possible = 0;
    double share() const {
        return seen == 0 ? 0.0 : static_cast<double>(possible) / static_cast<double>(seen);
    }
};
struct BothCounts {
    Counts asStated, swapped;
};

void count(const Probe& probe, const Box& box, bool swapped, Counts& counts) {
    RawField field = probe.field;
    field.swapped = swapped;
    std::vector<float> values(box.count());
    readBox(field, box, values, [](double) {});
    for (const float value : values) {
        if (value == 0.0f || std::isnan(value)) continue;
        ++counts.seen;
        if (isPossible(probe.quantity, static_cast<double>(value))) ++counts.possible;
    }
}

/// Some rows of up to `most` levels, at places in y that fill the field evenly.
void countLevels(const Probe& probe, std::size_t most, BothCounts& counts) {
    constexpr double kGolden = 0.6180339887498949;
    const auto& size = probe.field.size;
    const std::size_t levels = std::min(size[2], most);
    const std::size_t rows = std::min<std::size_t>(size[1], 16);
    for (std::size_t k = 0; k < levels; ++k) {
        const std::size_t z = (2 * k + 1) * size[2] / (2 * levels);
        const double part = std::fmod(kGolden * static_cast<double>(k + 1), 1.0);
        const auto y = static_cast<std::size_t>(part * static_cast<double>(size[1] - rows + 1));
        const Box box{{0, y, z}, {size[0], y + rows, z + 1}};
        count(probe, box, probe.field.swapped, counts.asStated);
        // Record lengths show the byte order by themselves.
        if (!probe.field.records) count(probe, box, !probe.field.swapped, counts.swapped);
    }
}

}  // namespace

Shares sharesOf(const std::vector<Probe>& probes) {
    BothCounts all;
    for (const Probe& probe : probes) {
        if (probe.field.path.empty()) continue;
        countLevels(probe, 8, all);
        if (all.asStated.seen < kEnough) countLevels(probe, 128, all);
    }
    return {all.asStated.seen, all.asStated.share(), all.swapped.share()};
}

bool isOtherOrder(const Shares& shares) {
    // By chance about a quarter of the values in the wrong order are possible.
    constexpr std::size_t kFewest = 4;
    return shares.sampled >= kFewest && shares.swapped > 0.5 &&
           shares.swapped > shares.asStated + 0.3;
}

std::string sharesText(const Shares& shares, bool statedBig) {
    return fmt::format(
        "{:.0f} % of the values of a sample are possible as {}-endian numbers, {:.0f} % "
        "as {}-endian ones",
        100.0 * shares.asStated, statedBig ? "big" : "little", 100.0 * shares.swapped,
        statedBig ? "little" : "big");
}

}  // namespace les
