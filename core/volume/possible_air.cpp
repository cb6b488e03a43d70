// possible_air.cpp: finds the first impossible value, and what is to blame for it.
#include "core/volume/possible_air.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/plugin/reader_abi.h"

namespace neph {
namespace {

/// The range of a quantity, in `unit`.
struct Limits {
    double least, most;
    const char* unit;

    bool allow(float value) const {
        const auto v = static_cast<double>(value);
        return v >= least && v <= most;  // false for NaN
    }
    std::string text() const { return fmt::format("{:g} to {:g} {}", least, most, unit); }
};

constexpr Limits kPressure{NEPH_LEAST_PRESSURE_PA, NEPH_MOST_PRESSURE_PA, "Pa"};
constexpr Limits kTemperature{NEPH_LEAST_TEMPERATURE_K, NEPH_MOST_TEMPERATURE_K, "K"};
constexpr Limits kDensity{NEPH_LEAST_DENSITY_KG_PER_M3, NEPH_MOST_DENSITY_KG_PER_M3, "kg/m3"};
// Only to explain a density: a little below zero is noise of the model's advection.
constexpr Limits kVapour{-0.1, 1.0, "kg/kg"};

std::optional<Limits> limitsOf(VariableRole role) {
    if (role == VariableRole::airPressure) return kPressure;
    if (role == VariableRole::airTemperature) return kTemperature;
    if (role == VariableRole::dryAirDensity) return kDensity;
    return {};
}

std::string valueText(float value, const char* unit) {
    return std::isnan(value) ? "missing" : fmt::format("{:g} {}", value, unit);
}

/// What is wrong in one cell.
struct Fault {
    std::string cause;        ///< "air_pressure is missing there"; empty if nothing explains it
    bool otherOrder = false;  ///< possible if the bytes are swapped
};

/// The first of the quantities that a density is made of which is impossible in `cell`.
Fault faultOf(Dataset& dataset, int time, glm::ivec3 cell) {
    const DatasetInfo info = dataset.infoAt(time);
    const auto vapour =
        std::ranges::find(info.variables, "humidity_mixing_ratio", &VariableInfo::standardName);
    const std::array<std::pair<const VariableInfo*, Limits>, 3> made{
        {{info.find(VariableRole::airPressure), kPressure},
         {info.find(VariableRole::airTemperature), kTemperature},
         {vapour == info.variables.end() ? nullptr : &*vapour, kVapour}}};
    for (const auto& [variable, limits] : made) {
        if (variable == nullptr) continue;
        CellBox one{glm::min(cell, variable->size - 1), {}};
        one.upper = one.lower + 1;
        const float value = dataset.read(variable->name, time, one).values.front();
        if (limits.allow(value)) continue;
        return {fmt::format("{} is {} there", variable->name, valueText(value, limits.unit)),
                limits.allow(bytesSwapped(value))};
    }
    return {};
}

}  // namespace

float bytesSwapped(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return std::bit_cast<float>((bits << 24U) | ((bits & 0xFF00U) << 8U) |
                                ((bits >> 8U) & 0xFF00U) | (bits >> 24U));
}

void requirePossibleAir(Dataset& dataset, int time, const VariableInfo& variable,
                        const CellBox& box, const Array3f& field) {
    const std::optional<Limits> limits = limitsOf(variable.role);
    if (!limits) return;
    const auto bad =
        std::ranges::find_if(field.values, [&](float value) { return !limits->allow(value); });
    if (bad == field.values.end()) return;
    const auto index = static_cast<std::size_t>(bad - field.values.begin());
    const auto width = static_cast<std::size_t>(field.size.x);
    const std::size_t layer = field.index(0, 0, 1);
    const glm::ivec3 cell =
        box.lower + glm::ivec3(index % width, index % layer / width, index / layer);
    Fault fault{"", limits->allow(bytesSwapped(*bad))};
    if (variable.role == VariableRole::dryAirDensity && !fault.otherOrder) {
        fault = faultOf(dataset, time, cell);
    }
    const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
    throw Error(
        {.where = when.file.string(),
         .what = fmt::format("variable {} is unusable at {}", variable.name, when.label),
         .found = fmt::format("{} in cell x {}, y {}, level {}{}{}{}",
                              valueText(*bad, limits->unit), cell.x, cell.y, cell.z,
                              variable.description.empty() ? "" : " (" + variable.description + ")",
                              fault.cause.empty() ? "" : ": ", fault.cause),
         .expected = limits->text(),
         .hint = fault.otherOrder
                     ? "with its bytes in the opposite order the value is possible: state the byte "
                       "order (big_endian or little_endian in a .ctl, byte_order in a sidecar)"
                     : "the run blew up, the file is damaged, or it marks missing values in a way "
                       "that it does not state: leave this time out, or mend the file"});
}

}  // namespace neph
