// contents.cpp: reading of stored, horizontally uniform and derived variables.
#include "readers/les/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "readers/les/levels.h"

namespace les {
namespace {

namespace plugin = neph::plugin;

// Derived fields are computed in slabs of at most this many values, to limit memory and to respond
// to a cancellation soon.
constexpr std::size_t kSlabValues = 1U << 18U;
constexpr const char* kStandard = "U.S. Standard Atmosphere 1976";

/// The opened data set as the host sees it.
class ContentsFile : public plugin::File {
  public:
    explicit ContentsFile(Contents contents) : contents_(std::move(contents)) {
        std::set<std::string> names;
        for (const plugin::Variable& variable : contents_.description.variables) {
            if (names.insert(variable.name).second) continue;
            throw Error{fmt::format("variable {} occurs twice", variable.name),
                        {},
                        "a unique name for each variable",
                        {}};
        }
    }

    const plugin::Description& description() const override { return contents_.description; }

    void read(const plugin::Request& request) override {
        read(request.variable, request.time, {request.lower, request.upper},
             {request.values, request.count()}, request.tick);
    }

  private:
    void read(std::size_t variable, std::size_t time, const Box& box, std::span<float> values,
              const Tick& tick) const;
    void readStored(const Source& source, std::size_t time, Box box, std::span<float> values,
                    const Tick& tick) const;
    void readDerived(const Derived& derived, std::size_t time, const Box& box,
                     std::span<float> values, const Tick& tick) const;
    /// What one input of a derived variable needs for a slab.
    struct Piece {
        std::vector<float> values;
        std::size_t firstLevel = 0, plane = 0;
    };
    Piece readInput(const Derived::Input& input, std::size_t time, const Box& slab) const;

    Contents contents_;
};

void ContentsFile::read(std::size_t variable, std::size_t time, const Box& box,
                        std::span<float> values, const Tick& tick) const {
    const Source& source = contents_.sources[variable];
    if (source.stored) return readStored(source, time, box, values, tick);
    if (source.derived) return readDerived(*source.derived, time, box, values, tick);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = source.profile[box.lower[2] + i / box.plane()];
    }
    tick(1.0);
}

/// Levels above the stored ones are filled with zeros.
void ContentsFile::readStored(const Source& source, std::size_t time, Box box,
                              std::span<float> values, const Tick& tick) const {
    if (source.storedLevels > 0) {
        box.upper[2] = std::clamp(source.storedLevels, box.lower[2], box.upper[2]);
        std::ranges::fill(values.subspan(box.count()), 0.0f);
    }
    if (box.count() == 0) return tick(1.0);
    source.stored(time, box, values.first(box.count()), tick);
}

std::size_t levelOf(const Derived::Input& input, std::size_t level, std::size_t levels) {
    const auto shifted = static_cast<std::ptrdiff_t>(level) + input.shift;
    const std::size_t wanted = shifted < 0 ? 0 : static_cast<std::size_t>(shifted);
    return std::min(std::clamp(wanted, input.least, input.most), levels - 1);
}

ContentsFile::Piece ContentsFile::readInput(const Derived::Input& input, std::size_t time,
                                            const Box& slab) const {
    const plugin::Variable& info = contents_.description.variables[input.variable];
    const auto levels = static_cast<std::size_t>(info.size[2]);
    Box box = slab;
    if (info.size[0] == 1 && info.size[1] == 1) {
        box.lower[0] = box.lower[1] = 0;
        box.upper[0] = box.upper[1] = 1;
    }
    box.lower[2] = levelOf(input, slab.lower[2], levels);
    box.upper[2] = levelOf(input, slab.upper[2] - 1, levels) + 1;
    Piece piece{std::vector<float>(box.count()), box.lower[2], box.plane()};
    read(input.variable, time, box, piece.values, [](double) {});
    return piece;
}

void ContentsFile::readDerived(const Derived& derived, std::size_t time, const Box& box,
                               std::span<float> values, const Tick& tick) const {
    const std::size_t plane = box.plane();
    const std::size_t step = std::max<std::size_t>(1, kSlabValues / plane);
    std::vector<double> inputs(derived.inputs.size());
    for (std::size_t z = box.lower[2]; z < box.upper[2]; z += step) {
        tick(static_cast<double>(z - box.lower[2]) / static_cast<double>(box.length(2)));
        Box slab = box;
        slab.lower[2] = z;
        slab.upper[2] = std::min(z + step, box.upper[2]);
        std::vector<Piece> pieces;
        for (const auto& input : derived.inputs) pieces.push_back(readInput(input, time, slab));
        for (std::size_t level = z; level < slab.upper[2]; ++level) {
            std::vector<const float*> from;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const auto& info = contents_.description.variables[derived.inputs[i].variable];
                const std::size_t at =
                    levelOf(derived.inputs[i], level, static_cast<std::size_t>(info.size[2]));
                from.push_back(pieces[i].values.data() +
                               (at - pieces[i].firstLevel) * pieces[i].plane);
            }
            float* to = values.data() + (level - box.lower[2]) * plane;
            for (std::size_t cell = 0; cell < plane; ++cell) {
                for (std::size_t i = 0; i < inputs.size(); ++i) {
                    inputs[i] = static_cast<double>(from[i][pieces[i].plane == 1 ? 0 : cell]);
                }
                to[cell] = static_cast<float>(derived.value(inputs, level));
            }
        }
    }
    tick(1.0);
}

}  // namespace

