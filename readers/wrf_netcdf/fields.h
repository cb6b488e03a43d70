// fields.h: the fields that the host sees: stored ones, and those computed from stored ones.
#pragma once
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/schemes.h"
#include "readers/wrf_netcdf/term.h"

namespace wrf {

/// How the values of a field are made.
enum class Source {
    sum,  ///< of the terms; most fields have one
    interfaceHeight,
    airPressure,
    airTemperature,
    dryAirDensity,
    warmPart,    ///< the sum where the air is not below 0 °C, zero elsewhere
    coldPart,    ///< the sum where the air is below 0 °C
    meanOfFaces  ///< of the term, which is stored on the faces of cells along one axis
};

struct Field : neph::plugin::Variable {
    Source source = Source::sum;
    std::vector<Term> terms;
};

/// The hydrometeors of a file with their numbers and radii. Everything in the file that is or could
/// be a hydrometeor and gets no role is named in a note. Throws Failure for a hydrometeor whose
/// units do not convert.
std::vector<Field> findHydrometeors(const Tiles& tiles, const Scheme& scheme, UnitNotes& unitNotes,
                                    std::vector<std::string>& notes);

/// All other numbers on the horizontal grid, in the units of the file, without a role.
std::vector<Field> otherFields(const Tiles& tiles, const std::vector<Field>& taken);

}  // namespace wrf
