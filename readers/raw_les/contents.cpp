// contents.cpp: reading of stored, horizontally uniform and derived variables.
#include "readers/raw_les/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "readers/raw_les/levels.h"

namespace raw {
namespace {

namespace plugin = neph::plugin;

// Derived fields are computed in slabs of at most this many values, to limit memory and to respond
// to a cancellation soon.
constexpr std::size_t kSlabValues = 1U << 18U;

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
    void readDerived(Source::Derived derived, std::size_t time, const Box& box,
                     std::span<float> values, const Tick& tick) const;
    /// All values of a slab; profiles are expanded to its horizontal size.
    std::vector<float> readSlab(std::size_t variable, std::size_t time, const Box& slab) const;

    Contents contents_;
};

void ContentsFile::read(std::size_t variable, std::size_t time, const Box& box,
                        std::span<float> values, const Tick& tick) const {
    const Source& source = contents_.sources[variable];
    if (source.stored) return readStored(source, time, box, values, tick);
    if (source.derived != Source::Derived::none) {
        return readDerived(source.derived, time, box, values, tick);
    }
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
    readBox(source.stored(time), box, values.first(box.count()), tick);
}

std::vector<float> ContentsFile::readSlab(std::size_t variable, std::size_t time,
                                          const Box& slab) const {
    std::vector<float> values(slab.count());
    const plugin::Variable& info = contents_.description.variables[variable];
    Box box = slab;
    const bool isProfile = info.size[0] == 1 && info.size[1] == 1;
    if (isProfile) {
        box.lower[0] = box.lower[1] = 0;
        box.upper[0] = box.upper[1] = 1;
    }
    std::vector<float> read(box.count());
    this->read(variable, time, box, read, [](double) {});
    if (box.plane() == slab.plane()) return read;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = read[i / slab.plane()];
    return values;
}

/// Temperature from potential temperature and pressure, or dry air density from temperature,
/// pressure and vapour; docs/physics.md §7.
void ContentsFile::readDerived(Source::Derived derived, std::size_t time, const Box& box,
                               std::span<float> values, const Tick& tick) const {
    const std::size_t levels = std::max<std::size_t>(1, kSlabValues / box.plane());
    for (std::size_t z = box.lower[2]; z < box.upper[2]; z += levels) {
        tick(static_cast<double>(z - box.lower[2]) / static_cast<double>(box.length(2)));
        Box slab = box;
        slab.lower[2] = z;
        slab.upper[2] = std::min(z + levels, box.upper[2]);
        const auto pressure = readSlab(*contents_.find(NEPH_ROLE_AIR_PRESSURE), time, slab);
        const bool wantsDensity = derived == Source::Derived::density;
        const auto heat = readSlab(wantsDensity ? *contents_.find(NEPH_ROLE_AIR_TEMPERATURE)
                                                : *contents_.potentialTemperature,
                                   time, slab);
        std::vector<float> vapour(slab.count());
        if (wantsDensity && contents_.vapour) vapour = readSlab(*contents_.vapour, time, slab);
        const auto target = values.subspan((z - box.lower[2]) * box.plane(), slab.count());
        for (std::size_t i = 0; i < target.size(); ++i) {
            const double value =
                wantsDensity
                    ? dryDensity(static_cast<double>(heat[i]), static_cast<double>(pressure[i]),
                                 static_cast<double>(vapour[i]), contents_.gas)
                    : temperatureK(static_cast<double>(heat[i]), static_cast<double>(pressure[i]),
                                   contents_.gas);
            target[i] = static_cast<float>(value);
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

void Contents::addProfile(plugin::Variable variable, const std::vector<double>& values) {
    variable.size = {1, 1, static_cast<int>(values.size())};
    Source source;
    for (const double value : values) source.profile.push_back(static_cast<float>(value));
    add(std::move(variable), std::move(source));
}

void Contents::completeAir() {
    constexpr const char* kStandard = "U.S. Standard Atmosphere 1976";
    addProfile({"interface_height", "altitude", "m", "height of layer interfaces",
                NEPH_ROLE_INTERFACE_HEIGHT},
               interfacesM);
    std::vector<Air> air;
    for (const double height : centresOf(interfacesM)) air.push_back(standardAtmosphere(height));
    const auto standard = [&](double Air::*part) {
        std::vector<double> values;
        for (const Air& level : air) values.push_back(level.*part);
        return values;
    };
    const bool pressureKnown = find(NEPH_ROLE_AIR_PRESSURE).has_value();
    bool temperatureKnown = find(NEPH_ROLE_AIR_TEMPERATURE).has_value();
    if (!pressureKnown) {
        addProfile({"air_pressure", "air_pressure", "Pa", kStandard, NEPH_ROLE_AIR_PRESSURE},
                   standard(&Air::pressurePa));
    }
    if (!temperatureKnown && pressureKnown && potentialTemperature) {
        add({"air_temperature", "air_temperature", "K", "from potential temperature and pressure",
             NEPH_ROLE_AIR_TEMPERATURE, NEPH_SPECIES_NONE, description.size},
            {.derived = Source::Derived::temperature});
        temperatureKnown = true;
    } else if (!temperatureKnown) {
        addProfile(
            {"air_temperature", "air_temperature", "K", kStandard, NEPH_ROLE_AIR_TEMPERATURE},
            standard(&Air::temperatureK));
    }
    if (find(NEPH_ROLE_DRY_AIR_DENSITY)) return;
    if (pressureKnown && temperatureKnown) {
        add({"dry_air_density", "", "kg m-3",
             "density of dry air, from pressure, temperature and vapour", NEPH_ROLE_DRY_AIR_DENSITY,
             NEPH_SPECIES_NONE, description.size},
            {.derived = Source::Derived::density});
        if (!vapour)
            description.notes.push_back("Water vapour is missing: the air is treated as dry.");
        return;
    }
    addProfile({"dry_air_density", "", "kg m-3", kStandard, NEPH_ROLE_DRY_AIR_DENSITY},
               standard(&Air::densityKgPerM3));
    description.notes.push_back(fmt::format(
        "Air density is neither in the files nor derivable from them; the {} is used instead: "
        "{:.3f} kg/m³ at {:.0f} m and {:.3f} kg/m³ at {:.0f} m.",
        kStandard, air.front().densityKgPerM3, centresOf(interfacesM).front(),
        air.back().densityKgPerM3, centresOf(interfacesM).back()));
}

std::unique_ptr<plugin::File> makeFile(Contents contents) {
    return std::make_unique<ContentsFile>(std::move(contents));
}

}  // namespace raw
