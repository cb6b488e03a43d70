// variables.cpp: roles of the stored variables. What is derived from them is in derived.cpp.
#include "readers/cf_les/variables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "readers/cf_les/derived.h"
#include "readers/les/microhh_air.h"
#include "readers/les/names.h"
#include "readers/les/numbers.h"
#include "readers/les/terrain.h"
#include "readers/les/text.h"
#include "readers/les/twins.h"

namespace cf {
namespace {

namespace plugin = neph::plugin;

// Fields are read in pieces of about this many values, to limit memory and to respond to a
// cancellation soon.
constexpr std::size_t kPieceValues = 1U << 20U;

bool isWind(Meaning meaning) {
    return meaning == Meaning::xWind || meaning == Meaning::yWind || meaning == Meaning::upwardWind;
}

bool isEssential(Meaning meaning) {
    return meaning != Meaning::number && meaning != Meaning::radius && meaning != Meaning::other &&
           !isWind(meaning);
}

/// Reads a variable box by box, along the outermost axis of the file.
class Field {
  public:
    Field(std::shared_ptr<const DataSet> data, const Stored& stored, shared::Conversion toSi)
        : data_(std::move(data)),
          stored_(stored),
          toSi_(toSi),
          onGrid_(data_->grid.holds(stored)) {}

    void operator()(std::size_t time, const les::Box& box, std::span<float> values,
                    const les::Tick& tick) const {
        const std::size_t step = levelsPerPiece(box);
        for (std::size_t z = box.lower[2]; z < box.upper[2]; z += step) {
            tick(static_cast<double>(z - box.lower[2]) / static_cast<double>(box.length(2)));
            les::Box piece = box;
            piece.lower[2] = z;
            piece.upper[2] = std::min(z + step, box.upper[2]);
            readPiece(time, piece, values.subspan((z - box.lower[2]) * box.plane(), piece.count()));
        }
        tick(1.0);
    }

  private:
    /// Whole chunks where the file is chunked; everything at once where levels are not outermost.
    std::size_t levelsPerPiece(const les::Box& box) const {
        const auto& axis = stored_.layout.axis;
        const bool outermost = axis[2] && (!axis[1] || *axis[2] < *axis[1]);
        if (!outermost) return std::max<std::size_t>(box.length(2), 1);
        const auto& chunk = stored_.variable->chunk;
        const std::size_t whole = chunk.empty() ? 1 : std::max<std::size_t>(chunk[*axis[2]], 1);
        const std::size_t levels = std::max<std::size_t>(kPieceValues / box.plane(), 1);
        return (levels + whole - 1) / whole * whole;
    }

    void readPiece(std::size_t time, const les::Box& box, std::span<float> values) const {
        const Grid& grid = data_->grid;
        const les::Box from = onGrid_ ? grid.storedBox(box, stored_.layout) : box;
        data_->files.file(stored_.file)
            .read(*stored_.variable, stored_.layout, data_->records[time], from, values);
        if (onGrid_) turn(values, box, grid.flip, stored_.layout);
        if (toSi_.isIdentity()) return;
        for (float& value : values) value = static_cast<float>(toSi_(static_cast<double>(value)));
    }

    std::shared_ptr<const DataSet> data_;
    Stored stored_;
    shared::Conversion toSi_;
    bool onGrid_;
};

class VariableAdder {
  public:
    VariableAdder(const std::shared_ptr<const DataSet>& data, bool hail, les::Contents& contents)
        : data_(data), hail_(hail), contents_(contents) {}
    void add();

  private:
    /// The variables with names of the row in its order, which is that of preference where two have
    /// one meaning, then the others as stored.
    std::vector<const Stored*> inOrder() const;
    void addStored(const Stored& stored);
    void addReferenceAir();
    /// Nothing for a variable that does not lie on the columns of the grid.
    std::optional<std::array<int, 3>> sizeOf(const Stored& stored) const;
    /// The conversion to SI of a known variable; nothing if its unit is of another kind.
    std::optional<shared::Conversion> conversionOf(const Stored& stored);
    void setRole(const Stored& stored, plugin::Variable& variable);
    void note(const std::vector<std::string>& names, std::string_view text);
    void noteUnits();
    void addTerrain();

