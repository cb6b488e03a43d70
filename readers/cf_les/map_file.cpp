// map_file.cpp: strict parsing of a map: a key that is not known is an error.
#include "readers/cf_les/map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/plugin/reader_plugin.h"
#include "readers/les/text.h"

namespace cf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Failure = neph::plugin::Error;

constexpr const char* kType = "nephoscope-map";

struct RoleName {
    std::string_view name;
    Meaning meaning;
};
constexpr std::array kRoles{
    RoleName{"mixing_ratio", Meaning::hydrometeor},
    RoleName{"number_concentration", Meaning::number},
    RoleName{"effective_radius", Meaning::radius},
    RoleName{"air_pressure", Meaning::pressure},
    RoleName{"base_pressure", Meaning::basePressure},
    RoleName{"pressure_deviation", Meaning::pressureDeviation},
    RoleName{"air_temperature", Meaning::temperature},
    RoleName{"potential_temperature", Meaning::theta},
    RoleName{"base_potential_temperature", Meaning::baseTheta},
    RoleName{"potential_temperature_deviation", Meaning::thetaDeviation},
    RoleName{"liquid_water_potential_temperature", Meaning::liquidTheta},
    RoleName{"dry_air_density", Meaning::dryDensity},
    RoleName{"air_density", Meaning::airDensity},
    RoleName{"reference_density", Meaning::referenceDensity},
    RoleName{"vapour_mixing_ratio", Meaning::vapour},
    RoleName{"total_water", Meaning::totalWater},
    RoleName{"ground_height", Meaning::ground},
    RoleName{"cell_height", Meaning::cellHeight},
};
constexpr std::array<std::string_view, 6> kSpecies{"cloud", "ice",     "rain",
                                                   "snow",  "graupel", "hail"};
constexpr std::array<std::string_view, 3> kAxisKeys{"x", "y", "z"};

