// meanings.cpp: what variables are: units, words for messages, and the standard names of CF.
#include "readers/cf_les/models.h"
#include "readers/les/names.h"

namespace cf {
namespace {

Name standard(const char* name, Meaning meaning, NephSpecies species = NEPH_SPECIES_NONE,
              bool perMoistAir = false) {
    return {"", meaning, species, "", false, name, perMoistAir};
}

}  // namespace

les::Quantity quantityOf(Meaning meaning) {
    using enum Meaning;
    switch (meaning) {
        case number:
            return les::Quantity::number;
        case radius:
            return les::Quantity::radius;
        case pressure:
        case basePressure:
        case pressureDeviation:
            return les::Quantity::pressure;
        case temperature:
        case theta:
        case baseTheta:
        case thetaDeviation:
        case liquidTheta:
            return les::Quantity::temperature;
        case dryDensity:
        case airDensity:
        case referenceDensity:
            return les::Quantity::density;
        case ground:
        case cellHeight:
            return les::Quantity::length;
        case xWind:
        case yWind:
        case upwardWind:
            return les::Quantity::speed;
        default:
            return les::Quantity::ratio;
    }
}

std::string meaningText(Meaning meaning, NephSpecies species) {
    using enum Meaning;
    switch (meaning) {
        case hydrometeor:
            return les::speciesName(species);
        case number:
            return std::string("the number of ") + les::speciesName(species) + " particles";
        case radius:
            return std::string("the effective radius of ") + les::speciesName(species);
        case pressure:
            return "pressure";
        case basePressure:
            return "pressure of the base state";
        case pressureDeviation:
            return "pressure less that of the base state";
        case temperature:
            return "temperature";
        case theta:
            return "potential temperature";
        case baseTheta:
            return "potential temperature of the base state";
        case thetaDeviation:
            return "potential temperature less that of the base state";
        case liquidTheta:
            return "liquid water potential temperature";
        case dryDensity:
            return "density of dry air";
        case airDensity:
            return "density of moist air";
        case referenceDensity:
            return "the model's reference density";
        case vapour:
            return "water vapour";
        case totalWater:
            return "vapour and cloud water together";
        case cloudCondensate:
            return "cloud water and ice together";
        case precipitation:
            return "rain, snow and graupel together";
        case ground:
            return "height of the ground";
        case cellHeight:
            return "heights of cells";
        case xWind:
            return "wind along x";
        case yWind:
            return "wind along y";
        case upwardWind:
            return "upward wind";
        case other:
            break;
    }
    return "no role";
}

const std::vector<Name>& standardNames() {
    using enum Meaning;
    static const std::vector<Name> table{
        standard("cloud_liquid_water_mixing_ratio", hydrometeor, NEPH_SPECIES_CLOUD),
        standard("cloud_ice_mixing_ratio", hydrometeor, NEPH_SPECIES_ICE),
        standard("mass_fraction_of_cloud_liquid_water_in_air", hydrometeor, NEPH_SPECIES_CLOUD,
                 true),
        standard("mass_fraction_of_cloud_ice_in_air", hydrometeor, NEPH_SPECIES_ICE, true),
        standard("mass_fraction_of_rain_in_air", hydrometeor, NEPH_SPECIES_RAIN, true),
        standard("mass_fraction_of_snow_in_air", hydrometeor, NEPH_SPECIES_SNOW, true),
        standard("mass_fraction_of_graupel_in_air", hydrometeor, NEPH_SPECIES_GRAUPEL, true),
        standard("mass_fraction_of_graupel_and_hail_in_air", hydrometeor, NEPH_SPECIES_GRAUPEL,
                 true),
        standard("mass_fraction_of_hail_in_air", hydrometeor, NEPH_SPECIES_HAIL, true),
        standard("number_concentration_of_cloud_liquid_water_particles_in_air", number,
                 NEPH_SPECIES_CLOUD),
        standard("number_concentration_of_ice_crystals_in_air", number, NEPH_SPECIES_ICE),
        standard("number_concentration_of_rain_drops_in_air", number, NEPH_SPECIES_RAIN),
        standard("effective_radius_of_cloud_liquid_water_particles", radius, NEPH_SPECIES_CLOUD),
        standard("effective_radius_of_cloud_ice_particles", radius, NEPH_SPECIES_ICE),
        standard("air_pressure", pressure),
        standard("air_temperature", temperature),
        standard("air_potential_temperature", theta),
        standard("air_density", airDensity),
        standard("humidity_mixing_ratio", vapour),
        standard("specific_humidity", vapour, NEPH_SPECIES_NONE, true),
        standard("surface_altitude", ground),
        standard("altitude", cellHeight),
        standard("x_wind", xWind),
        standard("y_wind", yWind),
        standard("upward_air_velocity", upwardWind)};
    return table;
}

}  // namespace cf