    std::shared_ptr<const DataSet> data_;
    bool hail_;
    les::Contents& contents_;
    Meanings meanings_;
    les::Terrain terrain_;
    std::vector<std::string> otherUnit_, offGrid_, unknown_, assumed_, corrected_;
};

std::optional<std::array<int, 3>> VariableAdder::sizeOf(const Stored& stored) const {
    const Grid& grid = data_->grid;
    const Layout& layout = stored.layout;
    const bool shaped = layout.isField() || layout.isPlane() || layout.isProfile();
    if (!shaped) return {};
    std::array<int, 3> size{1, 1, 1};
    const bool onGrid = grid.holds(stored);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!layout.axis[axis]) continue;
        const std::size_t length = data_->files.file(stored.file)
                                       .lengthOf(axis, layout.face[axis],
                                                 stored.variable->axes[*layout.axis[axis]].length);
        if (onGrid && length != grid.stored[axis]) return {};
        size[axis] = static_cast<int>(onGrid ? grid.size[axis] : length);
    }
    return size;
}

std::optional<shared::Conversion> VariableAdder::conversionOf(const Stored& stored) {
    const Name& name = *stored.name;
    const les::Quantity quantity = quantityOf(name.meaning);
    const std::string& stated = stored.variable->units;
    std::string unit = stated;
    if (name.unitHolds || stated.empty()) {
        unit = name.unit;
        if (unit.empty()) unit = les::siUnit(quantity);
        if (stated.empty())
            assumed_.push_back(fmt::format("{} in {}", stored.variable->name, unit));
        const auto asStated = les::toSi(quantity, stated);
        const auto asKnown = les::toSi(quantity, unit);
        const bool same = asStated && asKnown && asStated->scale == asKnown->scale;
        if (!stated.empty() && !same) {
            corrected_.push_back(
                fmt::format("{} ({} stated, {} taken)", stored.variable->name, stated, unit));
        }
    }
    if (name.meaning == Meaning::number && shared::conversion(unit, "m-3")) {
        meanings_.perVolume.insert(contents_.sources.size());
        return shared::conversion(unit, "m-3");
    }
    auto conversion = les::toSi(quantity, unit);
    // A deviation has no zero of its own: degrees are kelvins.
    const bool deviation = name.meaning == Meaning::thetaDeviation;
    if (conversion && deviation) conversion->offset = 0.0;
    return conversion;
}

void VariableAdder::setRole(const Stored& stored, plugin::Variable& variable) {
    const Name& name = *stored.name;
    const std::size_t index = contents_.sources.size();
    variable.species = name.species;
    if (variable.species == NEPH_SPECIES_GRAUPEL && hail_) variable.species = NEPH_SPECIES_HAIL;
    const bool standard = name.name.empty();
    variable.reason = standard ? "its standard name is " + name.standardName
                      : !data_->model.reason.empty()
                          ? data_->model.reason
                          : fmt::format("{} writes {} under this name", data_->model.title,
                                        meaningText(name.meaning, variable.species));
    if (!name.standardName.empty()) variable.standardName = name.standardName;
    const bool moist = name.perMoistAir || (!standard && data_->model.perMoistAir);
    if (moist) meanings_.perMoistAir.insert(index);
    switch (name.meaning) {
        case Meaning::hydrometeor:
            variable.role = NEPH_ROLE_MIXING_RATIO;
            break;
        case Meaning::number:
            variable.role = meanings_.perVolume.contains(index) ? NEPH_ROLE_OTHER
                                                                : NEPH_ROLE_NUMBER_CONCENTRATION;
            break;
        case Meaning::radius:
            variable.role = NEPH_ROLE_EFFECTIVE_RADIUS;
            break;
        case Meaning::pressure:
            variable.role = NEPH_ROLE_AIR_PRESSURE;
            break;
        case Meaning::temperature:
            variable.role = NEPH_ROLE_AIR_TEMPERATURE;
            break;
        case Meaning::dryDensity:
            variable.role = NEPH_ROLE_DRY_AIR_DENSITY;
            break;
        case Meaning::xWind:
            variable.role = NEPH_ROLE_X_WIND;
            break;
        case Meaning::yWind:
            variable.role = NEPH_ROLE_Y_WIND;
            break;
        case Meaning::upwardWind:
            variable.role = NEPH_ROLE_UPWARD_WIND;
            break;
        case Meaning::ground:
            terrain_.ground = index;
            break;
        case Meaning::cellHeight:
            terrain_.cellHeight = index;
            break;
        default:
            break;
    }
    if (variable.role == NEPH_ROLE_OTHER && name.meaning != Meaning::number) {
        variable.species = NEPH_SPECIES_NONE;
    }
    meanings_.known.emplace(name.meaning, index);
}

