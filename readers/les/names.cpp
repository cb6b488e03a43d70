// names.cpp: the table of names. Sources: CM1's param.F and writeout.F (cm1r21.1), WRF's Registry
// (V4), the variables of ARWpost, SAM's and NCEP's names of hydrometeors.
#include "readers/les/names.h"

#include <algorithm>
#include <array>

#include "readers/les/text.h"

namespace les {
namespace {

constexpr KnownVariable mixing(std::string_view name, NephSpecies species,
                               std::string_view standardName = {}) {
    return {name, NEPH_ROLE_MIXING_RATIO, species, Quantity::ratio, standardName};
}
constexpr KnownVariable number(std::string_view name, NephSpecies species) {
    return {name, NEPH_ROLE_NUMBER_CONCENTRATION, species, Quantity::number};
}
constexpr KnownVariable radius(std::string_view name, NephSpecies species,
                               std::string_view standardName = {}) {
    return {name, NEPH_ROLE_EFFECTIVE_RADIUS, species, Quantity::radius, standardName};
}
constexpr KnownVariable air(std::string_view name, NephRole role, Quantity quantity,
                            std::string_view standardName = {}, Use use = Use::none) {
    return {name, role, NEPH_SPECIES_NONE, quantity, standardName, use};
}
constexpr std::string_view kTheta = "air_potential_temperature";
constexpr std::string_view kVapour = "humidity_mixing_ratio";

constexpr std::array kKnownVariables{
    mixing("qc", NEPH_SPECIES_CLOUD, "cloud_liquid_water_mixing_ratio"),
    mixing("ql", NEPH_SPECIES_CLOUD),
    mixing("qcloud", NEPH_SPECIES_CLOUD, "cloud_liquid_water_mixing_ratio"),
    mixing("qcl", NEPH_SPECIES_CLOUD),
    mixing("clwmr", NEPH_SPECIES_CLOUD),
    mixing("qr", NEPH_SPECIES_RAIN),
    mixing("qrain", NEPH_SPECIES_RAIN),
    mixing("qpl", NEPH_SPECIES_RAIN),
    mixing("rwmr", NEPH_SPECIES_RAIN),
    mixing("qi", NEPH_SPECIES_ICE, "cloud_ice_mixing_ratio"),
    mixing("qi1", NEPH_SPECIES_ICE),
    mixing("qi2", NEPH_SPECIES_ICE),
    mixing("qi3", NEPH_SPECIES_ICE),
    mixing("qi4", NEPH_SPECIES_ICE),
    mixing("qice", NEPH_SPECIES_ICE, "cloud_ice_mixing_ratio"),
    mixing("qice2", NEPH_SPECIES_ICE),
    mixing("qice3", NEPH_SPECIES_ICE),
    mixing("qicec", NEPH_SPECIES_ICE),
    mixing("qiced", NEPH_SPECIES_ICE),
    mixing("qicep", NEPH_SPECIES_ICE),
    mixing("qci", NEPH_SPECIES_ICE),
    mixing("icmr", NEPH_SPECIES_ICE),
    mixing("qs", NEPH_SPECIES_SNOW),
    mixing("qsnow", NEPH_SPECIES_SNOW),
    mixing("qpi", NEPH_SPECIES_SNOW),
    mixing("snmr", NEPH_SPECIES_SNOW),
    mixing("qg", NEPH_SPECIES_GRAUPEL),
    mixing("qgraup", NEPH_SPECIES_GRAUPEL),
    mixing("qgraupel", NEPH_SPECIES_GRAUPEL),
    mixing("grle", NEPH_SPECIES_GRAUPEL),
    mixing("qh", NEPH_SPECIES_HAIL),
    mixing("qhl", NEPH_SPECIES_HAIL),
    mixing("qhail", NEPH_SPECIES_HAIL),
    mixing("hail", NEPH_SPECIES_HAIL),
    number("ncc", NEPH_SPECIES_CLOUD),
    number("nc", NEPH_SPECIES_CLOUD),
    number("qnc", NEPH_SPECIES_CLOUD),
    number("ccw", NEPH_SPECIES_CLOUD),
    number("qncloud", NEPH_SPECIES_CLOUD),
    number("ncr", NEPH_SPECIES_RAIN),
    number("nr", NEPH_SPECIES_RAIN),
    number("qnr", NEPH_SPECIES_RAIN),
    number("crw", NEPH_SPECIES_RAIN),
    number("qnrain", NEPH_SPECIES_RAIN),
    number("nci", NEPH_SPECIES_ICE),
    number("ni", NEPH_SPECIES_ICE),
    number("ni1", NEPH_SPECIES_ICE),
    number("ni2", NEPH_SPECIES_ICE),
    number("ni3", NEPH_SPECIES_ICE),
    number("ni4", NEPH_SPECIES_ICE),
    number("qni", NEPH_SPECIES_ICE),
    number("cci", NEPH_SPECIES_ICE),
    number("qnice", NEPH_SPECIES_ICE),
    number("qnice2", NEPH_SPECIES_ICE),
    number("qnice3", NEPH_SPECIES_ICE),
    number("ncs", NEPH_SPECIES_SNOW),
    number("csw", NEPH_SPECIES_SNOW),
    number("qnsnow", NEPH_SPECIES_SNOW),
    number("ncg", NEPH_SPECIES_GRAUPEL),
    number("chw", NEPH_SPECIES_GRAUPEL),
    number("qngraupel", NEPH_SPECIES_GRAUPEL),
    number("chl", NEPH_SPECIES_HAIL),
    number("qnhail", NEPH_SPECIES_HAIL),
    radius("effc", NEPH_SPECIES_CLOUD, "effective_radius_of_cloud_liquid_water_particles"),
    radius("effr", NEPH_SPECIES_RAIN),
    radius("effi", NEPH_SPECIES_ICE),
    radius("effs", NEPH_SPECIES_SNOW),
    radius("effg", NEPH_SPECIES_GRAUPEL),
    radius("re_cloud", NEPH_SPECIES_CLOUD),
    radius("re_ice", NEPH_SPECIES_ICE),
    radius("re_snow", NEPH_SPECIES_SNOW),
    air("prs", NEPH_ROLE_AIR_PRESSURE, Quantity::pressure, "air_pressure"),
    air("pres", NEPH_ROLE_AIR_PRESSURE, Quantity::pressure, "air_pressure"),
    air("pressure", NEPH_ROLE_AIR_PRESSURE, Quantity::pressure, "air_pressure"),
    air("tk", NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"),
    air("tc", NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"),
    air("tabs", NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"),
    air("tmp", NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"),
    air("temp", NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"),
    air("rho", NEPH_ROLE_DRY_AIR_DENSITY, Quantity::density),
    air("th", NEPH_ROLE_OTHER, Quantity::temperature, kTheta, Use::potentialTemperature),
    air("theta", NEPH_ROLE_OTHER, Quantity::temperature, kTheta, Use::potentialTemperature),
    air("qv", NEPH_ROLE_WATER_VAPOUR, Quantity::ratio, kVapour, Use::vapour),
    air("qvapor", NEPH_ROLE_WATER_VAPOUR, Quantity::ratio, kVapour, Use::vapour),
    air("uinterp", NEPH_ROLE_X_WIND, Quantity::speed, "x_wind"),
    air("vinterp", NEPH_ROLE_Y_WIND, Quantity::speed, "y_wind"),
    air("winterp", NEPH_ROLE_UPWARD_WIND, Quantity::speed, "upward_air_velocity"),
    air("zs", NEPH_ROLE_OTHER, Quantity::length, "surface_altitude", Use::ground),
    air("zh", NEPH_ROLE_OTHER, Quantity::length, "altitude", Use::cellHeight),
    air("zhval", NEPH_ROLE_OTHER, Quantity::length, "altitude", Use::cellHeight),
    air("height", NEPH_ROLE_OTHER, Quantity::length, "altitude", Use::cellHeight),
};

/// Names that begin with these are no hydrometeors: vapour, total and saturation values, and rime.
constexpr std::array<std::string_view, 8> kNoHydrometeors{"qv",  "qt",   "qsat", "qsfc",
                                                          "qir", "qrim", "qib",  "qzi"};

}  // namespace

std::span<const KnownVariable> knownVariables() {
    return kKnownVariables;
}

const KnownVariable* findKnown(std::string_view name) {
    const std::string spelling = toLower(name);
    const auto found = std::ranges::find(kKnownVariables, spelling, &KnownVariable::name);
    return found == kKnownVariables.end() ? nullptr : &*found;
}

bool addsUp(std::string_view name) {
    const KnownVariable* known = findKnown(name);
    return known != nullptr &&
           (known->species == NEPH_SPECIES_ICE || known->species == NEPH_SPECIES_HAIL);
}

bool looksLikeHydrometeor(std::string_view name) {
    const std::string spelling = toLower(name);
    return spelling.starts_with('q') && spelling.size() > 1 &&
           std::ranges::none_of(kNoHydrometeors, [&](std::string_view start) {
               return spelling.starts_with(start);
           });
}

std::string knownHydrometeors() {
    return "qc or ql, qr, qi, qs, qg, qh or qhl (CM1), QCLOUD, QRAIN, QICE, QSNOW, QGRAUP, QHAIL "
           "(WRF)";
}

const char* speciesName(NephSpecies species) {
    constexpr std::array kNames{"cloud water", "cloud ice", "rain", "snow", "graupel", "hail"};
    return species < 0 || species >= static_cast<int>(kNames.size())
               ? "no species"
               : kNames[static_cast<std::size_t>(species)];
}

}  // namespace les
