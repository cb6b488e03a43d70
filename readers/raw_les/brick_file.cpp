// brick_file.cpp: turns a parsed sidecar into variables that can be read.
#include "readers/raw_les/brick_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <map>

#include "readers/raw_les/plausible.h"
#include "readers/raw_les/sidecar.h"

namespace les {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

/// What a role of the sidecar means to the host. Without a quantity the unit is passed on as it is.
struct BrickMeaning {
    NephRole role;
    std::optional<Quantity> quantity;
    const char* standardName;
};

BrickMeaning meaningOf(BrickRole role) {
    switch (role) {
        case BrickRole::mixingRatio:
            return {NEPH_ROLE_MIXING_RATIO, Quantity::ratio, ""};
        case BrickRole::numberConcentration:
            return {NEPH_ROLE_NUMBER_CONCENTRATION, Quantity::number, ""};
        case BrickRole::effectiveRadius:
            return {NEPH_ROLE_EFFECTIVE_RADIUS, Quantity::radius, ""};
        case BrickRole::dryAirDensity:
            return {NEPH_ROLE_DRY_AIR_DENSITY, Quantity::density, ""};
        case BrickRole::airPressure:
            return {NEPH_ROLE_AIR_PRESSURE, Quantity::pressure, "air_pressure"};
        case BrickRole::airTemperature:
            return {NEPH_ROLE_AIR_TEMPERATURE, Quantity::temperature, "air_temperature"};
        case BrickRole::potentialTemperature:
            return {NEPH_ROLE_OTHER, Quantity::temperature, "air_potential_temperature"};
        case BrickRole::vapourMixingRatio:
            return {NEPH_ROLE_WATER_VAPOUR, Quantity::ratio, "humidity_mixing_ratio"};
        case BrickRole::other:
            break;
    }
    return {NEPH_ROLE_OTHER, {}, ""};
}

/// Bytes of one variable at one time.
std::uint64_t fieldBytes(const Sidecar& sidecar, const BrickVariable& variable) {
    std::uint64_t bytes = bytesOf(variable.type);
    for (const std::size_t n : sidecar.shape) bytes *= n;  // at most 8 · 2⁶⁰
    return bytes;
}

/// Throws Error unless every file ends where the last variable in it ends: a size that does not
/// fit is the only hint that the shape or the number type is wrong.
void requireSizes(const Sidecar& sidecar, const fs::path& folder) {
    std::map<std::string, std::uint64_t> ends;
    for (const BrickVariable& variable : sidecar.variables) {
        const std::uint64_t times = variable.files.size() == 1 ? sidecar.times.size() : 1;
        std::uint64_t end = 0;
        if (__builtin_mul_overflow(fieldBytes(sidecar, variable), times, &end) ||
            __builtin_add_overflow(end, variable.firstByte, &end)) {
            throw Error{
                fmt::format("variable {} is larger than any disk", variable.name), {}, {}, {}};
        }
        for (const std::string& file : variable.files) {
            if (!file.empty()) ends[file] = std::max(ends[file], end);
        }
    }
    for (const auto& [file, end] : ends) {
        const std::string path = (folder / file).string();
        const auto found = fileSize(path);
        if (found == end) continue;
        const char* what = !found         ? "is missing"
                           : *found < end ? "is shorter than its sidecar states"
                                          : "is longer than its sidecar states";
        Error error{
            what, found ? fmt::format("{} bytes", *found) : std::string(),
            fmt::format("{} bytes: {} x {} x {} cells, {} time(s) in total", end, sidecar.shape[0],
                        sidecar.shape[1], sidecar.shape[2], sidecar.times.size()),
            "check shape, numbers and times in the sidecar", path};
        describeSize(path, error);
        throw error;
    }
}

/// Conversion from the unit in the sidecar to SI. Throws Error for an unknown unit.
shared::Conversion conversionOf(const BrickVariable& variable, const BrickMeaning& meaning) {
    if (!meaning.quantity) return {};
    if (const auto found = toSi(*meaning.quantity, variable.unit)) return *found;
    throw Error{fmt::format("the unit of variable {} is not known", variable.name),
                inQuotes(variable.unit),
                acceptedUnits(*meaning.quantity),
                {}};
}

/// Adds one variable. A profile is held in memory; of a stored one, which is located when a time is
/// read, the place is returned.
Locate addVariable(const Sidecar& sidecar, const fs::path& folder, const BrickVariable& from,
                   Contents& contents) {
    const BrickMeaning meaning = meaningOf(from.role);
    const shared::Conversion toSi = conversionOf(from, meaning);
    plugin::Variable variable{from.name,
                              meaning.standardName,
                              meaning.quantity ? siUnit(*meaning.quantity) : from.unit,
                              from.description,
                              meaning.role,
                              from.species,
                              contents.description.size};
    if (from.role != BrickRole::other) variable.reason = "the sidecar states it";
    if (from.role == BrickRole::potentialTemperature) {
        contents.potentialTemperature = contents.sources.size();
    }
    if (from.role == BrickRole::vapourMixingRatio) contents.vapour = contents.sources.size();
    if (!from.profile.empty()) {
        Source source;
        variable.size[0] = variable.size[1] = 1;
        for (const double value : from.profile) {
            source.profile.push_back(static_cast<float>(toSi(value * from.scale + from.offset)));
        }
        contents.add(std::move(variable), std::move(source));
        return {};
    }
    RawField field;
    field.firstByte = from.firstByte;
    field.size = sidecar.shape;
    field.type = from.type;
    field.swapped = sidecar.bigEndian != (std::endian::native == std::endian::big);
    field.missing = from.missing;
    field.scale = from.scale * toSi.scale;
    field.offset = toSi(from.offset);
    const std::uint64_t bytes = fieldBytes(sidecar, from);
    const bool together = from.files.size() == 1;
    Locate locate = [field, folder, bytes, together, files = from.files](std::size_t time) {
        RawField at = field;
        const std::string& file = files[together ? 0 : time];
        at.path = file.empty() ? "" : (folder / file).string();
        if (together) at.firstByte += time * bytes;
        return at;
    };
    contents.add(std::move(variable), storedAt(locate));
    return locate;
}

/// Throws Error if the numbers make sense only in the byte order that is not stated.
void requireOrder(const Sidecar& sidecar, const std::vector<Locate>& places) {
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < sidecar.variables.size(); ++i) {
        const auto quantity = meaningOf(sidecar.variables[i].role).quantity;
        const NumberType type = sidecar.variables[i].type;
        const bool real = type == NumberType::float32 || type == NumberType::float64;
        if (!quantity || !real || !places[i]) continue;
        for (const std::size_t time : {std::size_t{0}, sidecar.times.size() - 1}) {
            probes.push_back({places[i](time), *quantity});
        }
    }
    const Shares shares = sharesOf(probes);
    if (!isOtherOrder(shares)) return;
    throw Error{"the numbers do not have the byte order that the sidecar states",
                sharesText(shares, sidecar.bigEndian),
                fmt::format("{}-endian numbers", sidecar.bigEndian ? "big" : "little"),
                fmt::format("write \"byte_order\": \"{}\" into the sidecar",
                            sidecar.bigEndian ? "little" : "big")};
}

