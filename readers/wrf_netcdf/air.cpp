// air.cpp: the alternatives for heights, pressure and heat, the first complete one of which is
// used.
#include "readers/wrf_netcdf/air.h"

#include <fmt/format.h>

#include <algorithm>

namespace wrf {
namespace {

/// One way to a quantity: the sum of one or two variables, by name or CF standard name.
struct Way {
    const char* first;
    const char* second;  ///< null for a single variable
    const char* unit;
    bool onInterfaces;
    const char* text;  ///< how the quantity follows
    Heat heat = Heat::temperature;
};

// PH and T of restart files come in two time levels, of which the second is the present one.
constexpr std::array kHeights{
    Way{"PH", "PHB", "m2 s-2", true, "(PH+PHB)/9.81"},
    Way{"PH_2", "PHB", "m2 s-2", true, "(PH_2+PHB)/9.81"},
    Way{"geopotential", nullptr, "m2 s-2", true, "geopotential/9.81"},
    Way{"geopotential_height", nullptr, "m", true, "geopotential height"},
    Way{"Z", nullptr, "m", true, "Z"},
    Way{"height", nullptr, "m", true, "height"},
    Way{"PH", "PHB", "m2 s-2", false, "(PH+PHB)/9.81, at centres"},
    Way{"geopotential", nullptr, "m2 s-2", false, "geopotential/9.81, at centres"},
    Way{"geopotential_height", nullptr, "m", false, "geopotential height, at centres"},
    Way{"Z", nullptr, "m", false, "Z, at centres"},
    Way{"height", nullptr, "m", false, "height, at centres"},
    Way{"z", nullptr, "m", false, "z, at centres"},
};
constexpr std::array kPressures{
    Way{"P", "PB", "Pa", false, "P+PB"},
    Way{"air_pressure", nullptr, "Pa", false, "air pressure as stored"},
    Way{"pressure", nullptr, "Pa", false, "pressure as stored"},
    Way{"PRES", nullptr, "Pa", false, "pressure as stored"},
    Way{"P", nullptr, "Pa", false, "P as stored"},
};
constexpr std::array kHeats{
    Way{"T", nullptr, "K", false, "(T+300) (p/1e5)^(2/7)", Heat::thetaMinus300},
    Way{"T_2", nullptr, "K", false, "(T_2+300) (p/1e5)^(2/7)", Heat::thetaMinus300},
    Way{"THM_2", nullptr, "K", false, "(THM_2+300) (p/1e5)^(2/7)/(1+1.6084 q_v)",
        Heat::moistThetaMinus300},
    Way{"TK", nullptr, "K", false, "TK", Heat::temperature},
    Way{"air_temperature", nullptr, "K", false, "air temperature as stored", Heat::temperature},
    Way{"temperature", nullptr, "K", false, "temperature as stored", Heat::temperature},
    Way{"air_potential_temperature", nullptr, "K", false, "theta (p/1e5)^(2/7)", Heat::theta},
    Way{"theta", nullptr, "K", false, "theta (p/1e5)^(2/7)", Heat::theta},
    Way{"TH", nullptr, "K", false, "TH (p/1e5)^(2/7)", Heat::theta},
};

/// A field of WRF's history files, for the message where no way is open.
struct RequiredField {
    const char* name;
    const char* meaning;
    bool onInterfaces;
    const char* why;
};
constexpr std::array<RequiredField, 5> kRequired{{
    {"PH", "perturbation geopotential", true, "heights are (PH+PHB)/9.81"},
    {"PHB", "base-state geopotential", true, "heights are (PH+PHB)/9.81"},
    {"P", "perturbation pressure", false, "air density needs pressure, P+PB"},
    {"PB", "base-state pressure", false, "air density needs pressure, P+PB"},
    {"T", "perturbation potential temperature", false, "air density needs temperature"},
}};

class AirFinder {
  public:
    AirFinder(const Tiles& tiles, UnitNotes& units) : tiles_(tiles), units_(units) {}

    /// The variable of a name or standard name, if it lies where it should.
    const NcVariable* find(const char* name, bool onInterfaces) const {
        const NcFile& file = tiles_.first();
        for (const NcVariable* variable :
             {file.variable(name), file.variableOfStandardName(name)}) {
            if (variable == nullptr || !variable->number) continue;
            const auto shape = tiles_.shapeOf(*variable);
            if (shape && (onInterfaces ? shape->onInterfaces() : shape->onCells())) return variable;
        }
        return nullptr;
    }

    /// The first way whose variables are all there.
    template <std::size_t N>
    const Way* firstOpen(const std::array<Way, N>& ways, std::vector<Term>& terms) {
        for (const Way& way : ways) {
            const NcVariable* first = find(way.first, way.onInterfaces);
            const NcVariable* second =
                way.second == nullptr ? nullptr : find(way.second, way.onInterfaces);
            if (first == nullptr || (way.second != nullptr && second == nullptr)) continue;
            if (way.second == nullptr && isPerturbation(*first)) continue;
            for (const NcVariable* variable : {first, second}) {
                if (variable == nullptr) continue;
                auto term = termOf(*variable, way.unit, units_);
                if (!term) throw wrongUnit(*variable, way.unit);
                terms.push_back(*term);
            }
            return &way;
        }
        return nullptr;
    }

