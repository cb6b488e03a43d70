// repair.cpp: clips mixing ratios to what is physically possible, and judges whole fields.
#include "core/volume/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/volume/possible_air.h"

namespace neph {
namespace {

// Condensate below this is not seen, and noise of all sizes is common there.
constexpr float kLeastCondensate = 1e-6f;
// Bits that are read as something else have any exponent: most values that are not zero come out
// far beyond what is possible, or far below what matters. A model that blew up has some such cells,
// a field that was misread half of them. One in a hundred is far from both.
constexpr double kMostImpossible = 0.01;
// Rounded mixing ratios have zeros as their last byte; swapped, it becomes the exponent.
constexpr float kVanishing = 1e-20f;
constexpr float kLeastHidden = 1e-8f;
constexpr std::size_t kFewestHidden = 16;  // fewer may be so by chance
constexpr double kNearlyAll = 0.9;
constexpr float kGramsPerKilogram = 1000.0f;

bool isImpossible(float q) {
    return std::isinf(q) || std::abs(q) > kMostRatioKgPerKg;
}

bool liesIn(float q, float least) {
    return q >= least && q <= kMostRatioKgPerKg;
}

/// Counts one value that is not zero.
void count(float q, Repairs& repairs) {
    if (std::isnan(q)) {
        ++repairs.missing;
    } else if (isImpossible(q)) {
        ++repairs.impossible;
        if (liesIn(bytesSwapped(q), kVanishing)) ++repairs.swappable;
        if (liesIn(q / kGramsPerKilogram, 0.0f)) ++repairs.thousandth;
        if (repairs.marked == 0) repairs.mark = q;
        if (q == repairs.mark) ++repairs.marked;
    } else {
        if (q > kLeastCondensate) ++repairs.condensate;
        if (std::abs(q) < kVanishing) {
            ++repairs.vanishing;
            if (liesIn(bytesSwapped(q), kLeastHidden)) ++repairs.hidden;
        }
        if (q > 0.0f) return;
        ++repairs.negative;
        repairs.smallest = std::min(repairs.smallest, q);
    }
}

bool nearlyAll(std::size_t part, std::size_t whole) {
    return static_cast<double>(part) >= kNearlyAll * static_cast<double>(whole);
}

/// Why values are impossible, as far as they tell.
struct Cause {
    std::string expected, hint;
};

Cause causeOf(const Repairs& repairs) {
    const std::string expected = fmt::format("mixing ratios of 0 to {:g} kg/kg", kMostRatioKgPerKg);
    if (nearlyAll(repairs.swappable, repairs.impossible)) {
        return {expected + ", as they are with their bytes in the opposite order",
                "the byte order is probably the opposite: state it (big_endian or little_endian "
                "in a .ctl, byte_order in a sidecar)"};
    }
    if (repairs.thousandth == repairs.impossible) {
        return {expected,
                "the unit is probably g/kg, not kg/kg: state it where the variable is described, "
                "or convert the file"};
    }
    return {expected,
            "the numbers are probably not where they are looked for: record marks of Fortran, "
            "another word size (float32 or float64), an offset, or another order of variables; "
            "compare the description with the program that wrote the file. If it is right, the "
            "run blew up: leave this time out"};
}

}  // namespace

Repairs& Repairs::operator+=(const Repairs& part) {
    values += part.values;
    negative += part.negative;
    missing += part.missing;
    impossible += part.impossible;
    smallest = std::min(smallest, part.smallest);
    allZero = allZero && part.allZero;
    condensate += part.condensate;
    swappable += part.swappable;
    thousandth += part.thousandth;
    vanishing += part.vanishing;
    hidden += part.hidden;
    if (mark == part.mark) {
        marked += part.marked;
    } else if (part.marked > marked) {
        mark = part.mark;
        marked = part.marked;
    }
    return *this;
}

/// A value that is condensate in another order of bytes or another unit is no mark: a field may
/// hold only one value.
bool Repairs::hasMark() const {
    return impossible > 0 && nearlyAll(marked, impossible) &&
           !liesIn(bytesSwapped(mark), kLeastHidden) && !liesIn(mark / kGramsPerKilogram, 0.0f);
}

bool Repairs::nothing() const {
    return values > 0 && missing + (hasMark() ? marked : 0) == values;
}

Repairs repair(Array3f& mixingRatio, int countedFrom) {
    Repairs repairs;
    const glm::ivec3 size = mixingRatio.size;
    const auto width = static_cast<std::size_t>(size.x);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            float* row = mixingRatio.values.data() + mixingRatio.index(0, y, z);
            const bool counted = y >= countedFrom;
            if (counted) repairs.values += width;
            for (float* q = row; q != row + width; ++q) {
                if (*q == 0.0f) continue;
                if (counted) count(*q, repairs);
                if (*q > 0.0f && *q <= kMostRatioKgPerKg) {
                    repairs.allZero = false;
                } else {
                    *q = 0.0f;
                }
            }
        }
    }
    return repairs;
}

