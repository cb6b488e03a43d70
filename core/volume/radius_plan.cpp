// radius_plan.cpp: what the look asks for, what the data provide, and the extinction of cells.
#include "core/volume/radius_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "core/volume/radius_scheme.h"

namespace neph {
namespace {

std::string nameOf(const DatasetInfo& info, VariableRole role, std::optional<Species> species) {
    const VariableInfo* variable = info.find(role, species);
    return variable == nullptr ? std::string() : variable->name;
}

/// Whether the scheme has a size distribution for the species.
bool schemeSizes(Microphysics scheme, Species s) {
    if (scheme == Microphysics::lin) return s != Species::cloud && s != Species::ice;
    return scheme != Microphysics::unknown;
}

/// What the data lack for the diagnosis of the scheme; empty if it can be made.
std::optional<std::string> schemeLacks(const DatasetInfo& info, const RadiusRule& rule, Species s) {
    if (!schemeSizes(info.microphysics, s)) {
        return info.scheme.empty() ? "no known microphysics scheme"
                                   : fmt::format("no size by its scheme, {}", info.scheme);
    }
    if (rule.scheme == Microphysics::unknown) return "no air temperature";
    const bool counts = s != Species::cloud && schemeReadsNumber(rule.scheme, s);
    if (counts && rule.numberVariable.empty()) return "no number of particles";
    return {};
}

/// The assumption that applies if no source is available; core/volume/radius_scheme has the
/// numbers.
std::string_view assumption(Species s) {
    if (s == Species::cloud) return "100 droplets per cm³ are assumed";
    if (s == Species::ice) return "a radius of 30 µm is assumed";
    return "the size distribution of Lin is assumed";
}

std::string_view nameOf(RadiusSource source) {
    switch (source) {
        case RadiusSource::number:
            return "the number of particles gives the size";
        case RadiusSource::scheme:
            return "the microphysics scheme gives the size";
        case RadiusSource::constant:
        case RadiusSource::file:
            break;
    }
    return "";
}

/// Falls from file to number to scheme to an assumption until the data suffice. docs/physics.md §7
RadiusRule planRule(const DatasetInfo& info, Species s, RadiusSource wanted,
                    std::vector<std::string>& notes) {
    RadiusRule rule;
    rule.source = wanted;
    rule.scheme = info.microphysics;
    rule.radiusVariable = nameOf(info, VariableRole::effectiveRadius, s);
    rule.numberVariable = nameOf(info, VariableRole::numberConcentration, s);
    if (s == Species::cloud && rule.numberVariable.empty()) {
        rule.fixedNumberPerM3 = info.cloudDropletsPerM3;
    }
    if (schemeReadsTemperature(rule.scheme, s)) {
        rule.temperatureVariable = nameOf(info, VariableRole::airTemperature, {});
        if (rule.temperatureVariable.empty()) rule.scheme = Microphysics::unknown;
    }
    std::vector<std::string> lacks;
    if (rule.source == RadiusSource::file && rule.radiusVariable.empty()) {
        lacks.push_back("no effective radius");
        rule.source = RadiusSource::number;
    }
    if (rule.source == RadiusSource::number && rule.numberVariable.empty() &&
        rule.fixedNumberPerM3 <= 0.0) {
        lacks.push_back("no number of particles");
        rule.source = RadiusSource::scheme;
    }
    std::string_view instead = nameOf(rule.source);
    if (rule.source == RadiusSource::scheme) {
        if (const auto lack = schemeLacks(info, rule, s)) {
            if (lacks.empty() || lacks.back() != *lack) lacks.push_back(*lack);
            const bool counted = !rule.numberVariable.empty() || rule.fixedNumberPerM3 > 0.0;
            if (counted) rule.source = RadiusSource::number;
            instead = counted ? nameOf(rule.source) : assumption(s);
        }
    }
    if (rule.source == RadiusSource::scheme && !schemeReadsNumber(rule.scheme, s)) {
        rule.numberVariable.clear();
    }
    if (rule.source != RadiusSource::file) rule.radiusVariable.clear();
    if (!lacks.empty()) {
        notes.push_back(fmt::format("{}: the file has {}; {} instead.", neph::info(s).label,
                                    fmt::join(lacks, " and "), instead));
    }
    return rule;
}

/// The size of one cell, from the first source that has a value there; `gap` if that is not the
/// requested one.
struct CellSize {
    bool gap;
    ParticleSize size;
};

CellSize sizeOfCell(const RadiusRule& rule, Species s, RadiationOptics optics, double fileRadiusM,
                    const CellState& cell) {
    if (rule.source == RadiusSource::file && !isBackgroundRadius(s, fileRadiusM)) {
        return {false, sizeFromFile(rule.scheme, s, fileRadiusM)};
    }
    if (rule.source != RadiusSource::scheme && cell.numberPerM3 > 0.0) {
        return {rule.source == RadiusSource::file, sizeFromNumber(rule.scheme, s, cell)};
    }
    return {rule.source != RadiusSource::scheme, sizeFromScheme(rule.scheme, s, optics, cell)};
}

/// The value of a cell, if it is finite and above zero.
std::optional<double> valueAt(std::span<const float> values, std::size_t i) {
    if (values.empty() || !std::isfinite(values[i]) || values[i] <= 0.0f) return {};
    return static_cast<double>(values[i]);
}

}  // namespace

RadiusPlan planRadii(const Look& look, const DatasetInfo& info) {
    RadiusPlan plan;
    if (look.extinction == ExtinctionMode::equal) return plan;
    for (int i = 0; i < kSpeciesCount; ++i) {
        const auto s = static_cast<Species>(i);
        const RadiusSource wanted = look.of(s).radiusSource;
        if (wanted == RadiusSource::constant) continue;
        if (info.find(VariableRole::mixingRatio, s) == nullptr) continue;
        plan.rules[static_cast<std::size_t>(i)] = planRule(info, s, wanted, plan.notes);
        plan.optics = look.radiationOptics;
    }
    return plan;
}

RadiusPlan planAt(const RadiusPlan& plan, const DatasetInfo& there, std::string_view timeLabel) {
    RadiusPlan now = plan;
    const auto lacks = [&](const std::string& name) {
        return !name.empty() && there.find(name) == nullptr;
    };
    for (int i = 0; i < kSpeciesCount; ++i) {
        const auto s = static_cast<Species>(i);
        const RadiusRule& rule = plan.of(s);
        if (there.find(VariableRole::mixingRatio, s) == nullptr) continue;
        if (!lacks(rule.radiusVariable) && !lacks(rule.numberVariable) &&
            !lacks(rule.temperatureVariable)) {
            continue;
        }
        std::vector<std::string> notes;
        now.rules[static_cast<std::size_t>(i)] = planRule(there, s, rule.source, notes);
        for (const std::string& note : notes) {
            now.notes.push_back(fmt::format("{}: {}", timeLabel, note));
        }
    }
    return now;
}

bool statesSize(const DatasetInfo& info, Species species) {
    std::vector<std::string> notes;
    const RadiusRule rule = planRule(info, species, RadiusSource::file, notes);
    return rule.source != RadiusSource::scheme || !schemeLacks(info, rule, species);
}

RadiusGaps& RadiusGaps::operator+=(const RadiusGaps& other) {
    cells += other.cells;
    gaps += other.gaps;
    contentSum += other.contentSum;
    gapContentSum += other.gapContentSum;
    return *this;
}

RadiusGaps contentToExtinction(const RadiusPlan& plan, Species species, const RadiusCells& cells,
                               std::span<float> values) {
    const RadiusRule& rule = plan.of(species);
    RadiusGaps gaps;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0.0f)) continue;
        const CellState cell{
            .contentKgPerM3 = static_cast<double>(values[i]),
            .numberPerM3 = valueAt(cells.numberPerM3, i).value_or(rule.fixedNumberPerM3),
            .temperatureK = valueAt(cells.temperatureK, i).value_or(kFreezingK)};
        const double fileRadiusM = valueAt(cells.radiusM, i).value_or(0.0);
        const CellSize found = sizeOfCell(rule, species, plan.optics, fileRadiusM, cell);
        values[i] = static_cast<float>(
            extinctionPerM(plan.optics, species, cell.contentKgPerM3, found.size));
        ++gaps.cells;
        gaps.contentSum += cell.contentKgPerM3;
        if (!found.gap) continue;
        ++gaps.gaps;
        gaps.gapContentSum += cell.contentKgPerM3;
    }
    return gaps;
}

std::string describe(const RadiusGaps& gaps, const RadiusRule& rule, Species species) {
    if (gaps.gaps == 0) return {};
    const auto percent = [](double part, double whole) { return 100.0 * part / whole; };
    const bool file = rule.source == RadiusSource::file;
    return fmt::format(
        "{}: {} gives no {} in {:.2g} % of the cells, {:.2g} % of the mass; {} stand in.",
        info(species).label,
        file                          ? rule.radiusVariable
        : rule.numberVariable.empty() ? "the run"
                                      : rule.numberVariable,
        file ? "radius" : "number",
        percent(static_cast<double>(gaps.gaps), static_cast<double>(gaps.cells)),
        percent(gaps.gapContentSum, gaps.contentSum),
        file && !rule.numberVariable.empty() ? "number or scheme" : "the scheme's sizes");
}

}  // namespace neph
