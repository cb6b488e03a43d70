// info_place.cpp: asks the map of the grid at its middle, its corners and between them.
#include "app/cli/info/info_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/dataset/whereabouts.h"
#include "core/geo/map_place.h"

namespace neph {
namespace {

std::string dateLine(const DatasetInfo& info) {
    const auto& first = info.times.front().utc;
    const auto& last = info.times.back().utc;
    if (!first || !last) return "Date     not known\n";
    if (info.times.size() == 1) return fmt::format("Date     {}\n", utcText(*first));
    return fmt::format("Dates    {} to {}\n", utcText(*first), utcText(*last));
}

}  // namespace

std::optional<PlaceSummary> summarisePlace(const DatasetInfo& info) {
    if (info.map.projection.empty()) return {};
    MapGrid map = info.map;
    map.originM += info.times.front().gridOffsetM * map.mapPerGrid;
    const MapPlace place(map);
    const glm::dvec2 extentM = info.extentM();
    const auto middle = place.at(0.5 * extentM);
    if (!middle) return {};
    PlaceSummary summary{.middle = *middle};
    constexpr std::array<glm::dvec2, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < kCorners.size(); ++i) {
        summary.corners[i] = place.geoAt(kCorners[i] * extentM);
    }
    summary.leastMapFactor = std::min(middle->mapFactor.x, middle->mapFactor.y);
    summary.greatestMapFactor = std::max(middle->mapFactor.x, middle->mapFactor.y);
    constexpr int kAlong = 8;
    for (int i = 0; i < (kAlong + 1) * (kAlong + 1); ++i) {
        const glm::dvec2 share(i % (kAlong + 1), i / (kAlong + 1));
        const auto point = place.at(share / double{kAlong} * extentM);
        if (!point) continue;
        for (const double factor : {point->mapFactor.x, point->mapFactor.y}) {
            summary.leastMapFactor = std::min(summary.leastMapFactor, factor);
            summary.greatestMapFactor = std::max(summary.greatestMapFactor, factor);
        }
    }
    return summary;
}

std::optional<SolarPosition> sunAt(const DatasetInfo& info, int time) {
    const Whereabouts where = whereaboutsOf(info, time, 0.5 * info.extentM());
    if (!where.utc || !where.place) return {};
    return solarPosition(*where.utc, where.place->geo.latitudeDeg, where.place->geo.longitudeDeg);
}

std::optional<GeoPoint> cornerAt(const DatasetInfo& info, int time) {
    const Whereabouts where = whereaboutsOf(info, time, glm::dvec2(0.0));
    if (!where.place) return {};
    return where.place->geo;
}

std::string motionLines(const DatasetInfo& info) {
    if (!info.moves()) return {};
    std::string text = fmt::format("\n{:<21}{:>9}{:>9}{}\n", "Corner of the grid", "x km", "y km",
                                   info.map.projection.empty() ? "" : "   place");
    for (std::size_t i = 0; i < info.times.size(); ++i) {
        const TimeInfo& time = info.times[i];
        const auto corner = cornerAt(info, static_cast<int>(i));
        text += fmt::format("{:<21}{:>9.2f}{:>9.2f}{}\n", time.label, time.gridOffsetM.x * kKmPerM,
                            time.gridOffsetM.y * kKmPerM, corner ? "   " + geoText(*corner) : "");
    }
    return text;
}

std::string placeLines(const DatasetInfo& info) {
    const auto place = summarisePlace(info);
    if (!place) {
        const std::string reason = info.noPlace.empty() ? "" : ": " + info.noPlace;
        return fmt::format("Place    not known{}\n{}", reason, dateLine(info));
    }
    std::string corners;
    for (const auto& corner : place->corners) {
        corners += corners.empty() ? "" : ", ";
        corners += corner ? geoText(*corner) : "beyond the map";
    }
    const double turnDeg = place->middle.convergenceDeg;
    return fmt::format(
        "Place    {} in the middle; corners from the south-west, counterclockwise: {}\n"
        "Map      {}; map factor {:.4f} to {:.4f}; true north {:.2f} deg {} of the grid's\n{}",
        geoText(place->middle.geo), corners, info.map.projection, place->leastMapFactor,
        place->greatestMapFactor, std::abs(turnDeg), turnDeg < 0.0 ? "west" : "east",
        dateLine(info));
}

std::string sunLines(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    std::string text;
    for (const TimeSummary& summary : summaries) {
        const TimeInfo& time = timeOf(info, summary);
        const auto sun = sunAt(info, summary.time);
        if (!sun) continue;
        text += fmt::format("{:<22}{:>10.2f}{:>11.2f}{:>9.2f}\n", utcText(*time.utc),
                            sun->elevationDeg, sun->apparentElevationDeg, sun->azimuthDeg);
    }
    if (text.empty()) return {};
    return fmt::format("\n{:<22}{:>10}{:>11}{:>9}\n", "Sun in the middle at", "elevation",
                       "refracted", "azimuth") +
           text;
}

}  // namespace neph