void requirePlausible(const Repairs& repairs, const Dataset& dataset, int time,
                      std::string_view variable) {
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    const std::string what = fmt::format("variable {} is unusable at {}", variable, when.label);
    const std::size_t there = repairs.condensate + repairs.impossible;
    const double share =
        there == 0 ? 0.0 : static_cast<double>(repairs.impossible) / static_cast<double>(there);
    if (share > kMostImpossible && !repairs.hasMark()) {
        const Cause cause = causeOf(repairs);
        throw Error({.where = when.file.string(),
                     .what = what,
                     .found = fmt::format("{} of {} values with condensate are impossible, such as "
                                          "{:g} kg/kg",
                                          repairs.impossible, there, repairs.mark),
                     .expected = cause.expected,
                     .hint = cause.hint});
    }
    // No model has as much that is next to nothing and as little that is not.
    if (repairs.hidden > std::max(repairs.condensate, kFewestHidden) &&
        nearlyAll(repairs.hidden, repairs.vanishing)) {
        Repairs swapped = repairs;
        swapped.swappable = swapped.impossible;
        const Cause cause = causeOf(swapped);
        throw Error({.where = when.file.string(),
                     .what = what,
                     .found = fmt::format("{} values are not zero but below {:g} kg/kg",
                                          repairs.vanishing, kVanishing),
                     .expected = cause.expected,
                     .hint = cause.hint});
    }
}

void requireValues(std::span<const Repairs> fields, const Dataset& dataset, int time) {
    if (fields.empty() || !std::ranges::all_of(fields, &Repairs::nothing)) return;
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    throw Error({.where = when.file.string(),
                 .what = fmt::format("no hydrometeor has a value at {}", when.label),
                 .found = "missing values only",
                 .expected = "mixing ratios, zero where there is no cloud",
                 .hint = "the time was probably not written to its end: leave it out"});
}

std::vector<std::string> describe(const Repairs& repairs, std::string_view variable) {
    std::vector<std::string> notes;
    const auto count = [](std::size_t n, std::string_view kind) {
        return fmt::format("{} {} value{}", n, kind, n == 1 ? "" : "s");
    };
    if (repairs.nothing()) {
        notes.push_back(fmt::format("{}: all {} values are missing: nothing of it is shown.",
                                    variable, repairs.values));
        return notes;
    }
    if (repairs.negative > 0) {
        notes.push_back(fmt::format("{}: {} clipped (smallest {:.3g} kg/kg).", variable,
                                    count(repairs.negative, "negative"), repairs.smallest));
    }
    if (repairs.missing > 0) {
        notes.push_back(fmt::format("{}: {} (NaN) taken as zero.", variable,
                                    count(repairs.missing, "missing")));
    }
    if (repairs.impossible > 0) {
        const std::string mark =
            repairs.hasMark()
                ? fmt::format("{:g} kg/kg, probably a mark for missing values", repairs.mark)
                : fmt::format("beyond {:g} kg/kg", kMostRatioKgPerKg);
        notes.push_back(fmt::format("{}: {} ({}) taken as zero.", variable,
                                    count(repairs.impossible, "impossible"), mark));
    }
    return notes;
}

}  // namespace neph
