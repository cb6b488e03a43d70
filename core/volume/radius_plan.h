// radius_plan.h: from a look and what a data set holds to how each species' particles are sized,
// what must be read for that, and the extinction of native cells.
//
// Species of constant radius are held as mass, so that the radius can be changed without reading
// again. The others become extinction on the native grid, before any averaging, since it does not
// follow from the mean mass.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/look/look.h"

namespace neph {

struct RadiusRule {
    RadiusSource source = RadiusSource::constant;  ///< constant: the mass is held
    Microphysics scheme = Microphysics::unknown;   ///< unknown also where it lacks what it reads
    double fixedNumberPerM3 = 0.0;  ///< where the run prescribes it and no variable holds it
    /// Variables to read; empty where not needed.
    std::string radiusVariable, numberVariable, temperatureVariable;
    bool operator==(const RadiusRule&) const = default;
};

struct RadiusPlan {
    std::array<RadiusRule, kSpeciesCount> rules;
    RadiationOptics optics = RadiationOptics::geometric;
    std::vector<std::string> notes;  ///< what was asked for and cannot be had, one sentence each

    const RadiusRule& of(Species s) const { return rules[static_cast<std::size_t>(s)]; }
    bool holdsMass(Species s) const { return of(s).source == RadiusSource::constant; }
    bool operator==(const RadiusPlan&) const = default;
};

/// What `look` asks for, as far as the data have it: file, number, scheme, then a distribution that
/// is assumed. Looks of one extinction per kilogram hold masses.
RadiusPlan planRadii(const Look& look, const DatasetInfo& info);

/// What the rule of a species names, of native cells; empty where it names nothing.
struct RadiusCells {
    std::span<const float> radiusM, numberPerM3, temperatureK;
};

/// Counts of cells with any mass, and of those where the source has no value and the next one
/// stands in.
struct RadiusGaps {
    std::size_t cells = 0, gaps = 0;
    double contentSum = 0.0, gapContentSum = 0.0;  ///< kg/m³, added up over cells
    RadiusGaps& operator+=(const RadiusGaps& other);
};

/// Turns content, kg/m³ and not negative, into extinction, 1/m, cell by cell; for species that are
/// not held as mass.
RadiusGaps contentToExtinction(const RadiusPlan& plan, Species species, const RadiusCells& cells,
                               std::span<float> values);

/// One sentence for the notes; empty where nothing stood in for anything.
std::string describe(const RadiusGaps& gaps, const RadiusRule& rule, Species species);

}  // namespace neph
