// quantity.h: what can be asked of the air and of what floats in it, cell by cell.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/plugin/dataset_info.h"

namespace neph {

/// Values are indices into kQuantities; the first six are the species'.
enum class Quantity : int {
    cloud,
    ice,
    rain,
    snow,
    graupel,
    hail,
    condensate,
    vapour,
    upwardWind,
    windSpeed,
    xWind,
    yWind,
    vorticity,
    temperature,
    theta,
    thetaE,
    humidity,
    pressure,
    reflectivity
};

/// How the values of a quantity are coloured.
enum class Colouring : int { fromZero, aroundZero, range };

struct QuantityInfo {
    Quantity quantity;
    std::string_view id;     ///< as on the command line
    std::string_view label;  ///< as on screen
    std::string_view unit;   ///< of the values
    Colouring colouring;
};

inline constexpr auto kQuantities = std::to_array<QuantityInfo>({
    {Quantity::cloud, "cloud", "Cloud water", "g/kg", Colouring::fromZero},
    {Quantity::ice, "ice", "Cloud ice", "g/kg", Colouring::fromZero},
    {Quantity::rain, "rain", "Rain", "g/kg", Colouring::fromZero},
    {Quantity::snow, "snow", "Snow", "g/kg", Colouring::fromZero},
    {Quantity::graupel, "graupel", "Graupel", "g/kg", Colouring::fromZero},
    {Quantity::hail, "hail", "Hail", "g/kg", Colouring::fromZero},
    {Quantity::condensate, "condensate", "Condensate", "g/kg", Colouring::fromZero},
    {Quantity::vapour, "vapour", "Water vapour", "g/kg", Colouring::fromZero},
    {Quantity::upwardWind, "w", "Upward wind", "m/s", Colouring::aroundZero},
    {Quantity::windSpeed, "wind_speed", "Wind speed", "m/s", Colouring::fromZero},
    {Quantity::xWind, "u", "Wind along x", "m/s", Colouring::aroundZero},
    {Quantity::yWind, "v", "Wind along y", "m/s", Colouring::aroundZero},
    {Quantity::vorticity, "vorticity", "Vertical vorticity", "10⁻³/s", Colouring::aroundZero},
    {Quantity::temperature, "temperature", "Temperature", "°C", Colouring::range},
    {Quantity::theta, "theta", "Potential temperature", "K", Colouring::range},
    {Quantity::thetaE, "theta_e", "Equivalent potential temperature", "K", Colouring::range},
    {Quantity::humidity, "rh", "Relative humidity over water", "%", Colouring::fromZero},
    {Quantity::pressure, "pressure", "Pressure", "hPa", Colouring::range},
    {Quantity::reflectivity, "reflectivity", "Reflectivity of the model", "dBZ", Colouring::range},
});

constexpr const QuantityInfo& info(Quantity quantity) {
    return kQuantities[static_cast<std::size_t>(quantity)];
}

/// The quantity of an id; nothing where there is none.
std::optional<Quantity> quantityOf(std::string_view id);

/// All ids, with commas between them.
std::string quantityIds();

/// Why a quantity cannot be had from these data ("they have no wind along x"); empty where it can.
std::string lackOf(Quantity quantity, const DatasetInfo& info);

/// The model's own reflectivity; nullptr where there is none.
const VariableInfo* reflectivityOf(const DatasetInfo& info);

/// Roles that a quantity is computed from, hydrometeors aside.
std::vector<VariableRole> rolesOf(Quantity quantity);

}  // namespace neph
