// contents.cpp: sorts fields by time and level.
#include "readers/grib/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "readers/shared/calendar.h"

namespace grib {
namespace {

constexpr std::size_t kMostLevels = 4096;

constexpr Parameter kHeightParameters[]{{0, 3, 5}, {0, 3, 6}, {0, 3, 4}};
constexpr Parameter kHeatParameters[]{{0, 0, 0}, {0, 0, 2}, {0, 0, 15}};
constexpr Parameter kPressureParameters[]{{0, 3, 0}};
constexpr Parameter kVapourParameters[]{{0, 1, 0}, {0, 1, 2}, {0, 1, 1}, {0, 0, 6}};

/// A field that is known, on the grid that is read.
struct Entry {
    std::size_t field;
    Product product;
};

bool isLevel(unsigned surface) {
    return surface == kHybrid || surface == kIsobaric;
}

/// Fields of one kind of levels.
class LevelSorter {
  public:
    LevelSorter(const std::vector<Entry>& entries, unsigned surface) : surface_(surface) {
        for (const Entry& entry : entries) {
            const Product& p = entry.product;
            if (p.surface != surface) continue;
            fields_[p.parameter][p.seconds].try_emplace(p.level, entry.field);
        }
    }

    /// The parameter of `choice` that is on the most levels at some time; null if none is.
    const Parameter* best(std::span<const Parameter> choice) const {
        const Parameter* found = nullptr;
        std::size_t most = 0;
        for (const Parameter& parameter : choice) {
            const auto times = fields_.find(parameter);
            if (times == fields_.end()) continue;
            for (const auto& [seconds, levels] : times->second) {
                if (levels.size() <= most) continue;
                most = levels.size();
                found = &parameter;
            }
        }
        return found;
    }

    /// Levels at a time that have all of `needed`.
    std::set<double> levelsWith(std::span<const Parameter> needed, double seconds) const {
        std::set<double> common;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            std::set<double> own;
            for (const auto& [level, field] : at(needed[i], seconds)) own.insert(level);
            if (i == 0) common = own;
            std::erase_if(common, [&](double level) { return !own.contains(level); });
        }
        return common;
    }

    std::set<double> times() const {
        std::set<double> all;
        for (const auto& [parameter, times] : fields_) {
            for (const auto& [seconds, levels] : times) all.insert(seconds);
        }
        return all;
    }

    const std::map<double, std::size_t>& at(const Parameter& parameter, double seconds) const {
        static const std::map<double, std::size_t> none;
        const auto times = fields_.find(parameter);
        if (times == fields_.end()) return none;
        const auto levels = times->second.find(seconds);
        return levels == times->second.end() ? none : levels->second;
    }

    /// "HGT on 50, TMP on 50": how many levels have what, for messages.
    std::string summary() const {
        std::string text;
        for (const auto& [parameter, times] : fields_) {
            std::size_t most = 0;
            for (const auto& [seconds, levels] : times) most = std::max(most, levels.size());
            text +=
                fmt::format("{}{} on {}", text.empty() ? "" : ", ", parameterName(parameter), most);
        }
        return text.empty() ? "none" : text;
    }

    unsigned surface() const { return surface_; }
    const auto& fields() const { return fields_; }

