// place.cpp: reads places and finds them in the grid.
#include "core/analysis/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/geo/map_place.h"

namespace neph {
namespace {

constexpr double kMetresPerKm = 1000.0;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

std::optional<double> numberOf(std::string_view text) {
    text = trimmed(text);
    double number = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = fault == std::errc{} && end == text.data() + text.size();
    if (!whole || !std::isfinite(number)) return {};
    return number;
}

/// A number with one of two letters at its end, the second of which is negative.
std::optional<double> angleOf(std::string_view text, char positive, char negative) {
    text = trimmed(text);
    if (text.empty()) return {};
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text.back())));
    if (letter != positive && letter != negative) return {};
    const auto number = numberOf(text.substr(0, text.size() - 1));
    if (!number) return {};
    return letter == negative ? -*number : *number;
}

std::string domainText(const DatasetInfo& info) {
    return fmt::format("0 to {:g}, 0 to {:g} km", info.extentM().x / kMetresPerKm,
                       info.extentM().y / kMetresPerKm);
}

}  // namespace

std::optional<NamedPlace> parsePlace(const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return {};
    const std::string_view whole(text);
    const std::string_view first = whole.substr(0, comma), second = whole.substr(comma + 1);
    const auto latitude = angleOf(first, 'N', 'S');
    const auto longitude = angleOf(second, 'E', 'W');
    if (latitude && longitude) {
        if (std::abs(*latitude) > 90.0 || std::abs(*longitude) > 360.0) return {};
        return NamedPlace{GeoPoint{*latitude, *longitude}};
    }
    const auto x = numberOf(first), y = numberOf(second);
    if (!x || !y) return {};
    return NamedPlace{{}, kMetresPerKm * glm::dvec2(*x, *y)};
}

glm::dvec2 positionOf(const NamedPlace& place, const Dataset& dataset, int time,
                      const std::string& option) {
    const DatasetInfo& info = dataset.info();
    const TimeInfo& when = info.times.at(static_cast<std::size_t>(time));
    glm::dvec2 atM = place.positionM;
    if (place.geo) {
        if (info.map.projection.empty()) {
            throw Error({.where = option,
                         .what = "the data have no place on the earth",
                         .found = info.noPlace,
                         .expected = fmt::format("X,Y in km from the south-west corner: {}",
                                                 domainText(info)),
                         .hint = "give X,Y"});
        }
        const auto onMap = MapPlace(info.map).positionM(*place.geo);
        if (!onMap) {
            throw Error({.where = option,
                         .what = "the map of the data does not show that place",
                         .found = geoText(*place.geo)});
        }
        atM = *onMap - when.gridOffsetM;
    }
    const glm::dvec2 extent = info.extentM();
    if (glm::all(glm::greaterThanEqual(atM, glm::dvec2(0.0))) &&
        glm::all(glm::lessThanEqual(atM, extent))) {
        return atM;
    }
    throw Error({.where = option,
                 .what = "is outside the domain",
                 .found = fmt::format("x {:g}, y {:g} km at {}", atM.x / kMetresPerKm,
                                      atM.y / kMetresPerKm, when.label),
                 .expected = domainText(info),
                 .hint = "nephoscope info FILE... tells the domain"});
}

glm::ivec2 columnAt(const DatasetInfo& info, glm::dvec2 positionM) {
    glm::ivec2 column(0);
    for (int axis = 0; axis < 2; ++axis) {
        int lower = 0, upper = info.size[axis];
        while (upper - lower > 1) {
            const int middle = (lower + upper) / 2;
            (info.edgeM(axis, middle) <= positionM[axis] ? lower : upper) = middle;
        }
        column[axis] = lower;
    }
    return column;
}

glm::dvec2 centreM(const DatasetInfo& info, glm::ivec2 column) {
    return {0.5 * (info.edgeM(0, column.x) + info.edgeM(0, column.x + 1)),
            0.5 * (info.edgeM(1, column.y) + info.edgeM(1, column.y + 1))};
}

std::optional<GeoPoint> geoOf(const DatasetInfo& info, int time, glm::dvec2 positionM) {
    if (info.map.projection.empty()) return {};
    const auto index = static_cast<std::size_t>(time);
    return MapPlace(info.map).geoAt(positionM + info.times.at(index).gridOffsetM);
}

}  // namespace neph
