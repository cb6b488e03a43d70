// ensemble_file.cpp: names and units after the CF conventions [CF], version 1.8.
#include "core/volume/ensemble_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "core/base/classic_netcdf.h"
#include "core/base/number_text.h"

namespace neph {
namespace {

constexpr std::array kMaps{EnsembleMap::probability, EnsembleMap::mean, EnsembleMap::spread};
constexpr std::array<const char*, 3> kNames{"probability", "mean_optical_depth",
                                            "optical_depth_spread"};

std::vector<double> axisOf(const EnsembleDepths& depths, int axis) {
    std::vector<double> centres;
    glm::ivec3 cell(0);
    for (; cell[axis] < depths.grid.size[axis]; ++cell[axis]) {
        centres.push_back(depths.grid.centreM(cell)[axis]);
    }
    return centres;
}

/// The attributes of the values of a map.
std::vector<NetcdfAttribute> attributesOf(const EnsembleDepths& depths, EnsembleMap map,
                                          double threshold, const std::string& coordinates) {
    std::vector<NetcdfAttribute> attributes{{"long_name", titleOf(map, threshold)}, {"units", "1"}};
    if (map == EnsembleMap::probability) {
        attributes.push_back({"threshold", std::vector{threshold}});
        attributes.push_back({"comment",
                              "share of the members whose vertical optical depth of all "
                              "hydrometeors exceeds the threshold"});
    } else {
        const bool mean = map == EnsembleMap::mean;
        attributes.push_back({"standard_name", "atmosphere_optical_thickness_due_to_cloud"});
        attributes.push_back(
            {"cell_methods", mean ? "realization: mean" : "realization: standard_deviation"});
    }
    attributes.push_back({"number_of_members", std::vector{double(depths.members.size())}});
    if (!coordinates.empty()) attributes.push_back({"coordinates", coordinates});
    return attributes;
}

void addPlaces(const EnsembleDepths& depths, NetcdfContents& contents) {
    const std::vector<GeoPoint> places = depths.places();
    if (places.empty()) return;
    std::vector<double> latitudes, longitudes;
    for (const GeoPoint& place : places) {
        latitudes.push_back(place.latitudeDeg);
        longitudes.push_back(place.longitudeDeg);
    }
    contents.variables.push_back({"latitude",
                                  {0, 1},
                                  {{"standard_name", "latitude"}, {"units", "degrees_north"}},
                                  std::move(latitudes)});
    contents.variables.push_back({"longitude",
                                  {0, 1},
                                  {{"standard_name", "longitude"}, {"units", "degrees_east"}},
                                  std::move(longitudes)});
    contents.attributes.push_back({"projection", depths.map.projection});
}

void addTime(const EnsembleDepths& depths, NetcdfContents& contents) {
    if (!depths.utc) return;
    const double seconds = depths.utc->time_since_epoch().count();
    contents.variables.push_back({"time",
                                  {},
                                  {{"standard_name", "time"},
                                   {"units", "seconds since 1970-01-01 00:00:00"},
                                   {"calendar", "standard"}},
                                  std::vector{seconds}});
}

}  // namespace

std::string ensembleNetcdf(const EnsembleDepths& depths, double threshold,
                           const std::string& source) {
    NetcdfContents contents;
    contents.dimensions = {{"y", depths.grid.size.y}, {"x", depths.grid.size.x}};
    contents.attributes = {{"Conventions", "CF-1.8"},
                           {"title", titleOf(EnsembleMap::probability, threshold)},
                           {"source", source},
                           {"optical_depths", depths.scale},
                           {"model_time", depths.timeLabel},
                           {"members", fmt::format("{}", fmt::join(depths.members, ", "))}};
    if (!depths.without.empty()) {
        contents.attributes.push_back(
            {"members_without_this_time", fmt::format("{}", fmt::join(depths.without, ", "))});
    }
    constexpr std::array kAxes{"x", "y"};
    for (const int axis : {1, 0}) {
        const char* name = kAxes[static_cast<std::size_t>(axis)];
        contents.variables.push_back(
            {name,
             {axis == 0 ? 1 : 0},
             {{"long_name",
               fmt::format("distance from the south-west corner of the grid along {}", name)},
              {"units", "m"},
              {"axis", axis == 0 ? "X" : "Y"}},
             axisOf(depths, axis)});
    }
    addPlaces(depths, contents);
    addTime(depths, contents);
    std::vector<std::string> coordinates;
    for (const NetcdfVariable& variable : contents.variables) {
        if (variable.name.size() > 1) coordinates.push_back(variable.name);
    }
    const std::string with = fmt::format("{}", fmt::join(coordinates, " "));
    for (std::size_t i = 0; i < kMaps.size(); ++i) {
        contents.variables.push_back({kNames[i],
                                      {0, 1},
                                      attributesOf(depths, kMaps[i], threshold, with),
                                      mapOf(depths, kMaps[i], threshold)});
    }
    return formatNetcdf(contents);
}

std::string ensembleCsv(const EnsembleDepths& depths, double threshold, const std::string& source) {
    const std::vector<GeoPoint> places = depths.places();
    std::string text = fmt::format(
        "# {} at {}, {} members: {}\n# optical depth is vertical, of all hydrometeors, {}; {}\n"
        "x_m,y_m,{}probability,mean_optical_depth,optical_depth_spread\n",
        titleOf(EnsembleMap::probability, threshold), depths.timeLabel, depths.members.size(),
        fmt::join(depths.members, ", "), depths.scale, source,
        places.empty() ? "" : "latitude_deg,longitude_deg,");
    std::array<std::vector<float>, kMaps.size()> maps;
    for (std::size_t i = 0; i < kMaps.size(); ++i) maps[i] = mapOf(depths, kMaps[i], threshold);
    for (std::size_t column = 0; column < depths.columns(); ++column) {
        const glm::dvec2 atM = depths.centreM(column);
        text += fmt::format("{:.10g},{:.10g}", atM.x, atM.y);
        if (!places.empty()) {
            text += fmt::format(",{:.6f},{:.6f}", places[column].latitudeDeg,
                                places[column].longitudeDeg);
        }
        for (const std::vector<float>& map : maps) text += fmt::format(",{:.6g}", map[column]);
        text += "\n";
    }
    return text;
}

}  // namespace neph
