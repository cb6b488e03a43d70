// old_metres.h: noise scales in metres, as files had them before lengths of detail were given in
// cells of the data.
//
// A file does not say how large the cells are. Its metres are read as cells of kLookCellM, and
// brought to the data's own cells where those are known, so that the image stays as it was.
#pragma once
#include <string>
#include <string_view>

#include "core/look/parameter.h"

namespace neph {

/// Fields, one bit each in the order of Species.
using FieldSet = unsigned;

/// The parameter that stands in place of `id` ("cloud.noise_scale"); nullptr where there is none.
const Parameter* replacedInCells(std::string_view id);

/// Metres as cells of kLookCellM.
float asLookCells(float metres);

/// The field whose noise scale a row is; none for other rows.
FieldSet noiseScaleField(const Parameter& row);

/// Brings the noise scales of `fields`, read as cells of kLookCellM, to cells of `cellM`. Returns
/// what to tell the user; nothing where the two are the same.
std::string bringToCells(Look& look, FieldSet fields, double cellM);

/// "cloud, rain"
std::string namesOf(FieldSet fields);

}  // namespace neph