  private:
    unsigned surface_;
    /// Parameter, seconds, level.
    std::map<Parameter, std::map<double, std::map<double, std::size_t>>> fields_;
};

/// The air on one kind of levels, where all of it is there.
struct AirChoice {
    const Parameter *height = nullptr, *heat = nullptr, *pressure = nullptr;
    std::map<double, std::set<double>> levels;  ///< complete ones, by time
    std::size_t most = 0;                       ///< of them at one time
};

AirChoice airOf(const LevelSorter& sorter) {
    AirChoice air;
    air.height = sorter.best(kHeightParameters);
    air.heat = sorter.best(kHeatParameters);
    air.pressure = sorter.best(kPressureParameters);
    if (air.height == nullptr || air.heat == nullptr) return air;
    std::vector<Parameter> needed{*air.height, *air.heat};
    if (sorter.surface() == kHybrid) {
        if (air.pressure == nullptr) return air;
        needed.push_back(*air.pressure);
    }
    for (const double seconds : sorter.times()) {
        auto levels = sorter.levelsWith(needed, seconds);
        air.most = std::max(air.most, levels.size());
        if (!levels.empty()) air.levels.emplace(seconds, std::move(levels));
    }
    return air;
}

/// The first field on the grid that most fields on levels have; null if there are none.
const Field* fieldOfMainGrid(const Inventory& inventory) {
    struct Count {
        std::size_t fields = 0;
        const Field* first = nullptr;
    };
    std::map<const Bytes*, Count> counts;
    const Count* best = nullptr;
    for (const Field& field : inventory.fields) {
        const auto product = productOf(field);
        if (!product || !isLevel(product->surface)) continue;
        Count& count = counts[field.grid.get()];
        if (count.fields++ == 0) count.first = &field;
        if (best == nullptr || count.fields > best->fields) best = &count;
    }
    return best == nullptr ? nullptr : best->first;
}

/// The grid of a field. Throws Failure that names the message.
Grid gridOfField(const Field& field) {
    try {
        return gridOf(*field.grid);
    } catch (Failure& failure) {
        failure.what = fieldName(field) + ": " + failure.what;
        throw;
    }
}

/// The entries on a grid, of one member of an ensemble.
std::vector<Entry> entriesOf(const Inventory& inventory, const Bytes& grid,
                             std::vector<std::string>& notes) {
    std::vector<Entry> entries;
    std::size_t otherGrids = 0, otherMembers = 0;
    long member = -2;
    for (std::size_t i = 0; i < inventory.fields.size(); ++i) {
        const auto product = productOf(inventory.fields[i]);
        if (!product) continue;
        if (*inventory.fields[i].grid != grid) {
            otherGrids += isLevel(product->surface) ? 1 : 0;
            continue;
        }
        if (member == -2 && isLevel(product->surface)) member = product->member;
        if (member != -2 && product->member != member) {
            ++otherMembers;
            continue;
        }
        entries.push_back({i, *product});
    }
    if (otherGrids > 0) {
        notes.push_back(
            fmt::format("{} fields on levels have another grid: they are not read.", otherGrids));
    }
    if (otherMembers > 0) {
        notes.push_back(
            fmt::format("The file has several members of an ensemble: member {} is "
                        "read, {} fields of others are not.",
                        member, otherMembers));
    }
    return entries;
}

[[noreturn]] void failWithoutAir(const Inventory& inventory, const LevelSorter& hybrid,
                                 const LevelSorter& isobaric) {
    if (inventory.otherEdition > 0 && inventory.fields.empty()) {
        throw Failure{"it is GRIB of edition 1", fmt::format("{} messages", inventory.otherEdition),
                      "GRIB of edition 2", "convert it with NCEP's tool: cnvgrib -g12 IN OUT"};
    }
    throw Failure{"it has no levels with height, pressure and temperature",
                  fmt::format("fields: {}; hybrid levels: {}; isobaric levels: {}",
                              inventory.fields.size(), hybrid.summary(), isobaric.summary()),
                  "HGT, PRES and TMP on hybrid levels, or HGT and TMP on isobaric levels",
                  "of HRRR and RRFS give the files of native levels (wrfnat, natlev) or pressure "
                  "levels (wrfprs, prslev), not those of the surface; grib_ls FILE lists what a "
                  "file holds"};
}

/// Notes about messages that are not read.
void noteMessages(const Inventory& inventory, std::vector<std::string>& notes) {
    if (!inventory.damaged.empty()) {
        notes.push_back(
            fmt::format("{} of {} messages {} damaged and left out, the first of them "
                        "message {}.",
                        inventory.damaged.size(), inventory.messages,
                        inventory.damaged.size() == 1 ? "is" : "are", inventory.damaged.front()));
    }
    if (inventory.otherEdition > 0) {
        notes.push_back(fmt::format("{} messages are GRIB of edition 1: they are not read.",
                                    inventory.otherEdition));
    }
}

/// Chooses the times that have all levels, and notes the others.
void chooseLevels(Contents& contents, const AirChoice& air) {
    std::set<double> levels;
    for (const auto& [seconds, own] : air.levels) {
        if (own.size() > levels.size()) levels = own;
    }
    for (const auto& [seconds, own] : air.levels) {
        const bool whole = std::ranges::includes(own, levels);
        const std::string label = shared::dateOfSeconds(seconds);
        if (whole) {
            contents.times.push_back({seconds, label});
        } else {
            contents.notes.push_back(fmt::format("The time {} is left out: it has {} of {} levels.",
                                                 label, own.size(), levels.size()));
        }
    }
    contents.levels.assign(levels.begin(), levels.end());
    if (contents.surface == kIsobaric) std::ranges::reverse(contents.levels);
    if (contents.levels.size() < 2 || contents.levels.size() > kMostLevels) {
        throw Failure{contents.levels.size() < 2 ? "it has height, pressure and temperature on one "
                                                   "level only"
                                                 : "it has more levels than any model",
                      fmt::format("{} levels", contents.levels.size()),
                      fmt::format("2 to {}", kMostLevels),
                      "give a file with all levels of the model"};
    }
}

void stackFields(Contents& contents, const LevelSorter& sorter) {
    for (const auto& [parameter, times] : sorter.fields()) {
        Stack stack;
        bool any = false;
        for (const Moment& moment : contents.times) {
            const auto& own = sorter.at(parameter, moment.seconds);
            std::vector<std::size_t>& column = stack.emplace_back();
            for (const double level : contents.levels) {
                const auto found = own.find(level);
                column.push_back(found == own.end() ? kNoField : found->second);
                any = any || found != own.end();
            }
        }
        if (any) contents.stacks.emplace(parameter, std::move(stack));
    }
}

/// Levels that the air does not have but something else does.
void noteOtherLevels(Contents& contents, const LevelSorter& sorter) {
    std::set<double> others;
    for (const auto& [parameter, times] : sorter.fields()) {
        for (const auto& [seconds, levels] : times) {
            for (const auto& [level, field] : levels) others.insert(level);
        }
    }
    for (const double level : contents.levels) others.erase(level);
    if (others.empty()) return;
    contents.notes.push_back(fmt::format(
        "{} levels lack {} and are left out, the first of them {}.", others.size(),
        contents.surface == kHybrid ? "height, pressure or temperature" : "height or temperature",
        levelName(contents.surface, *others.begin())));
}

bool isWhole(const Stack* stack) {
    return stack != nullptr && std::ranges::all_of(*stack, [](const auto& column) {
               return std::ranges::find(column, kNoField) == column.end();
           });
}

}  // namespace

