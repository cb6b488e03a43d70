// radius_plan.h: from a look and a data set to how the particles of each species are sized, what
// must be read for that, and the extinction of native cells.
//
// Species of constant radius are held as mass, so that the radius can be changed without reading
// again. The others become extinction on the native grid, before any averaging, because extinction
// does not follow from the mean mass.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/look/look.h"

namespace neph {

/// How the particles of one species are sized.
struct RadiusRule {
    RadiusSource source = RadiusSource::constant;  ///< constant: held as mass
    Microphysics scheme = Microphysics::unknown;   ///< unknown also if the data lack what it needs
    double fixedNumberPerM3 = 0.0;  ///< if the run prescribes it and no variable contains it
    /// Variables to read; empty if not needed.
    std::string radiusVariable, numberVariable, temperatureVariable;
    bool operator==(const RadiusRule&) const = default;
};

/// The rules of all species.
struct RadiusPlan {
    std::array<RadiusRule, kSpeciesCount> rules;
    RadiationOptics optics = RadiationOptics::geometric;
    std::vector<std::string> notes;  ///< what was requested but is not available, one sentence each

    const RadiusRule& of(Species s) const { return rules[static_cast<std::size_t>(s)]; }
    bool holdsMass(Species s) const { return of(s).source == RadiusSource::constant; }
    bool operator==(const RadiusPlan&) const = default;
};

/// The plan for `look`, as far as the data allow: file, number, scheme, then an assumed
/// distribution. With one mass extinction for all fields everything is held as mass.
RadiusPlan planRadii(const Look& look, const DatasetInfo& info);

/// The same where one time lacks variables that others have: `there` is Dataset::infoAt(), and
/// notes of what stands in begin with `timeLabel`.
RadiusPlan planAt(const RadiusPlan& plan, const DatasetInfo& there, std::string_view timeLabel);

/// Whether the data say how large the particles of a species are: by radius, number or scheme.
bool statesSize(const DatasetInfo& info, Species species);

/// The variables that the rule of a species names, on native cells; empty if it names none.
struct RadiusCells {
    std::span<const float> radiusM, numberPerM3, temperatureK;
};

/// Counts of cells with any mass, and of those where the source has no value and the next one was
/// used.
struct RadiusGaps {
    std::size_t cells = 0, gaps = 0;
    double contentSum = 0.0, gapContentSum = 0.0;  ///< kg/m³, summed over cells
    RadiusGaps& operator+=(const RadiusGaps& other);
};

/// Converts content, kg/m³ and not negative, to extinction, 1/m, cell by cell; for species that are
/// not held as mass.
RadiusGaps contentToExtinction(const RadiusPlan& plan, Species species, const RadiusCells& cells,
                               std::span<float> values);

/// One sentence for the notes; empty if there were no gaps.
std::string describe(const RadiusGaps& gaps, const RadiusRule& rule, Species species);

}  // namespace neph
