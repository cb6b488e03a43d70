// nest_place.h: where one domain of a nested run lies within another, and how far a nest has moved.
//
// A nest's cells divide those of its parent by a whole number, and its corner is a corner of its
// own cells counted from the parent's: both are whole numbers, to which the places on the earth are
// rounded. Places are compared by latitude and longitude, since domains of one run may have maps
// with other central longitudes.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>

#include "core/plugin/dataset_info.h"

namespace neph {

/// A nest within another domain.
struct NestPlace {
    int ratio = 1;              ///< cells of the nest along one of the other domain
    glm::ivec2 cornerCells{0};  ///< of the nest, between both south-west corners
    bool operator==(const NestPlace&) const = default;
};

/// The place, or one phrase that says why there is none.
using FoundPlace = std::variant<NestPlace, std::string>;

/// "d02", as WRF numbers them; empty if the data state no number.
std::string domainName(const DatasetInfo& info);

/// Cells by which `b` lies east and north of `a`, two grids of one size and spacing on one map;
/// nothing if these are not whole numbers, or a place is unknown. The offsets are those of their
/// times, in metres of each grid.
std::optional<glm::ivec2> cellsBetween(const DatasetInfo& a, glm::dvec2 offsetAM,
                                       const DatasetInfo& b, glm::dvec2 offsetBM);

/// Where `nest`, moved by `nestOffsetM`, lies within `parent`: by their places on the earth, else
/// by the numbers of the run if `parent` is the nest's own parent. The nest has finer cells and
/// reaches nowhere beyond the parent.
FoundPlace placeWithin(const DatasetInfo& parent, glm::dvec2 parentOffsetM, const DatasetInfo& nest,
                       glm::dvec2 nestOffsetM);

}  // namespace neph