void Contents::add(plugin::Variable variable, Source source) {
    description.variables.push_back(std::move(variable));
    sources.push_back(std::move(source));
}

std::optional<std::size_t> Contents::find(NephRole role) const {
    const auto found = std::ranges::find(description.variables, role, &plugin::Variable::role);
    if (found == description.variables.end()) return {};
    return static_cast<std::size_t>(found - description.variables.begin());
}

void Contents::settle(plugin::Variable& variable) const {
    const auto taken = [&] {
        return std::ranges::find(description.variables, variable.name, &plugin::Variable::name) !=
               description.variables.end();
    };
    while (taken()) variable.name += "_derived";
    if (variable.role != NEPH_ROLE_OTHER && variable.reason.empty()) {
        variable.reason = "computed: " + variable.description;
    }
}

void Contents::addProfile(plugin::Variable variable, const std::vector<double>& values) {
    settle(variable);
    variable.size = {1, 1, static_cast<int>(values.size())};
    Source source;
    for (const double value : values) source.profile.push_back(static_cast<float>(value));
    add(std::move(variable), std::move(source));
}

void Contents::addDerived(plugin::Variable variable, Derived derived) {
    settle(variable);
    Source source;
    source.derived = std::move(derived);
    add(std::move(variable), std::move(source));
}

void Contents::notePeriodicSides(const std::string& model) {
    description.notes.push_back(
        model +
        " has periodic sides unless a run asks for others: domain.sides=periodic draws and lights "
        "the clouds as the endless field that they are a part of.");
}

void Contents::addSum(const std::vector<std::size_t>& parts) {
    plugin::Variable sum = description.variables[parts.front()];
    std::vector<std::string> names;
    Derived derived;
    derived.value = [](std::span<const double> values, std::size_t) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    for (const std::size_t part : parts) {
        plugin::Variable& variable = description.variables[part];
        names.push_back(variable.name);
        variable.role = NEPH_ROLE_OTHER;
        variable.species = NEPH_SPECIES_NONE;
        derived.inputs.push_back({part});
    }
    sum.name = fmt::format("{}", fmt::join(names, "+"));
    sum.standardName.clear();
    sum.description = "sum of " + joined(names);
    sum.reason = "computed: " + sum.description;
    sum.size = description.size;
    addDerived(std::move(sum), std::move(derived));
}

/// A variable of the standard atmosphere, at the heights of the cells.
void Contents::addStandard(plugin::Variable variable, double Air::*part) {
    variable.description = kStandard;
    const std::size_t heights = *find(NEPH_ROLE_INTERFACE_HEIGHT);
    const bool flat = description.variables[heights].size[0] == 1;
    if (flat) {
        std::vector<double> values;
        for (const double height : centresOf(interfacesM)) {
            values.push_back(standardAtmosphere(height).*part);
        }
        return addProfile(std::move(variable), values);
    }
    variable.size = description.size;
    addDerived(std::move(variable),
               {{{heights, 0}, {heights, 1}}, [part](std::span<const double> z, std::size_t) {
                    return standardAtmosphere(0.5 * (z[0] + z[1])).*part;
                }});
}

