// term.h: a stored variable as a part of a field in SI.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/shared/units.h"
#include "readers/wrf_netcdf/tiles.h"

namespace wrf {

struct Term {
    const NcVariable* variable = nullptr;
    shared::Conversion toSi;
};

/// Collects what was assumed about units, one note for all variables.
struct UnitNotes {
    std::vector<std::string> without;    ///< variables without the attribute
    std::vector<std::string> converted;  ///< "QCLOUD from g kg-1 to kg kg-1"
    void addTo(std::vector<std::string>& notes) const;
};

/// `variable` in the unit `wanted`; nothing if its units are of another kind. Without the attribute
/// they are taken as wanted, with a note.
std::optional<Term> termOf(const NcVariable& variable, std::string_view wanted, UnitNotes& notes);

/// The error for a variable whose units are of another kind.
Failure wrongUnit(const NcVariable& variable, std::string_view wanted);

}  // namespace wrf
