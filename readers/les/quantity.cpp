// quantity.cpp: one row for each quantity.
#include "readers/les/quantity.h"

#include <array>
#include <cmath>
#include <string>

#include "core/plugin/reader_abi.h"
#include "readers/les/text.h"

namespace les {
namespace {

struct QuantityRow {
    Quantity quantity;
    const char* unit;
    const char* accepted;
    double least, most;  ///< of possible values
};
// Mixing ratios: advection leaves small negative values and positive ones down to about 1e-20.
// Potential temperature exceeds 1000 K in the upper stratosphere.
constexpr std::array kQuantities{
    QuantityRow{Quantity::ratio, "kg kg-1", "kg/kg or g/kg", -1e-3, 1.0},
    QuantityRow{Quantity::density, "kg m-3", "kg/m3 or g/m3", NEPH_LEAST_DENSITY_KG_PER_M3,
                NEPH_MOST_DENSITY_KG_PER_M3},
    QuantityRow{Quantity::pressure, "Pa", "Pa or hPa", NEPH_LEAST_PRESSURE_PA,
                NEPH_MOST_PRESSURE_PA},
    QuantityRow{Quantity::temperature, "K", "K or degC", NEPH_LEAST_TEMPERATURE_K, 5000.0},
    QuantityRow{Quantity::radius, "m", "m or micron", 0.0, 0.1},
    QuantityRow{Quantity::number, "kg-1", "#/kg or 1/kg", -1.0, 1e16},
    QuantityRow{Quantity::length, "m", "m or km", -1000.0, 1e6},
    QuantityRow{Quantity::speed, "m s-1", "m/s or cm/s", -500.0, 500.0},
};
constexpr double kLeastMagnitude = 1e-24;

const QuantityRow& rowOf(Quantity quantity) {
    return kQuantities[static_cast<std::size_t>(quantity)];
}

}  // namespace

std::optional<shared::Conversion> toSi(Quantity quantity, std::string_view unit) {
    const std::string wanted = siUnit(quantity);
    std::string spelling(trimmed(unit));
    if (spelling.starts_with('/')) spelling.insert(0, "1");
    if (auto found = shared::conversion(spelling, wanted)) return found;
    std::string small = toLower(spelling);
    if (quantity == Quantity::pressure && small.ends_with("pa")) {
        small.replace(small.size() - 2, 2, "Pa");
    }
    return shared::conversion(small, wanted);
}

const char* siUnit(Quantity quantity) {
    return rowOf(quantity).unit;
}

const char* acceptedUnits(Quantity quantity) {
    return rowOf(quantity).accepted;
}

bool isPossible(Quantity quantity, double value) {
    const QuantityRow& row = rowOf(quantity);
    return value >= row.least && value <= row.most && std::abs(value) >= kLeastMagnitude;
}

}  // namespace les
