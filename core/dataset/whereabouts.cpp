// whereabouts.cpp: the map of a data set, asked at one position.
#include "core/dataset/whereabouts.h"

#include "core/geo/map_place.h"

namespace neph {

Whereabouts whereaboutsOf(const DatasetInfo& info, int time, const RegularGrid& grid) {
    return whereaboutsOf(info, time, glm::dvec2(grid.originM + 0.5 * grid.extentM()));
}

Whereabouts whereaboutsOf(const DatasetInfo& info, int time, glm::dvec2 atM) {
    Whereabouts found;
    const auto index = static_cast<std::size_t>(time);
    if (index < info.times.size()) {
        found.utc = info.times[index].utc;
        atM += info.times[index].gridOffsetM;
    }
    if (!info.map.projection.empty()) found.place = MapPlace(info.map).at(atM);
    return found;
}

}  // namespace neph
