// place.h: where a data set lies on the earth, when its clock was zero, and how its grid moves.
#pragma once
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/cf_les/grid.h"
#include "readers/cf_les/times.h"

namespace cf {

/// Fills in projection, origin and date: by the grid mapping of CF that a hydrometeor names, by the
/// origin that PALM states, or, nominally, by the centre that CM1 states. What is there and cannot
/// be used is a note.
void addPlace(const FileSet& files, const Grid& grid, const Times& times,
              neph::plugin::Description& description);

/// The PROJ string of a variable with the attributes of a grid mapping of CF; empty, with a note,
/// for one that is not known.
std::string projectionOf(const nc::NcFile& file, const nc::NcVariable& mapping,
                         std::vector<std::string>& notes);

}  // namespace cf