std::vector<const Stored*> VariableAdder::inOrder() const {
    const std::vector<Name>& names = data_->model.names;
    const auto rank = [&](const Stored* stored) {
        const auto place =
            std::ranges::find_if(names, [&](const Name& name) { return &name == stored->name; });
        return place - names.begin();
    };
    std::vector<const Stored*> order;
    for (const Stored& stored : data_->files.variables()) order.push_back(&stored);
    std::ranges::stable_sort(order, {}, rank);
    return order;
}

void VariableAdder::addStored(const Stored& stored) {
    const nc::NcVariable& from = *stored.variable;
    const auto size = sizeOf(stored);
    const bool meant = stored.name != nullptr && stored.name->meaning != Meaning::other;
    if (!size) {
        if (meant && isEssential(stored.name->meaning)) offGrid_.push_back(from.name);
        return;
    }
    const Layout& layout = stored.layout;
    const bool onGrid = data_->grid.holds(stored);
    const bool ground = meant && stored.name->meaning == Meaning::ground;
    const bool amount =
        meant &&
        (stored.name->meaning == Meaning::hydrometeor || stored.name->meaning == Meaning::number ||
         stored.name->meaning == Meaning::radius || stored.name->meaning == Meaning::cellHeight ||
         stored.name->meaning == Meaning::cloudCondensate ||
         stored.name->meaning == Meaning::precipitation || isWind(stored.name->meaning));
    const bool shaped = ground   ? layout.isPlane()
                        : amount ? layout.isField()
                                 : layout.isField() || layout.isProfile();
    const bool usable = meant && onGrid && shaped;
    // Plain integers are categories and masks.
    if (!usable && from.integer && !from.packing.packed()) return;
    if (!usable && layout.isProfile()) return;
    plugin::Variable variable{from.name, from.standardName, from.units, from.description};
    variable.size = *size;
    std::optional<shared::Conversion> conversion;
    if (usable) {
        conversion = conversionOf(stored);
        if (!conversion && isEssential(stored.name->meaning)) {
            const std::string_view accepted = les::acceptedUnits(quantityOf(stored.name->meaning));
            throw nc::Failure{
                fmt::format("the unit of variable {} is not known", from.name),
                les::inQuotes(from.units), std::string(accepted),
                fmt::format("set the unit that the values are in: ncatted -a units,{},o,c,\"{}\" "
                            "FILE",
                            from.name, accepted.substr(0, accepted.find(' ')))};
        }
        if (!conversion) otherUnit_.push_back(fmt::format("{} ({})", from.name, from.units));
    }
    if (conversion) {
        variable.units = les::siUnit(quantityOf(stored.name->meaning));
        if (meanings_.perVolume.contains(contents_.sources.size())) variable.units = "m-3";
        setRole(stored, variable);
    } else if (stored.name != nullptr && !stored.name->standardName.empty()) {
        variable.standardName = stored.name->standardName;
    }
    const bool ratio = from.units.find("kg") != std::string::npos &&
                       les::toSi(les::Quantity::ratio, from.units).has_value();
    if (stored.name == nullptr && onGrid && layout.isField() && ratio &&
        les::looksLikeHydrometeor(from.name)) {
        unknown_.push_back(from.name);
    }
    les::Source source;
    source.stored = Field(data_, stored, conversion.value_or(shared::Conversion{}));
    contents_.add(std::move(variable), std::move(source));
}

