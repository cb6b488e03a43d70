// map_place.h: where on the earth a grid lies: latitude and longitude, true north, map factor.
//
// A grid is even on the map of its projection, and by and large on the earth: positions are metres
// of the grid from its south-west corner, as in world space. PROJ has the projections.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "core/geo/map_grid.h"

namespace neph {

/// A grid's place. Belongs to one thread at a time; cheap to make (some 20 microseconds).
class MapPlace {
  public:
    /// Throws Error if PROJ does not know the projection, it needs files, or its parameters are
    /// impossible.
    explicit MapPlace(const MapGrid& grid);
    ~MapPlace();
    MapPlace(MapPlace&&) noexcept;
    MapPlace& operator=(MapPlace&&) noexcept;

    /// Nothing where the map has no place on the earth, as beyond its edge.
    std::optional<GeoPoint> geoAt(glm::dvec2 atM) const;
    /// The same with true north and map factor. At a pole, which has no north, those of a place a
    /// few hundred metres off.
    std::optional<PlacePoint> at(glm::dvec2 atM) const;
    /// The inverse of geoAt; nothing for what the map does not show.
    std::optional<glm::dvec2> positionM(GeoPoint geo) const;

  private:
    struct Projection;
    MapGrid grid_;
    std::unique_ptr<Projection> projection_;
};

}  // namespace neph
