// info_json.cpp: the summary for programs.
#include "app/cli/info/info_json.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/cli/info/info_findings.h"
#include "app/cli/info/info_members.h"
#include "app/cli/info/info_place.h"
#include "app/cli/info/info_shown.h"
#include "core/dataset/nest_place.h"
#include "core/look/haze.h"
#include "core/sky/humidity.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, kVariableRoles> kRoleIds{"other",
                                                                "mixing_ratio",
                                                                "dry_air_density",
                                                                "interface_height",
                                                                "air_pressure",
                                                                "air_temperature",
                                                                "effective_radius",
                                                                "number_concentration",
                                                                "water_vapour",
                                                                "x_wind",
                                                                "y_wind",
                                                                "upward_wind",
                                                                "hygroscopic_aerosol_number",
                                                                "dust_number"};

Json gridJson(const DatasetInfo& info, const LayerSummary& layers) {
    const glm::dvec2 extentM = info.extentM();
    Json json{{"size", {info.size.x, info.size.y, info.size.z}},
              {"spacing_m", {info.spacingM.x, info.spacingM.y}},
              {"domain_km", {extentM.x * kKmPerM, extentM.y * kKmPerM}},
              {"height_m", {layers.lowestM, layers.highestM}},
              {"layer_depth_m",
               {{"thinnest", layers.thinnestM},
                {"median", layers.medianM},
                {"thickest", layers.thickestM}}}};
    constexpr std::array kEdges{"x_edges_m", "y_edges_m"};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!info.edgesM[axis].empty()) json[kEdges[axis]] = info.edgesM[axis];
    }
    return json;
}

Json columnJson(const ColumnPeak& column) {
    Json json{{"maximum_kg_per_m2", column.massKgPerM2}};
    if (column.massKgPerM2 > 0.0) {
        json["x_km"] = column.positionM.x * kKmPerM;
        json["y_km"] = column.positionM.y * kKmPerM;
    }
    return json;
}

Json peakJson(const SpeciesPeak& peak) {
    Json json{{"species", neph::info(peak.species).id},
              {"variable", peak.variable},
              {"maximum_g_per_kg", static_cast<double>(peak.ratioKgPerKg) * kGramPerKg}};
    if (peak.ratioKgPerKg > 0.0f) {
        json["x_km"] = peak.positionM.x * kKmPerM;
        json["y_km"] = peak.positionM.y * kKmPerM;
        json["height_km"] = peak.positionM.z * kKmPerM;
    }
    return json;
}

/// Null where there is none.
Json rangeJson(const std::optional<HeightRange>& range) {
    if (!range) return nullptr;
    return {{"base_km", range->baseM * kKmPerM}, {"top_km", range->topM * kKmPerM}};
}

/// The range of a time, with the bases of columns.
Json cloudJson(const TimeSummary& summary) {
    Json json = rangeJson(summary.cloud);
    if (!summary.bases) return json;
    const CloudBases& bases = *summary.bases;
    json["base_p5_km"] = bases.lowM * kKmPerM;
    json["base_p50_km"] = bases.middleM * kKmPerM;
    json["updraft_base_km"] = bases.updraftM * kKmPerM;
    json["updraft_by"] = bases.updraftVariable.empty() ? "condensate" : bases.updraftVariable;
    return json;
}

/// The range of all times; of bases of columns the lowest and the highest.
Json cloudJson(const std::vector<TimeSummary>& summaries) {
    Json json = rangeJson(rangeOf(summaries, &TimeSummary::cloud));
    const auto add = [&](const char* key, double CloudBases::*base) {
        if (const auto range = rangeOf(summaries, base)) {
            json[key] = {range->leastM * kKmPerM, range->mostM * kKmPerM};
        }
    };
    add("base_p5_km_range", &CloudBases::lowM);
    add("base_p50_km_range", &CloudBases::middleM);
    add("updraft_base_km_range", &CloudBases::updraftM);
    return json;
}

