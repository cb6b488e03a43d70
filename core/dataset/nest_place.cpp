// nest_place.cpp: corners of one grid as positions in another.
#include "core/dataset/nest_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dataset/grid_text.h"
#include "core/geo/map_place.h"

namespace neph {
namespace {

// Of a cell: latitudes and longitudes in single precision miss by some metres.
constexpr double kWholeCells = 0.25;
constexpr int kMostRatio = 100;

/// A position of one grid in cells of another, from its south-west corner; both are moved.
std::optional<glm::dvec2> cellOf(const DatasetInfo& of, glm::dvec2 offsetM, const DatasetInfo& in,
                                 glm::dvec2 inOffsetM, glm::dvec2 atM) {
    if (of.map.projection.empty() || in.map.projection.empty()) return {};
    const auto geo = MapPlace(of.map).geoAt(atM + offsetM);
    if (!geo) return {};
    const auto there = MapPlace(in.map).positionM(*geo);
    if (!there) return {};
    return (*there - inOffsetM) / in.spacingM;
}

bool isEven(const DatasetInfo& info) {
    return info.edgesM[0].empty() && info.edgesM[1].empty();
}

FoundPlace onTheEarth(const DatasetInfo& parent, glm::dvec2 parentOffsetM, const DatasetInfo& nest,
                      glm::dvec2 nestOffsetM) {
    const glm::dvec2 size(glm::ivec2(nest.size));
    const std::array corners{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(1.0, 1.0),
                             glm::dvec2(0.0, 1.0)};
    std::array<glm::dvec2, 4> at;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto cell =
            cellOf(nest, nestOffsetM, parent, parentOffsetM, corners[i] * nest.extentM());
        if (!cell) return "it has no place on the other's map";
        at[i] = *cell;
    }
    const glm::dvec2 width = at[2] - at[0];
    const double ratio = std::round(size.x / width.x);
    if (!(ratio >= 2.0 && ratio <= kMostRatio)) {
        return std::string("its cells do not divide those of the other by a whole number");
    }
    NestPlace place{static_cast<int>(ratio), glm::ivec2(glm::round(at[0] * ratio))};
    double worst = 0.0;  // cells of the nest
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 expected = glm::dvec2(place.cornerCells) + corners[i] * size;
        worst = std::max(worst, glm::length(at[i] * ratio - expected));
    }
    if (worst > kWholeCells) {
        return fmt::format("its corners lie up to {:.2g} of its cells off the other's grid", worst);
    }
    return place;
}

}  // namespace

std::string domainName(const DatasetInfo& info) {
    return info.nest.number > 0 ? fmt::format("d{:02}", info.nest.number) : std::string();
}

std::optional<glm::ivec2> cellsBetween(const DatasetInfo& a, glm::dvec2 offsetAM,
                                       const DatasetInfo& b, glm::dvec2 offsetBM) {
    if (a.size != b.size || !isEven(a) || !isEven(b)) return {};
    const auto lower = cellOf(b, offsetBM, a, offsetAM, glm::dvec2(0.0));
    const auto upper = cellOf(b, offsetBM, a, offsetAM, b.extentM());
    if (!lower || !upper) return {};
    const glm::dvec2 whole = glm::round(*lower);
    const glm::dvec2 off = glm::max(glm::abs(*lower - whole),
                                    glm::abs(*upper - glm::dvec2(glm::ivec2(a.size)) - whole));
    if (!(off.x <= kWholeCells && off.y <= kWholeCells)) return {};
    return glm::ivec2(whole);
}

FoundPlace placeWithin(const DatasetInfo& parent, glm::dvec2 parentOffsetM, const DatasetInfo& nest,
                       glm::dvec2 nestOffsetM) {
    if (!isEven(parent) || !isEven(nest)) return std::string("cells differ in width");
    FoundPlace found;
    const NestNumbers& numbers = nest.nest;
    if (!parent.map.projection.empty() && !nest.map.projection.empty()) {
        found = onTheEarth(parent, parentOffsetM, nest, nestOffsetM);
    } else if (!parent.map.projection.empty() || !nest.map.projection.empty()) {
        return std::string("only one of them has a place on the earth");
    } else if (numbers.ratio < 2 || parent.nest.number == 0 ||
               numbers.parent != parent.nest.number) {
        return std::string("where one lies in the other is not stated");
    } else {
        // Corners are counted from the parent's, wherever that lies.
        const glm::ivec2 moved(glm::round(nestOffsetM / nest.spacingM));
        found = NestPlace{numbers.ratio, numbers.cornerCells * numbers.ratio + moved};
        const glm::dvec2 off = nest.spacingM * static_cast<double>(numbers.ratio) - parent.spacingM;
        if (glm::any(glm::greaterThan(glm::abs(off), 0.01 * parent.spacingM))) {
            return fmt::format("its cells of {} are not a {}th of the other's of {}",
                               cellWidthText(nest), numbers.ratio, cellWidthText(parent));
        }
    }
    const NestPlace* place = std::get_if<NestPlace>(&found);
    if (place == nullptr) return found;
    const glm::ivec2 lower = place->cornerCells;
    const glm::ivec2 upper = lower + glm::ivec2(nest.size);
    const glm::ivec2 limit = glm::ivec2(parent.size) * place->ratio;
    const int beyond = std::max({-lower.x, -lower.y, upper.x - limit.x, upper.y - limit.y, 0});
    if (beyond == 0) return found;
    return fmt::format("it reaches {} beyond the other's edge",
                       lengthText(beyond * nest.spacingM.x));
}

}  // namespace neph
