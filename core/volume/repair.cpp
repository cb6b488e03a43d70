// repair.cpp: clips mixing ratios to what is physically possible.
#include "core/volume/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

/// More condensate than air cannot be real; storms reach about 0.03 kg/kg at most.
constexpr float kImpossibleRatio = 1.0f;

}  // namespace

Repairs& Repairs::operator+=(const Repairs& part) {
    negative += part.negative;
    missing += part.missing;
    impossible += part.impossible;
    smallest = std::min(smallest, part.smallest);
    allZero = allZero && part.allZero;
    return *this;
}

Repairs repair(Array3f& mixingRatio) {
    Repairs repairs;
    for (float& q : mixingRatio.values) {
        if (q == 0.0f) continue;
        if (q > 0.0f && q <= kImpossibleRatio) {
            repairs.allZero = false;
            continue;
        }
        if (!std::isfinite(q)) {
            ++repairs.missing;
        } else if (q < 0.0f) {
            ++repairs.negative;
            repairs.smallest = std::min(repairs.smallest, q);
        } else {
            ++repairs.impossible;
        }
        q = 0.0f;
    }
    return repairs;
}

std::vector<std::string> describe(const Repairs& repairs, std::string_view variable) {
    std::vector<std::string> notes;
    const auto count = [](std::size_t n, std::string_view kind) {
        return fmt::format("{} {} value{}", n, kind, n == 1 ? "" : "s");
    };
    if (repairs.negative > 0) {
        notes.push_back(fmt::format("{}: {} clipped (smallest {:.3g} kg/kg).", variable,
                                    count(repairs.negative, "negative"), repairs.smallest));
    }
    if (repairs.missing > 0) {
        notes.push_back(fmt::format("{}: {} (NaN or infinite) taken as zero.", variable,
                                    count(repairs.missing, "missing")));
    }
    if (repairs.impossible > 0) {
        notes.push_back(fmt::format("{}: {} above 1 kg/kg taken as zero.", variable,
                                    count(repairs.impossible, "impossible")));
    }
    return notes;
}

}  // namespace neph