/// What one time holds.
Json summaryJson(const TimeSummary& summary) {
    Json maxima = Json::array();
    for (const SpeciesPeak& peak : summary.peaks) {
        if (peak.variable.empty()) continue;  // this time lacks it
        maxima.push_back(peakJson(peak));
        if (summary.hasColumns) maxima.back()["column"] = columnJson(peak.column);
    }
    Json json{{"maxima", std::move(maxima)},
              {"cloud", cloudJson(summary)},
              {"precipitation", rangeJson(summary.precipitation)}};
    if (summary.hasColumns) json["condensate"] = columnJson(summary.condensate);
    if (const auto& humidity = summary.lowestAir.humidity) {
        json["lowest_layer"] = {
            {"relative_humidity", *humidity},
            {"visibility_by_humidity_km", visibilityOfHumidityM(*humidity) * kKmPerM}};
    }
    if (const auto& perM = summary.lowestAir.aerosolPerM) {
        json["lowest_layer"]["aerosol_extinction_per_m"] = *perM;
        json["lowest_layer"]["visibility_by_aerosol_km"] = visibilityOfAerosolM(*perM) * kKmPerM;
    }
    return json;
}

Json geoJson(const std::optional<GeoPoint>& geo) {
    if (!geo) return nullptr;
    return {{"latitude_deg", geo->latitudeDeg}, {"longitude_deg", geo->longitudeDeg}};
}

/// Null where it is not known.
Json placeJson(const DatasetInfo& info, const std::optional<PlaceSummary>& place) {
    if (!place) return nullptr;
    constexpr std::array kCorners{"south_west", "south_east", "north_east", "north_west"};
    Json corners;
    for (std::size_t i = 0; i < kCorners.size(); ++i) {
        corners[kCorners[i]] = geoJson(place->corners[i]);
    }
    const MapGrid& map = info.map;
    return {
        {"projection", map.projection},
        {"map_origin_m", {map.originM.x, map.originM.y}},
        {"map_per_grid", {map.mapPerGrid.x, map.mapPerGrid.y}},
        {"middle", geoJson(place->middle.geo)},
        {"corners", corners},
        {"convergence_deg", place->middle.convergenceDeg},
        {"map_factor", {{"least", place->leastMapFactor}, {"greatest", place->greatestMapFactor}}}};
}

/// Null where place or date is not known.
Json sunJson(const DatasetInfo& info, int time) {
    const auto sun = sunAt(info, time);
    if (!sun) return nullptr;
    return {{"elevation_deg", sun->elevationDeg},
            {"apparent_elevation_deg", sun->apparentElevationDeg},
            {"azimuth_deg", sun->azimuthDeg}};
}

Json timesJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    Json times = Json::array();
    for (const TimeInfo& time : info.times) {
        const auto index = static_cast<int>(times.size());
        times.push_back({{"label", time.label},
                         {"seconds", time.seconds},
                         {"utc", time.utc ? Json(utcText(*time.utc)) : Json(nullptr)},
                         {"sun", sunJson(info, index)},
                         {"file", time.file.string()},
                         {"index_in_file", time.indexInFile}});
        if (!info.moves()) continue;
        times.back()["grid_offset_m"] = {time.gridOffsetM.x, time.gridOffsetM.y};
        times.back()["south_west"] = geoJson(cornerAt(info, index));
    }
    for (const TimeSummary& summary : summaries) {
        times[static_cast<std::size_t>(summary.time)].update(summaryJson(summary));
    }
    return times;
}