/// MicroHH's reference air, from the files of the case where 3d_to_nc.py was run. A file of n
/// levels has 2n + 1 densities, floats or doubles.
void VariableAdder::addReferenceAir() {
    if (!data_->model.microhhAir || meanings_.find(Meaning::referenceDensity)) return;
    const std::string folder =
        std::filesystem::path(data_->files.main().path()).parent_path().string();
    const std::string path = (std::filesystem::path(folder) / "rhoref.0000000").string();
    const auto bytes = les::fileSize(path);
    const std::size_t levels = data_->grid.size[2];
    if (!bytes || *bytes % 4 != 0) return;
    const std::size_t each = *bytes / 4 % 2 == 1 ? sizeof(float) : sizeof(double);
    if (*bytes != each * (2 * levels + 1)) return;
    const auto isAir = [](double density) {
        return density >= NEPH_LEAST_DENSITY_KG_PER_M3 && density <= NEPH_MOST_DENSITY_KG_PER_M3;
    };
    for (const bool swapped : {false, true}) {
        const les::MicrohhAir air = les::readMicrohhAir(folder, each, swapped, levels);
        if (!std::ranges::all_of(air.densityKgPerM3, isAir)) continue;
        const auto add = [&](plugin::Variable variable, const std::vector<double>& values) {
            if (values.empty()) return;
            les::Source source;
            source.profile.assign(values.begin(), values.end());
            variable.size = {1, 1, static_cast<int>(values.size())};
            variable.reason = "MicroHH's files of its reference air beside the data";
            contents_.add(std::move(variable), std::move(source));
        };
        meanings_.known.emplace(Meaning::referenceDensity, contents_.sources.size());
        add({"rhoref", "", "kg m-3", "reference density of moist air"}, air.densityKgPerM3);
        add({"pref", "air_pressure", "Pa", "reference pressure", NEPH_ROLE_AIR_PRESSURE},
            air.pressurePa);
        add({"tref", "air_temperature", "K", "reference temperature", NEPH_ROLE_AIR_TEMPERATURE},
            air.temperatureK);
        contents_.description.parts.push_back(path);
        return;
    }
}

void VariableAdder::note(const std::vector<std::string>& names, std::string_view text) {
    if (names.empty()) return;
    contents_.description.notes.push_back(
        fmt::format("{}: {}", les::joined(names),
                    fmt::format(fmt::runtime(text), names.size() == 1 ? "is" : "are")));
}

void VariableAdder::noteUnits() {
    note(otherUnit_, "{} not used, because the unit is of another kind.");
    note(offGrid_, "{} not used: off the grid of the hydrometeors.");
    note(unknown_,
         "{} listed and not drawn: by name and unit a hydrometeor, but none that is known.");
    note(assumed_, "{} taken in this unit, because the file states none.");
    note(corrected_, "{} taken in another unit than stated: the label is known to be wrong.");
}

/// Levels that follow the terrain: by the heights of cells, or by CM1's and Meso-NH's transform.
void VariableAdder::addTerrain() {
    if (!data_->model.terrainFollowing && !terrain_.cellHeight) return;
    if (!terrain_.ground && !terrain_.cellHeight) return;
    if (!les::isFlat(contents_, terrain_)) les::addTerrainHeights(contents_, terrain_);
}

void VariableAdder::add() {
    contents_.interfacesM = data_->grid.interfacesM;
    contents_.gas = data_->model.gas;
    for (const Stored* stored : inOrder()) addStored(*stored);
    addReferenceAir();
    // Before anything is computed: of two names of one water only one counts.
    note(les::settleTwins(contents_),
         "{} listed and not used, because another variable has the same meaning.");
    deriveAir(data_->model, meanings_, contents_);
    deriveWater(data_->model, meanings_, contents_);
    addTerrain();
    noteUnits();
    contents_.completeAir();
    deriveNumbers(meanings_, contents_);
}

}  // namespace

void addVariables(const std::shared_ptr<const DataSet>& data, bool hail, les::Contents& contents) {
    VariableAdder(data, hail, contents).add();
}

}  // namespace cf