Contents contentsOf(const Inventory& inventory) {
    Contents contents;
    noteMessages(inventory, contents.notes);
    std::vector<Entry> entries;
    if (const Field* main = fieldOfMainGrid(inventory)) {
        contents.grid = gridOfField(*main);
        entries = entriesOf(inventory, *main->grid, contents.notes);
    }
    const LevelSorter hybrid(entries, kHybrid), isobaric(entries, kIsobaric);
    const AirChoice onHybrid = airOf(hybrid), onIsobaric = airOf(isobaric);
    if (onHybrid.most == 0 && onIsobaric.most == 0) failWithoutAir(inventory, hybrid, isobaric);
    const bool native = onHybrid.most >= onIsobaric.most;
    const AirChoice& air = native ? onHybrid : onIsobaric;
    const LevelSorter& sorter = native ? hybrid : isobaric;
    contents.surface = native ? kHybrid : kIsobaric;
    contents.height = *air.height;
    contents.temperature = *air.heat;
    if (native) contents.pressure = *air.pressure;
    chooseLevels(contents, air);
    noteOtherLevels(contents, sorter);
    stackFields(contents, sorter);
    for (const Parameter& parameter : kVapourParameters) {
        if (!isWhole(contents.find(parameter))) continue;
        contents.vapour = parameter;
        contents.hasVapour = true;
        break;
    }
    contents.groundHeight.assign(contents.times.size(), kNoField);
    contents.groundPressure = contents.groundHeight;
    for (const Entry& entry : entries) {
        const Product& p = entry.product;
        if (p.surface == contents.surface && contents.first.surface == 0) contents.first = p;
        if (p.surface != kGround) continue;
        for (std::size_t t = 0; t < contents.times.size(); ++t) {
            if (contents.times[t].seconds != p.seconds) continue;
            if (p.parameter == Parameter{0, 3, 5}) contents.groundHeight[t] = entry.field;
            if (p.parameter == Parameter{0, 3, 0}) contents.groundPressure[t] = entry.field;
        }
    }
    return contents;
}

}  // namespace grib