/// Adds sums where several variables are the same species.
void addSums(Contents& contents) {
    std::map<std::pair<NephRole, NephSpecies>, std::vector<std::size_t>> groups;
    const auto& variables = contents.description.variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (variables[i].role == NEPH_ROLE_MIXING_RATIO ||
            variables[i].role == NEPH_ROLE_NUMBER_CONCENTRATION) {
            groups[{variables[i].role, variables[i].species}].push_back(i);
        }
    }
    for (const auto& [key, members] : groups) {
        if (members.size() > 1) contents.addSum(members);
    }
}

/// Description and sources of all variables. Throws Error.
Contents describe(const Sidecar& sidecar, const fs::path& folder) {
    requireSizes(sidecar, folder);
    Contents contents;
    plugin::Description& d = contents.description;
    d.model = sidecar.model;
    d.scheme = sidecar.scheme;
    d.microphysics = sidecar.microphysics;
    d.cloudDropletsPerM3 = sidecar.cloudDropletsPerM3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        d.size[axis] = static_cast<int>(sidecar.shape[axis]);
    }
    d.spacingM = sidecar.spacingM;
    d.edgesM = sidecar.edgesM;
    d.times = sidecar.times;
    d.projection = sidecar.projection;
    d.utcOfZero = sidecar.utcOfZero;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::vector<double>& edges = sidecar.edgesM[axis];
        const double extentM = edges.empty() ? sidecar.spacingM[axis] * d.size[axis] : edges.back();
        d.mapOriginM[axis] = -0.5 * extentM;
    }
    d.notes = sidecar.notes;
    contents.interfacesM = sidecar.interfacesM;
    std::vector<Locate> places;
    for (const BrickVariable& variable : sidecar.variables) {
        places.push_back(addVariable(sidecar, folder, variable, contents));
        for (const std::string& file : variable.files) {
            const std::string path = (folder / file).string();
            if (!file.empty() && std::ranges::find(d.parts, path) == d.parts.end()) {
                d.parts.push_back(path);
            }
        }
    }
    requireOrder(sidecar, places);
    addSums(contents);
    contents.completeAir();
    return contents;
}

}  // namespace

int scoreSidecar(const std::string& path) {
    const auto text = findText(path);
    return text && looksLikeSidecar(*text) ? 80 : 0;
}

std::unique_ptr<plugin::File> openBrick(const std::string& sidecarPath) {
    try {
        return makeFile(describe(parseSidecar(readText(sidecarPath)), folderOf(sidecarPath)));
    } catch (Error& error) {
        if (error.where.empty()) error.where = sidecarPath;
        throw;
    }
}

std::vector<std::string> sidecars(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json") continue;
        if (scoreSidecar(entry.path().string()) > 0) found.push_back(entry.path().string());
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace les