void Contents::addTemperature() {
    addDerived(
        {"air_temperature", "air_temperature", "K", "from potential temperature and pressure",
         NEPH_ROLE_AIR_TEMPERATURE, NEPH_SPECIES_NONE, description.size},
        {{{*potentialTemperature}, {*find(NEPH_ROLE_AIR_PRESSURE)}},
         [gas = gas](std::span<const double> of, std::size_t) {
             return temperatureK(of[0], of[1], gas);
         }});
}

void Contents::addDensity() {
    Derived derived{{{*find(NEPH_ROLE_AIR_TEMPERATURE)}, {*find(NEPH_ROLE_AIR_PRESSURE)}},
                    [gas = gas](std::span<const double> of, std::size_t) {
                        return dryDensity(of[0], of[1], of.size() > 2 ? of[2] : 0.0, gas);
                    }};
    if (vapour) {
        derived.inputs.push_back({*vapour});
    } else {
        description.notes.push_back("Water vapour is missing: the air is treated as dry.");
    }
    addDerived({"dry_air_density", "", "kg m-3",
                "density of dry air, from pressure, temperature and vapour",
                NEPH_ROLE_DRY_AIR_DENSITY, NEPH_SPECIES_NONE, description.size},
               std::move(derived));
}

void Contents::withoutHumidity() {
    const auto index = find(NEPH_ROLE_WATER_VAPOUR);
    if (!index) return;
    plugin::Variable& variable = description.variables[*index];
    variable.role = NEPH_ROLE_OTHER;
    description.notes.push_back(
        fmt::format("{} gives no humidity: pressure or temperature of the air is neither in the "
                    "files nor derivable from them.",
                    variable.name));
}

void Contents::completeAir() {
    if (!find(NEPH_ROLE_INTERFACE_HEIGHT)) {
        addProfile({"interface_height", "altitude", "m", "height of layer interfaces",
                    NEPH_ROLE_INTERFACE_HEIGHT},
                   interfacesM);
    }
    const bool pressureKnown = find(NEPH_ROLE_AIR_PRESSURE).has_value();
    const bool temperatureKnown = find(NEPH_ROLE_AIR_TEMPERATURE).has_value() ||
                                  (pressureKnown && potentialTemperature.has_value());
    if (!pressureKnown) {
        addStandard({"air_pressure", "air_pressure", "Pa", "", NEPH_ROLE_AIR_PRESSURE},
                    &Air::pressurePa);
    }
    if (!temperatureKnown) {
        addStandard({"air_temperature", "air_temperature", "K", "", NEPH_ROLE_AIR_TEMPERATURE},
                    &Air::temperatureK);
    } else if (!find(NEPH_ROLE_AIR_TEMPERATURE)) {
        addTemperature();
    }
    if (!pressureKnown || !temperatureKnown) withoutHumidity();
    if (find(NEPH_ROLE_DRY_AIR_DENSITY)) return;
    if (pressureKnown && temperatureKnown) return addDensity();
    addStandard({"dry_air_density", "", "kg m-3", "", NEPH_ROLE_DRY_AIR_DENSITY},
                &Air::densityKgPerM3);
    const double low = centresOf(interfacesM).front();
    const double high = centresOf(interfacesM).back();
    description.notes.push_back(fmt::format(
        "Air density is neither in the files nor derivable from them; the {} is used instead: "
        "{:.3f} kg/m³ at {:.0f} m and {:.3f} kg/m³ at {:.0f} m.",
        kStandard, standardAtmosphere(low).densityKgPerM3, low,
        standardAtmosphere(high).densityKgPerM3, high));
}

std::unique_ptr<plugin::File> makeFile(Contents contents) {
    return std::make_unique<ContentsFile>(std::move(contents));
}

}  // namespace les