    /// Throws Failure for the first of `fields` that is not there or has another shape.
    [[noreturn]] void fail(std::span<const RequiredField> fields) const {
        for (const RequiredField& field : fields) {
            if (find(field.name, field.onInterfaces) == nullptr) failFor(field);
        }
        failFor(fields.front());
    }

  private:
    /// Whether a variable is what the model writes to be added to PB, by its description or,
    /// without one, by its values at the ground.
    bool isPerturbation(const NcVariable& variable) const {
        if (variable.name != "P") return false;
        if (!variable.description.empty()) {
            return variable.description.find("erturbation") != std::string::npos;
        }
        constexpr float kLeastAtGround = 20000.0f;  // Pa, or hPa by far more than any perturbation
        const Box row{{0, 0, 0}, {tiles_.axes().length[0], 1, 1}};
        std::vector<float> values(row.count());
        tiles_.read(variable, 0, row, values);
        const float scale = variable.units == "hPa" || variable.units == "mb" ? 100.0f : 1.0f;
        return std::ranges::none_of(values, [&](float p) { return p * scale > kLeastAtGround; });
    }

    [[noreturn]] void failFor(const RequiredField& field) const {
        const NcFile& file = tiles_.first();
        const char* axes = field.onInterfaces ? "(Time, bottom_top_stag, south_north, west_east)"
                                              : "(Time, bottom_top, south_north, west_east)";
        const NcVariable* variable = file.variable(field.name);
        if (variable != nullptr) {
            const auto& length = tiles_.axes().length;
            throw Failure{
                fmt::format("variable {} ({}) has the wrong shape", field.name, field.meaning),
                listOf(variable->axes),
                fmt::format("numbers on {}: {} x {} x {} in x, y, z", axes, length[0], length[1],
                            length[2] + (field.onInterfaces ? 1 : 0)),
                field.onInterfaces
                    ? "if levels were cut out, cut both axes: ncks -d bottom_top,0,9 "
                      "-d bottom_top_stag,0,10 IN.nc OUT.nc"
                    : "open wrfout files as written by the model"};
        }
        std::vector<std::string> names;
        for (const NcVariable& v : file.variables()) {
            if (v.number && tiles_.shapeOf(v)) names.push_back(v.name);
        }
        throw Failure{
            fmt::format("variable {} ({}) is missing", field.name, field.meaning), joined(names),
            fmt::format("{} on {}", field.name, axes),
            fmt::format("{}; write {} with the history stream (iofields)", field.why, field.name)};
    }

    const Tiles& tiles_;
    UnitNotes& units_;
};

}  // namespace

AirSources findAir(const Tiles& tiles, UnitNotes& unitNotes, std::vector<std::string>& notes) {
    AirFinder finder(tiles, unitNotes);
    AirSources air;
    const std::span required(kRequired);
    const Way* height = finder.firstOpen(kHeights, air.height);
    if (height == nullptr) finder.fail(required.first(2));
    air.geopotential = height->unit == std::string_view("m2 s-2");
    air.onInterfaces = height->onInterfaces;
    air.heightText = height->text;
    const Way* pressure = finder.firstOpen(kPressures, air.pressure);
    if (pressure == nullptr) finder.fail(required.subspan(2, 2));
    air.pressureText = pressure->text;
    const Way* heat = finder.firstOpen(kHeats, air.heat);
    if (heat == nullptr) finder.fail(required.last(1));
    air.kind = heat->heat;
    if (air.kind == Heat::thetaMinus300 || air.kind == Heat::moistThetaMinus300) {
        for (Term& term : air.heat) term.toSi.offset = 0.0;  // a difference: 1 °C is 1 K
    }
    air.temperatureText = heat->text;
    if (air.kind == Heat::moistThetaMinus300 &&
        tiles.first().number("USE_THETA_M").value_or(1.0) == 0.0) {
        air.kind = Heat::thetaMinus300;
    }
    const NcVariable* vapour = finder.find("QVAPOR", false);
    if (vapour != nullptr) {
        const auto term = termOf(*vapour, "kg kg-1", unitNotes);
        if (!term) throw wrongUnit(*vapour, "kg kg-1");
        air.vapour.push_back(*term);
    } else {
        notes.push_back("QVAPOR is missing: the air is treated as dry.");
    }
    if (air.onInterfaces) return air;
    const NcVariable* terrain = tiles.first().variable("HGT");
    const auto shape = terrain == nullptr ? std::nullopt : tiles.shapeOf(*terrain);
    const auto term = shape && shape->flat ? termOf(*terrain, "m", unitNotes) : std::nullopt;
    if (term) air.terrain.push_back(*term);
    notes.push_back(
        fmt::format("Heights are those of the centres of cells: interfaces are taken "
                    "halfway between them{}.",
                    term ? ", the lowest as HGT" : ""));
    return air;
}

}  // namespace wrf
