// models.h: one row for each model: how its files are recognised, the names of its axes and
// variables, and which rules its numbers follow. Another model is a row, not code.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_abi.h"
#include "readers/les/air.h"
#include "readers/les/quantity.h"

namespace cf {

/// What a variable is; what the reader makes of it is in variables.cpp.
enum class Meaning {
    other,
    hydrometeor,
    number,             ///< of particles, per kg or per m³
    radius,             ///< effective
    pressure,           ///< whole
    basePressure,       ///< of the base state, usually a profile
    pressureDeviation,  ///< from the base state
    temperature,
    theta,  ///< potential temperature
    baseTheta,
    thetaDeviation,
    liquidTheta,       ///< liquid water potential temperature
    dryDensity,        ///< of dry air
    airDensity,        ///< of moist air
    referenceDensity,  ///< by which the model itself multiplies its amounts per kg
    vapour,
    totalWater,       ///< vapour and cloud
    cloudCondensate,  ///< cloud water and ice, not told apart
    precipitation,    ///< rain, snow and graupel, not told apart
    ground,           ///< height of the ground
    cellHeight,       ///< of the middle of every cell
    xWind,            ///< along the grid, in cells
    yWind,
    upwardWind
};

/// The unit that values of a meaning convert to; every meaning but `other` has one.
les::Quantity quantityOf(Meaning meaning);
/// "cloud water", "air pressure" …, for messages.
std::string meaningText(Meaning meaning, NephSpecies species);

/// A variable by its name, in the spelling of the model.
struct Name {
    std::string name;
    Meaning meaning = Meaning::other;
    NephSpecies species = NEPH_SPECIES_NONE;
    std::string unit{};      ///< of the values where the file does not state it
    bool unitHolds = false;  ///< `unit` holds whatever the file states
    std::string standardName{};
    bool perMoistAir = false;  ///< of this amount, whatever the model's others are
};

/// Marks by which files are recognised: all dimensions, one of the variables, the attribute with
/// the text in it; a mark without any of them fits every file.
struct Mark {
    std::vector<std::string> dimensions{}, variables{};
    std::string attribute{}, text{};
};

/// Which names of an axis there are: dimensions of cells and of faces, and the variables of their
/// positions in the order of preference.
struct AxisNames {
    std::vector<std::string> cells, faces, cellPositions, facePositions;
};

/// How the files of single MPI ranks are named.
struct Tiles {
    std::string pattern{};             ///< a regular expression of the whole name
    std::vector<std::size_t> ranks{};  ///< its groups that differ among the tiles of one time
};

struct Model {
    std::string title;
    std::string reason{};              ///< for the roles of names; empty: the model writes them
    std::vector<Mark> marks;           ///< one of them
    std::array<AxisNames, 3> axes;     ///< x, y, z
    std::vector<Name> names;           ///< in the order of preference
    std::vector<std::string> times{};  ///< dimensions of time
    std::string lengthUnit = "m";      ///< of positions whose unit is not stated
    bool perMoistAir = false;          ///< amounts are per kg of moist air, not of dry air
    bool ghostLevels = false;          ///< levels whose middle is not above 0 are none of the air
    std::string halo{};                ///< variable with the number of columns outside the domain
    std::string version{};             ///< attribute with the version, for display
    les::GasConstants gas{};           ///< the model's own
    double latentHeatJPerKg = 2.5e6;   ///< of vaporisation, the model's own
    Tiles tiles{};
    bool microhhAir = false;        ///< MicroHH's files of its reference air lie beside
    bool liquidBelow273 = false;    ///< cloudCondensate and precipitation as SAM divides them
    bool periodic = false;          ///< its sides are, in x and y, unless a run asks for others
    bool terrainFollowing = false;  ///< the ground lifts the levels, as with CM1
};

/// What the standard names of CF mean, for files of every model; without names.
const std::vector<Name>& standardNames();

/// The table; plain CF is the last row.
const std::vector<Model>& models();

}  // namespace cf