/// The outermost domain first; `south_west_km` of a nest in its coordinates at each of its times.
Json domainsJson(const Dataset& dataset) {
    const auto gridOf = [](const std::string& name, const DatasetInfo& info) {
        return Json{{"name", name},
                    {"size", {info.size.x, info.size.y, info.size.z}},
                    {"spacing_m", {info.spacingM.x, info.spacingM.y}}};
    };
    const DatasetInfo& outer = dataset.info();
    Json domains = Json::array({gridOf(domainName(outer), outer)});
    for (const Nest& nest : dataset.nests()) {
        Json corners = Json::array();
        for (const auto& at : nest.at) {
            const glm::dvec2 cornerM = at ? nest.cornerM(outer, *at) : glm::dvec2(0.0);
            corners.push_back(at ? Json{cornerM.x * kKmPerM, cornerM.y * kKmPerM} : Json(nullptr));
        }
        domains.push_back(gridOf(nest.name, nest.dataset->info()));
        domains.back()["ratio"] = nest.ratio;
        domains.back()["south_west_km"] = std::move(corners);
    }
    return domains;
}

Json variablesJson(const DatasetInfo& info) {
    Json variables = Json::array();
    for (const VariableInfo& variable : info.variables) {
        Json json{{"name", variable.name},
                  {"standard_name", variable.standardName},
                  {"units", variable.units},
                  {"description", variable.description},
                  {"role", roleId(variable.role)},
                  {"size", {variable.size.x, variable.size.y, variable.size.z}}};
        if (!variable.reason.empty()) json["reason"] = variable.reason;
        if (variable.species) json["species"] = neph::info(*variable.species).id;
        variables.push_back(std::move(json));
    }
    return variables;
}

/// Extremes over all times that were read, each with its time.
Json speciesJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    Json species = Json::array();
    for (const auto& [peak, when] : densest(summaries)) {
        Json json = peakJson(*peak);
        if (peak->ratioKgPerKg > 0.0f) json["time"] = timeOf(info, *when).label;
        if (when->hasColumns) {
            const At<ColumnPeak> column = heaviest(summaries, species.size());
            json["column"] = columnJson(*column.found);
            if (column.found->massKgPerM2 > 0.0) {
                json["column"]["time"] = timeOf(info, *column.when).label;
            }
        }
        species.push_back(std::move(json));
    }
    return species;
}

Json condensateJson(const DatasetInfo& info, const std::vector<TimeSummary>& summaries) {
    const At<ColumnPeak> column = heaviest(summaries);
    Json json = columnJson(*column.found);
    if (column.found->massKgPerM2 > 0.0) json["time"] = timeOf(info, *column.when).label;
    return json;
}

}  // namespace

std::string_view roleId(VariableRole role) {
    return kRoleIds.at(static_cast<std::size_t>(role));
}

std::string infoJson(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget) {
    const DatasetInfo& info = dataset.info();
    const TimeSummaries found = summariseTimes(dataset, times);
    const std::vector<TimeSummary>& summaries = found.read;
    const std::optional<PlaceSummary> place = summarisePlace(info);
    Json json{{"type", "nephoscope-info"},
              {"version", 1},
              {"reader", info.reader},
              {"model", info.model},
              {"scheme", info.scheme},
              {"grid", gridJson(info, summaries.back().layers)},
              {"place", placeJson(info, place)},
              {"shown", shownHere(dataset, summaries.back().time, budget)},
              {"cloud_threshold_g_per_kg", kCloudRatioGPerKg},
              {"cloud", cloudJson(summaries)},
              {"precipitation", rangeJson(rangeOf(summaries, &TimeSummary::precipitation))},
              {"species", speciesJson(info, summaries)},
              {"times", timesJson(info, summaries)},
              {"variables", variablesJson(info)},
              {"attributes", info.attributes},
              {"notes", allNotes(info, found)}};
    if (summaries.front().hasColumns) json["condensate"] = condensateJson(info, summaries);
    if (!dataset.nests().empty()) json["domains"] = domainsJson(dataset);
    if (auto members = membersJson(dataset); !members.is_null()) json["members"] = members;
    if (!info.noPlace.empty()) json["no_place"] = info.noPlace;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace neph
