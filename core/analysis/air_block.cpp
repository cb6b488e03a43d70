// air_block.cpp: reads fields of columns, and computes quantities of their cells.
#include "core/analysis/air_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/air/thermodynamics.h"
#include "core/base/error.h"
#include "core/sky/humidity.h"

namespace neph {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr double kGramsPerKg = 1e3;

bool wants(std::span<const Quantity> quantities, Quantity one) {
    return std::ranges::find(quantities, one) != quantities.end();
}

double centreOf(const DatasetInfo& info, int axis, int cell) {
    return 0.5 * (info.edgeM(axis, cell) + info.edgeM(axis, cell + 1));
}

}  // namespace

void requireQuantity(const Dataset& dataset, int time, Quantity quantity) {
    const std::string lack = lackOf(quantity, dataset.infoAt(time));
    if (lack.empty()) return;
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    std::string possible;
    for (const QuantityInfo& row : kQuantities) {
        if (!lackOf(row.quantity, dataset.infoAt(time)).empty()) continue;
        possible += fmt::format("{}{}", possible.empty() ? "" : ", ", row.id);
    }
    throw Error({.where = when.file.string(),
                 .what = fmt::format("{} cannot be had from these data", info(quantity).id),
                 .found = fmt::format("at {}: {}", when.label, lack),
                 .expected = "one of " + possible,
                 .hint = "write the missing variable with the model's output"});
}

AirBlock::AirBlock(Dataset& dataset, int time, const CellBox& columns,
                   std::span<const Quantity> quantities, const Progress& progress)
    : info_(dataset.infoAt(time)), box_(columns), levels_(dataset.info().size.z) {
    for (const Quantity quantity : quantities) requireQuantity(dataset, time, quantity);
    if (wants(quantities, Quantity::vorticity)) {
        const glm::ivec2 size(info_.size);
        for (int axis = 0; axis < 2; ++axis) {
            box_.lower[axis] = std::max(box_.lower[axis] - 1, 0);
            box_.upper[axis] = std::min(box_.upper[axis] + 1, size[axis]);
        }
    }
    box_.lower.z = 0;
    box_.upper.z = levels_;
    heights_ = readHeights(dataset, time, box_, progress);
    Repairs repairs;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const VariableInfo* variable =
            info_.find(VariableRole::mixingRatio, static_cast<Species>(s));
        const bool wanted =
            wants(quantities, static_cast<Quantity>(s)) || wants(quantities, Quantity::condensate);
        if (variable == nullptr || !wanted) continue;
        ratios_[static_cast<std::size_t>(s)] =
            ColumnField{readRatio(dataset, *variable, time, box_, repairs, progress)};
    }
    for (const Quantity quantity : quantities) {
        for (const VariableRole role : rolesOf(quantity)) {
            if (air_.contains(role)) continue;
            air_[role] = readColumns(dataset, *info_.find(role), time, box_, progress);
        }
    }
    if (wants(quantities, Quantity::reflectivity)) {
        reflectivity_ = readColumns(dataset, *reflectivityOf(info_), time, box_, progress);
    }
}

double AirBlock::at(const ColumnField& field, glm::ivec3 cell) const {
    const glm::ivec3 own = cell - box_.lower;
    const auto column = static_cast<std::size_t>(own.x + own.y * box_.size().x);
    return static_cast<double>(field.at(column, static_cast<std::size_t>(own.z)));
}

double AirBlock::role(VariableRole role, glm::ivec3 cell) const {
    return at(air_.at(role), cell);
}

double AirBlock::condensate(glm::ivec3 cell) const {
    double sum = 0.0;
    for (const auto& ratio : ratios_) {
        if (ratio) sum += at(*ratio, cell);
    }
    return sum;
}

double AirBlock::slope(VariableRole component, int axis, glm::ivec3 cell) const {
    glm::ivec3 before = cell, after = cell;
    before[axis] = std::max(cell[axis] - 1, 0);
    after[axis] = std::min(cell[axis] + 1, info_.size[axis] - 1);
    if (before == after) return 0.0;
    return (role(component, after) - role(component, before)) /
           (centreOf(info_, axis, after[axis]) - centreOf(info_, axis, before[axis]));
}

double AirBlock::vorticity(glm::ivec3 cell) const {
    return slope(VariableRole::yWind, 0, cell) - slope(VariableRole::xWind, 1, cell);
}

double AirBlock::value(Quantity quantity, glm::ivec3 cell) const {
    using enum VariableRole;
    const auto air = [&](VariableRole of) { return role(of, cell); };
    switch (quantity) {
        case Quantity::condensate:
            return kGramsPerKg * condensate(cell);
        case Quantity::vapour:
            return kGramsPerKg * air(waterVapour);
        case Quantity::upwardWind:
            return air(upwardWind);
        case Quantity::xWind:
            return air(xWind);
        case Quantity::yWind:
            return air(yWind);
        case Quantity::windSpeed:
            return std::hypot(air(xWind), air(yWind));
        case Quantity::vorticity:
            return 1e3 * vorticity(cell);
        case Quantity::temperature:
            return air(airTemperature) - kFreezingK;
        case Quantity::theta:
            return potentialTemperatureK(air(airPressure), air(airTemperature));
        case Quantity::thetaE:
            return equivalentPotentialTemperatureK(air(airPressure), air(airTemperature),
                                                   air(waterVapour));
        case Quantity::humidity:
            return 100.0 *
                   relativeHumidity(air(airPressure), air(airTemperature), air(waterVapour));
        case Quantity::pressure:
            return 0.01 * air(airPressure);
        case Quantity::reflectivity:
            return at(*reflectivity_, cell);
        default:
            return kGramsPerKg * at(*ratios_[static_cast<std::size_t>(quantity)], cell);
    }
}

double AirBlock::faceM(glm::ivec2 column, int face) const {
    return at(heights_, {column, face});
}

double AirBlock::middleM(glm::ivec3 cell) const {
    return 0.5 * (at(heights_, cell) + at(heights_, cell + glm::ivec3(0, 0, 1)));
}

AirBlock::Level AirBlock::levelAt(glm::ivec2 column, double heightM) const {
    if (heightM < faceM(column, 0) || heightM > faceM(column, levels_)) return {};
    int lower = 0, upper = levels_ - 1;
    if (heightM <= middleM({column, lower})) return {lower, 0.0, true};
    if (heightM >= middleM({column, upper})) return {upper, 0.0, true};
    while (upper - lower > 1) {
        const int middle = (lower + upper) / 2;
        (middleM({column, middle}) <= heightM ? lower : upper) = middle;
    }
    const double from = middleM({column, lower}), to = middleM({column, upper});
    return {lower, (heightM - from) / (to - from), true};
}

double AirBlock::valueAtHeight(Quantity quantity, glm::ivec2 column, double heightM) const {
    const Level at = levelAt(column, heightM);
    if (!at.inside) return kMissing;
    const double below = value(quantity, {column, at.level});
    if (at.share == 0.0) return below;
    return std::lerp(below, value(quantity, {column, at.level + 1}), at.share);
}

}  // namespace neph
