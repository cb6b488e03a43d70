// place.h: places that people name, as positions of the grid.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/dataset/dataset.h"
#include "core/geo/map_grid.h"

namespace neph {

/// A place by latitude and longitude, or by x and y from the south-west corner of the domain.
struct NamedPlace {
    std::optional<GeoPoint> geo;
    glm::dvec2 positionM{0.0};  ///< without `geo`
};

/// "35.2N,97.4W" or "35.2 N, 97.4 W" as latitude and longitude, "12.5,40" as x and y in km. Nothing
/// for any other text.
std::optional<NamedPlace> parsePlace(const std::string& text);

/// Position in the grid at a time. Throws Error where the data have no place on the earth and one
/// was asked for, or the place is outside the domain; `option` names it in the message.
glm::dvec2 positionOf(const NamedPlace& place, const Dataset& dataset, int time,
                      const std::string& option);

/// The native column that a position lies in; the last one on the domain's far edges.
glm::ivec2 columnAt(const DatasetInfo& info, glm::dvec2 positionM);

/// Its centre.
glm::dvec2 centreM(const DatasetInfo& info, glm::ivec2 column);

/// Latitude and longitude of a position at a time; nothing where they are not known.
std::optional<GeoPoint> geoOf(const DatasetInfo& info, int time, glm::dvec2 positionM);

}  // namespace neph
