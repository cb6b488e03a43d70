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
constexpr Limits kVapour{NEPH_LEAST_VAPOUR_KG_PER_KG, NEPH_MOST_VAPOUR_KG_PER_KG, "kg/kg"};
// A hundred times what `gt_aod` of [WRF] counts at most; advection leaves values below zero.
constexpr Limits kAerosol{-1e9, 1e13, "per kg"};

// Density falls by a factor e in this height, from that at the ground, within a fifth of the
// standard atmosphere's up to 20 km and a factor of 1.3 up to 80 km. [USSA76]
constexpr double kScaleHeightM = 7200.0;
constexpr double kGroundDensityKgPerM3 = 1.225;
// No weather makes air that much denser or thinner at its height, but a wrong unit does: of
// pressure by 100, of heights by 1000.
constexpr double kMostDeviation = 5.0;

/// A value outside its limits that would be plausible in another unit.
struct WrongUnit {
    VariableRole role;
    double least, most;
    std::string_view hint;
};
constexpr std::array kWrongUnits{
    WrongUnit{VariableRole::airTemperature, -95.0, 65.0,
              "the temperature is probably in °C: correct the attribute units of the file"},
    WrongUnit{VariableRole::airTemperature, 400.0, 1000.0,
              "a potential temperature is probably taken for its deviation from 300 K: correct the "
              "variable, or name it as what it is"},
    WrongUnit{VariableRole::waterVapour, 0.1, 60.0,
              "water vapour is probably in g/kg: correct the attribute units of the file"},
};

std::optional<Limits> limitsOf(VariableRole role) {
    if (role == VariableRole::airPressure) return kPressure;
    if (role == VariableRole::airTemperature) return kTemperature;
    if (role == VariableRole::dryAirDensity) return kDensity;
    if (role == VariableRole::waterVapour) return kVapour;
    if (role == VariableRole::hygroscopicAerosolNumber || role == VariableRole::dustNumber) {
        return kAerosol;
    }
    return {};
}

std::string valueText(float value, const char* unit) {
    return std::isnan(value) ? "missing" : fmt::format("{:g} {}", value, unit);
}

/// What is wrong in one cell.
struct Fault {
    std::string cause;        ///< "air_pressure is missing there"; empty if nothing explains it
    bool otherOrder = false;  ///< possible if the bytes are swapped
    std::string_view unit{};  ///< the hint if another unit is likely
};

/// Whether a value is possible with its bytes swapped; a missing one tells nothing.
bool fitsSwapped(float value, const Limits& limits) {
    return !std::isnan(value) && limits.allow(bytesSwapped(value));
}

std::string_view unitHint(VariableRole role, float value) {
    const auto v = static_cast<double>(value);
    for (const WrongUnit& wrong : kWrongUnits) {
        if (wrong.role == role && v >= wrong.least && v <= wrong.most) return wrong.hint;
    }
    return {};
}

/// The first of the quantities that a density is made of which is impossible in `cell`.
Fault faultOf(Dataset& dataset, int time, glm::ivec3 cell) {
    const DatasetInfo info = dataset.infoAt(time);
    const auto vapour =
        std::ranges::find(info.variables, "humidity_mixing_ratio", &VariableInfo::standardName);
    struct Part {
        const VariableInfo* variable;
        VariableRole as;  // readers of version 1 had no role for vapour
    };
    const std::array<Part, 3> made{
        {{info.find(VariableRole::airPressure), VariableRole::airPressure},
         {info.find(VariableRole::airTemperature), VariableRole::airTemperature},
         {vapour == info.variables.end() ? nullptr : &*vapour, VariableRole::waterVapour}}};
    for (const auto& [variable, as] : made) {
        if (variable == nullptr) continue;
        CellBox one{glm::min(cell, variable->size - 1), {}};
        one.upper = one.lower + 1;
        const float value = dataset.read(variable->name, time, one).values.front();
        const Limits limits = *limitsOf(as);
        if (limits.allow(value)) continue;
        return {fmt::format("{} is {} there", variable->name, valueText(value, limits.unit)),
                // Next to any number is one near 0 with its bytes swapped, which vapour may be.
                as != VariableRole::waterVapour && fitsSwapped(value, limits), unitHint(as, value)};
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
    const bool swapped = variable.role != VariableRole::waterVapour && fitsSwapped(*bad, *limits);
    Fault fault{"", swapped, unitHint(variable.role, *bad)};
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
         .hint = !fault.unit.empty() ? std::string(fault.unit)
                 : fault.otherOrder
                     ? "with its bytes in the opposite order the value is possible: state the byte "
                       "order (big_endian or little_endian in a .ctl, byte_order in a sidecar)"
                     : "the run blew up, the file is damaged, or it marks missing values in a way "
                       "that it does not state: leave this time out, or mend the file"});
}

void requireAirOfHeight(Dataset& dataset, int time, const ColumnField& heights,
                        const ColumnField& density) {
    const std::size_t columns =
        heights.profile || density.profile
            ? 1
            : density.values.values.size() / static_cast<std::size_t>(density.values.size.z);
    const auto levels = static_cast<std::size_t>(density.values.size.z);
    for (std::size_t k = 0; k < levels; ++k) {
        for (std::size_t c = 0; c < columns; ++c) {
            const double heightM = 0.5 * (static_cast<double>(heights.at(c, k)) +
                                          static_cast<double>(heights.at(c, k + 1)));
            const double usual = kGroundDensityKgPerM3 * std::exp(-heightM / kScaleHeightM);
            const auto found = static_cast<double>(density.at(c, k));
            if (found <= kMostDeviation * usual && kMostDeviation * found >= usual) continue;
            const TimeInfo& when = dataset.info().times.at(static_cast<std::size_t>(time));
            throw Error(
                {.where = when.file.string(),
                 .what =
                     fmt::format("the density of air does not fit its height at {}", when.label),
                 .found = fmt::format("{:.3g} kg/m3 at {:.0f} m above sea level", found, heightM),
                 .expected = fmt::format("about {:.2g} kg/m3, at most {:.0f} times more or less",
                                         usual, kMostDeviation),
                 .hint =
                     "the unit of pressure (hPa or Pa), of heights (km or m) or of water vapour "
                     "(g/kg or kg/kg) is probably not what the file states: correct it"});
        }
    }
}

}  // namespace neph
