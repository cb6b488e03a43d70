// models.cpp: the table of models. docs/readers.md shows it and says what was checked.
//
// Names, units and axes are those of the models' output routines: CM1 (writeout_nc.F, param.F,
// constants.F of r21.1), SAM (write_fields3D, micro_params, params), DALES (modfielddump,
// modglobal), UCLALES (ncio), MicroHH (3d_to_nc.py, constants.h), Meso-NH (its list of fields); of
// PALM and MONC those that programs rely on which read their files.
#include "readers/cf_les/models.h"

#include "readers/les/names.h"

namespace cf {
namespace {

constexpr auto kCloud = NEPH_SPECIES_CLOUD;
constexpr auto kIce = NEPH_SPECIES_ICE;
constexpr auto kRain = NEPH_SPECIES_RAIN;
constexpr auto kSnow = NEPH_SPECIES_SNOW;
constexpr auto kGraupel = NEPH_SPECIES_GRAUPEL;
constexpr auto kHail = NEPH_SPECIES_HAIL;
constexpr auto kNone = NEPH_SPECIES_NONE;
constexpr auto kWater = Meaning::hydrometeor;
constexpr const char* kEast = "x_wind";
constexpr const char* kNorth = "y_wind";
constexpr const char* kUp = "upward_air_velocity";

Name wind(const char* name, std::string_view standardName) {
    const Meaning meaning = standardName == kEast    ? Meaning::xWind
                            : standardName == kNorth ? Meaning::yWind
                                                     : Meaning::upwardWind;
    return {name, meaning, kNone, "m s-1", false, std::string(standardName)};
}

Meaning meaningOf(const les::KnownVariable& known) {
    using enum les::Use;
    switch (known.use) {
        case potentialTemperature:
            return Meaning::theta;
        case vapour:
            return Meaning::vapour;
        case ground:
            return Meaning::ground;
        case cellHeight:
            return Meaning::cellHeight;
        case none:
            break;
    }
    switch (known.role) {
        case NEPH_ROLE_MIXING_RATIO:
            return Meaning::hydrometeor;
        case NEPH_ROLE_NUMBER_CONCENTRATION:
            return Meaning::number;
        case NEPH_ROLE_EFFECTIVE_RADIUS:
            return Meaning::radius;
        case NEPH_ROLE_AIR_PRESSURE:
            return Meaning::pressure;
        case NEPH_ROLE_AIR_TEMPERATURE:
            return Meaning::temperature;
        case NEPH_ROLE_DRY_AIR_DENSITY:
            return Meaning::dryDensity;
        case NEPH_ROLE_X_WIND:
            return Meaning::xWind;
        case NEPH_ROLE_Y_WIND:
            return Meaning::yWind;
        case NEPH_ROLE_UPWARD_WIND:
            return Meaning::upwardWind;
        default:
            return Meaning::other;
    }
}

/// CM1's names are those of its GrADS files.
Model cm1() {
    std::vector<Name> names;
    for (const les::KnownVariable& known : les::knownVariables()) {
        names.push_back({std::string(known.name), meaningOf(known), known.species, "", false,
                         std::string(known.standardName)});
    }
    // Without the interpolated ones: on faces, and so without a role.
    names.push_back(wind("u", kEast));
    names.push_back(wind("v", kNorth));
    names.push_back(wind("w", kUp));
    return {.title = "CM1",
            .marks = {{.attribute = "CM1 version"},
                      {.dimensions = {"xh", "yh", "zh"}, .variables = {"qc", "prs", "th"}},
                      {.dimensions = {"ni", "nj", "nk"}, .variables = {"xh", "zh"}}},
            .axes = {{{{"xh", "ni"}, {"xf", "nip1"}, {"xh"}, {"xf"}},
                      {{"yh", "nj"}, {"yf", "njp1"}, {"yh"}, {"yf"}},
                      {{"zh", "nk"}, {"zf", "nkp1"}, {"zh", "z"}, {"zf"}}}},
            .names = std::move(names),
            .times = {"time"},
            .lengthUnit = "km",
            .version = "CM1 version",
            .tiles = {R"(cm1out_(\d{4,6})_(\d{6})\.nc)", {1}},
            .terrainFollowing = true};
}

Model sam() {
    return {.title = "SAM",
            .marks = {{.dimensions = {"x", "y", "z"}, .variables = {"TABS", "QN", "QCL"}}},
            .axes = {{{{"x"}, {}, {"x"}, {}}, {{"y"}, {}, {"y"}, {}}, {{"z"}, {}, {"z"}, {"zi"}}}},
            .names = {{"QC", kWater, kCloud, "g kg-1"},
                      {"QCL", kWater, kCloud, "g kg-1"},
                      {"QI", kWater, kIce, "g kg-1"},
                      {"QCI", kWater, kIce, "g kg-1"},
                      {"QR", kWater, kRain, "g kg-1"},
                      {"QPL", kWater, kRain, "g kg-1"},
                      {"QS", kWater, kSnow, "g kg-1"},
                      {"QPI", kWater, kSnow, "g kg-1"},
                      {"QG", kWater, kGraupel, "g kg-1"},
                      {"QN", Meaning::cloudCondensate, kNone, "g kg-1"},
                      {"QP", Meaning::precipitation, kNone, "g kg-1"},
                      {"QV", Meaning::vapour, kNone, "g kg-1", false, "humidity_mixing_ratio"},
                      {"TABS", Meaning::temperature, kNone, "K", false, "air_temperature"},
                      {"p", Meaning::basePressure, kNone, "mb"},
                      {"PP", Meaning::pressureDeviation, kNone, "Pa"},
                      {"NC", Meaning::number, kCloud},
                      {"NI", Meaning::number, kIce},
                      {"NR", Meaning::number, kRain},
                      {"NS", Meaning::number, kSnow},
                      {"NG", Meaning::number, kGraupel},
                      wind("U", kEast),
                      wind("V", kNorth),
                      wind("W", kUp)},
            .times = {"time"},
            .gas = {287.0, 461.0, 1004.0, 1e5},
            .latentHeatJPerKg = 2.5104e6,
            .liquidBelow273 = true,
            .periodic = true};
}

// The unit that DALES states for water, 1e-5kg/kg, is that of its 16-bit binary files: the NetCDF
// has kg/kg. Its label of thl, "above 300K", likewise.
Model dales() {
    return {.title = "DALES",
            .marks = {{.dimensions = {"xt", "yt", "zt"}, .variables = {"ql", "qt", "thl"}}},
            .axes = {{{{"xt"}, {"xm"}, {"xt"}, {"xm"}},
                      {{"yt"}, {"ym"}, {"yt"}, {"ym"}},
                      {{"zt"}, {"zm"}, {"zt"}, {"zm"}}}},
            .names = {{"ql", kWater, kCloud, "kg kg-1", true},
                      {"qr", kWater, kRain, "kg kg-1", true},
                      {"qt", Meaning::totalWater, kNone, "kg kg-1", true},
                      {"thl", Meaning::liquidTheta, kNone, "K"},
                      {"pressure", Meaning::pressure, kNone, "Pa", false, "air_pressure"},
                      {"presf", Meaning::pressure, kNone, "Pa", false, "air_pressure"},
                      {"temperature", Meaning::temperature, kNone, "K", false, "air_temperature"},
                      {"rhobf", Meaning::referenceDensity, kNone, "kg m-3"},
                      wind("u", kEast),
                      wind("v", kNorth),
                      wind("w", kUp)},
            .times = {"time"},
            .perMoistAir = true,
            .gas = {287.04, 461.5, 1004.0, 1e5},
            .latentHeatJPerKg = 2.53e6,
            .tiles = {R"((.*)\.(\d{3})\.(\d{3})\.(\d{3})\.nc)", {2, 3}},
            .periodic = true};
}

Model uclales() {
    return {.title = "UCLALES",
            .marks = {{.dimensions = {"xt", "yt", "zt"}, .variables = {"dn0", "l", "q"}}},
            .axes = {{{{"xt"}, {"xm"}, {"xt"}, {"xm"}},
                      {{"yt"}, {"ym"}, {"yt"}, {"ym"}},
                      {{"zt"}, {"zm"}, {"zt"}, {"zm"}}}},
            .names = {{"l", kWater, kCloud, "kg kg-1"},
                      {"r", kWater, kRain, "kg kg-1"},
                      {"rr", kWater, kRain, "kg kg-1"},
                      {"i", kWater, kIce, "kg kg-1"},
                      {"s", kWater, kSnow, "kg kg-1"},
                      {"q", Meaning::totalWater, kNone, "kg kg-1"},
                      {"p", Meaning::pressure, kNone, "Pa", false, "air_pressure"},
                      {"dn0", Meaning::referenceDensity, kNone, "kg m-3"},
                      wind("u", kEast),
                      wind("v", kNorth),
                      wind("w", kUp)},
            .times = {"time"},
            .perMoistAir = true,
            .ghostLevels = true,
            .gas = {287.04, 461.5, 1005.0, 1e5},
            .tiles = {R"((.*)\.(\d{4})(\d{4})\.nc)", {2, 3}},
            .periodic = true};
}

Model palm() {
    return {.title = "PALM",
            .marks = {{.dimensions = {"zu_3d"}},
                      {.dimensions = {"zu_mask", "x", "y"}},
                      {.dimensions = {"zu", "x", "y"}, .attribute = "title", .text = "PALM"}},
            .axes = {{{{"x"}, {"xu"}, {"x"}, {"xu"}},
                      {{"y"}, {"yv"}, {"y"}, {"yv"}},
                      {{"zu_3d", "zu_mask", "zu"},
                       {"zw_3d", "zw_mask", "zw"},
                       {"zu_3d", "zu_mask", "zu"},
                       {"zw_3d", "zw_mask", "zw"}}}},
            .names = {{"qc", kWater, kCloud, "kg kg-1"},
                      {"ql", kWater, kCloud, "kg kg-1"},
                      {"qr", kWater, kRain, "kg kg-1"},
                      {"qi", kWater, kIce, "kg kg-1"},
                      {"qs", kWater, kSnow, "kg kg-1"},
                      {"qg", kWater, kGraupel, "kg kg-1"},
                      {"nc", Meaning::number, kCloud, "m-3"},
                      {"nr", Meaning::number, kRain, "m-3"},
                      {"ni", Meaning::number, kIce, "m-3"},
                      {"q", Meaning::totalWater, kNone, "kg kg-1"},
                      {"qv", Meaning::vapour, kNone, "kg kg-1"},
                      {"theta", Meaning::theta, kNone, "K", false, "air_potential_temperature"},
                      {"pt", Meaning::theta, kNone, "K", false, "air_potential_temperature"},
                      {"ta", Meaning::temperature, kNone, "degC", false, "air_temperature"},
                      {"hyp", Meaning::pressure, kNone, "hPa", false, "air_pressure"},
                      {"rho_air", Meaning::referenceDensity, kNone, "kg m-3"},
                      {"rho", Meaning::referenceDensity, kNone, "kg m-3"},
                      wind("u", kEast),
                      wind("v", kNorth),
                      wind("w", kUp)},
            .times = {"time"},
            .perMoistAir = true,
            .ghostLevels = true,
            .gas = {287.0, 461.51, 1005.0, 1e5}};
}

// z lies between the levels zn, whichever of them a file names as the axis of a field.
Model monc() {
    return {
        .title = "MONC",
        .marks = {{.variables = {"options_database"}},
                  {.variables = {"q_cloud_liquid_mass", "q_rain_mass", "q_ice_mass"}}},
        .axes = {{{{"x"}, {}, {"x"}, {}},
                  {{"y"}, {}, {"y"}, {}},
                  {{"zn", "z"}, {}, {"zn"}, {"z"}}}},
        .names = {{"q_cloud_liquid_mass", kWater, kCloud, "kg kg-1"},
                  {"q_rain_mass", kWater, kRain, "kg kg-1"},
                  {"q_ice_mass", kWater, kIce, "kg kg-1"},
                  {"q_cloud_ice_mass", kWater, kIce, "kg kg-1"},
                  {"q_snow_mass", kWater, kSnow, "kg kg-1"},
                  {"q_graupel_mass", kWater, kGraupel, "kg kg-1"},
                  {"q_cloud_liquid_number", Meaning::number, kCloud, "kg-1"},
                  {"q_rain_number", Meaning::number, kRain, "kg-1"},
                  {"q_ice_number", Meaning::number, kIce, "kg-1"},
                  {"q_snow_number", Meaning::number, kSnow, "kg-1"},
                  {"q_graupel_number", Meaning::number, kGraupel, "kg-1"},
                  {"q_vapour", Meaning::vapour, kNone, "kg kg-1", false, "humidity_mixing_ratio"},
                  {"thref", Meaning::baseTheta, kNone, "K"},
                  {"th", Meaning::thetaDeviation, kNone, "K"},
                  {"prefn", Meaning::basePressure, kNone, "Pa"},
                  {"rhon", Meaning::referenceDensity, kNone, "kg m-3"},
                  wind("u", kEast),
                  wind("v", kNorth),
                  wind("w", kUp)},
        .ghostLevels = true,
        .gas = {287.05, 461.5, 1005.0, 1e5},
        .periodic = true};
}

Model microhh() {
    return {.title = "MicroHH",
            .marks = {{.dimensions = {"x", "y", "z"},
                       .variables = {"ql", "qi", "qr", "qs", "qg", "qh", "qt", "thl"}}},
            .axes = {{{{"x"}, {"xh"}, {"x"}, {"xh"}},
                      {{"y"}, {"yh"}, {"y"}, {"yh"}},
                      {{"z"}, {"zh"}, {"z"}, {"zh"}}}},
            .names = {{"ql", kWater, kCloud, "kg kg-1"},
                      {"qi", kWater, kIce, "kg kg-1"},
                      {"qr", kWater, kRain, "kg kg-1"},
                      {"qs", kWater, kSnow, "kg kg-1"},
                      {"qg", kWater, kGraupel, "kg kg-1"},
                      {"qh", kWater, kHail, "kg kg-1"},
                      {"nr", Meaning::number, kRain, "m-3"},
                      {"qt", Meaning::totalWater, kNone, "kg kg-1"},
                      {"thl", Meaning::liquidTheta, kNone, "K"},
                      {"phydro", Meaning::pressure, kNone, "Pa", false, "air_pressure"},
                      {"rhoref", Meaning::referenceDensity, kNone, "kg m-3"},
                      wind("u", kEast),
                      wind("v", kNorth),
                      wind("w", kUp)},
            .times = {"time"},
            .perMoistAir = true,
            .gas = {287.04, 461.5, 1005.0, 1e5},
            .microhhAir = true,
            .periodic = true};
}

Model mesoNh() {
    return {.title = "Meso-NH",
            .marks = {{.variables = {"RCT", "RRT", "RIT"}}},
            .axes = {{{{"ni", "X"}, {"ni_u"}, {"ni", "X"}, {"ni_u", "XHAT"}},
                      {{"nj", "Y"}, {"nj_v"}, {"nj", "Y"}, {"nj_v", "YHAT"}},
                      {{"level", "Z"}, {"level_w"}, {"level", "Z"}, {"level_w", "ZHAT"}}}},
            .names = {{"RCT", kWater, kCloud, "kg kg-1"},
                      {"RRT", kWater, kRain, "kg kg-1"},
                      {"RIT", kWater, kIce, "kg kg-1"},
                      {"RST", kWater, kSnow, "kg kg-1"},
                      {"RGT", kWater, kGraupel, "kg kg-1"},
                      {"RHT", kWater, kHail, "kg kg-1"},
                      {"RVT", Meaning::vapour, kNone, "kg kg-1", false, "humidity_mixing_ratio"},
                      {"CCT", Meaning::number, kCloud, "kg-1"},
                      {"CRT", Meaning::number, kRain, "kg-1"},
                      {"CIT", Meaning::number, kIce, "kg-1"},
                      {"THT", Meaning::theta, kNone, "K", false, "air_potential_temperature"},
                      {"PABST", Meaning::pressure, kNone, "Pa", false, "air_pressure"},
                      {"ZS", Meaning::ground, kNone, "m", false, "surface_altitude"},
                      wind("UT", kEast),
                      wind("VT", kNorth),
                      wind("WT", kUp)},
            .times = {"time"},
            .ghostLevels = true,
            .halo = "JPHEXT",
            .gas = {287.06, 461.5, 1004.7, 1e5},
            .terrainFollowing = true};
}

/// Standard names alone: axes are told by the attributes of their coordinates.
Model plainCf() {
    Model model;
    model.title = "CF";
    model.marks = {{}};
    return model;
}

}  // namespace

const std::vector<Model>& models() {
    // SAM before MicroHH, whose marks its files could have as well.
    static const std::vector<Model> table{cm1(),   mesoNh(),  palm(),    monc(),   sam(),
                                          dales(), uclales(), microhh(), plainCf()};
    return table;
}

}  // namespace cf