std::string shown(const Json& value) {
    return les::inQuotes(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// The members of an object, each of which has to be asked for.
class Members {
  public:
    Members(const Json& object, std::string where) : object_(object), where_(std::move(where)) {
        if (!object.is_object()) {
            throw Failure{where_ + " is not an object", shown(object), "{…}", {}};
        }
    }

    std::string key(std::string_view name) const {
        return where_.empty() ? std::string(name) : fmt::format("{}.{}", where_, name);
    }
    const Json* find(const char* name) {
        asked_.emplace_back(name);
        const auto found = object_.find(name);
        return found == object_.end() ? nullptr : &*found;
    }
    std::optional<std::string> text(const char* name) {
        const Json* value = find(name);
        if (value == nullptr) return {};
        if (!value->is_string())
            throw Failure{key(name) + " is no text", shown(*value), "\"…\"", {}};
        return value->get<std::string>();
    }
    std::string requiredText(const char* name) {
        auto value = text(name);
        if (!value || value->empty()) {
            throw Failure{key(name) + " is missing", {}, "a text", {}};
        }
        return *std::move(value);
    }
    /// Throws Failure for a member that nobody has asked for.
    void end() const {
        for (const auto& [name, value] : object_.items()) {
            if (std::ranges::find(asked_, name) != asked_.end()) continue;
            throw Failure{fmt::format("{} is no key of a map", key(name)),
                          shown(value),
                          "one of " + les::joined(asked_),
                          {}};
        }
    }

  private:
    const Json& object_;
    std::string where_;
    std::vector<std::string> asked_;
};

Meaning meaningNamed(const std::string& role, const std::string& key) {
    const auto found = std::ranges::find(kRoles, role, &RoleName::name);
    if (found != kRoles.end()) return found->meaning;
    std::string known;
    for (const RoleName& each : kRoles)
        known += (known.empty() ? "" : ", ") + std::string(each.name);
    throw Failure{key + " is no role", les::inQuotes(role), "one of " + known, {}};
}

Name variableOf(const Json& json, std::size_t index) {
    Members members(json, fmt::format("variables[{}]", index));
    Name name;
    name.name = members.requiredText("name");
    name.meaning = meaningNamed(members.requiredText("role"), members.key("role"));
    name.unit = members.text("unit").value_or("");
    name.unitHolds = !name.unit.empty();
    const bool ofSpecies = name.meaning == Meaning::hydrometeor ||
                           name.meaning == Meaning::number || name.meaning == Meaning::radius;
    const auto species = members.text("species");
    if (ofSpecies != species.has_value()) {
        throw Failure{members.key("species") + (ofSpecies ? " is missing" : " fits no such role"),
                      species.value_or(""),
                      ofSpecies ? "cloud, ice, rain, snow, graupel or hail" : "no species",
                      {}};
    }
    if (species) {
        const auto found = std::ranges::find(kSpecies, *species);
        if (found == kSpecies.end()) {
            throw Failure{members.key("species") + " is not known",
                          les::inQuotes(*species),
                          "cloud, ice, rain, snow, graupel or hail",
                          {}};
        }
        name.species = static_cast<NephSpecies>(found - kSpecies.begin());
    }
    members.end();
    const bool per =
        name.meaning == Meaning::number && shared::conversion(name.unit, "m-3").has_value();
    if (name.unitHolds && !per && !les::toSi(quantityOf(name.meaning), name.unit)) {
        throw Failure{members.key("unit") + " is no unit of this role",
                      les::inQuotes(name.unit),
                      les::acceptedUnits(quantityOf(name.meaning)),
                      {}};
    }
    return name;
}

/// "x": "NAME", or "x": {"dimension": …, "positions": …, "faces": …}.
AxisNames axisOf(const Json& json, const std::string& where) {
    if (json.is_string()) {
        const auto name = json.get<std::string>();
        return {{name}, {}, {name}, {}};
    }
    Members members(json, where);
    AxisNames names;
    names.cells = {members.requiredText("dimension")};
    names.cellPositions = {members.text("positions").value_or(names.cells.front())};
    if (auto faces = members.text("faces")) names.facePositions = {*std::move(faces)};
    members.end();
    return names;
}

void requireType(Members& members) {
    const Json* type = members.find("type");
    if (type == nullptr || *type != kType) {
        throw Failure{"is no map",
                      type == nullptr ? "no \"type\"" : shown(*type),
                      fmt::format("\"type\": \"{}\"", kType),
                      {}};
    }
    const Json* version = members.find("version");
    if (version == nullptr || *version != 1) {
        throw Failure{"has another version",
                      version == nullptr ? "none" : shown(*version),
                      "\"version\": 1",
                      {}};
    }
}

}  // namespace

std::optional<std::string> mapBeside(const std::string& path) {
    fs::path stem(path);
    stem.replace_extension();
    std::error_code code;
    for (const fs::path& candidate :
         {fs::path(path + ".map.json"), fs::path(stem.string() + ".map.json"),
          fs::path(path).parent_path() / "nephoscope-map.json"}) {
        if (fs::is_regular_file(candidate, code)) return candidate.string();
    }
    return {};
}

Model parseMap(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw Failure{"is not JSON", {}, "a nephoscope-map", {}};
    Members members(json, "");
    requireType(members);
    Model model;
    model.title = members.text("model").value_or("mapped");
    model.marks = {{}};
    model.reason = "the map states it";
    if (const Json* axes = members.find("axes")) {
        Members names(*axes, "axes");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const char* key = kAxisKeys[axis].data();
            if (const Json* of = names.find(key)) model.axes[axis] = axisOf(*of, names.key(key));
        }
        if (auto time = names.text("time")) model.times = {*std::move(time)};
        names.end();
    }
    if (auto unit = members.text("length_unit")) model.lengthUnit = *std::move(unit);
    const std::string per = members.text("per").value_or("dry_air");
    if (per != "dry_air" && per != "moist_air") {
        throw Failure{"per is not known", les::inQuotes(per), "dry_air or moist_air", {}};
    }
    model.perMoistAir = per == "moist_air";
    const Json* variables = members.find("variables");
    if (variables == nullptr || !variables->is_array() || variables->empty()) {
        throw Failure{"variables are missing", {}, "a list of variables", {}};
    }
    for (std::size_t i = 0; i < variables->size(); ++i) {
        model.names.push_back(variableOf((*variables)[i], i));
        const auto same = [&](const Name& name) { return name.name == model.names.back().name; };
        if (std::ranges::count_if(model.names, same) > 1) {
            throw Failure{fmt::format("variables[{}] is there twice", i),
                          model.names.back().name,
                          "each variable once",
                          {}};
        }
    }
    members.end();
    return model;
}

Model readMap(const std::string& path) {
    try {
        return parseMap(les::readText(path));
    } catch (Failure& failure) {
        if (failure.where.empty()) failure.where = path;
        throw;
    }
}

}  // namespace cf
