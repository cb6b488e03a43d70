// probe_text.cpp: lines and JSON of a column.
#include "app/cli/ask/probe_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/info/info_findings.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;

const TimeInfo& timeOf(const Dataset& dataset, const ColumnReport& report) {
    return dataset.info().times.at(static_cast<std::size_t>(report.time));
}

std::string pointText(const std::optional<ParcelPoint>& point) {
    if (!point) return fmt::format("{:>18}", "none");
    return fmt::format("{:>7.0f} m {:>5.0f} hPa", point->heightM, 0.01 * point->pressurePa);
}

std::string convectionText(const ConvectionIndices& indices) {
    std::string text = fmt::format("\n{:<16}{:>10}{:>10}{:>18}{:>18}{:>18}\n", "parcel",
                                   "CAPE J/kg", "CIN J/kg", "LCL", "LFC", "EL");
    struct Row {
        const char* name;
        const Ascent* ascent;
    };
    for (const Row& row :
         {Row{"surface", &indices.surface}, Row{"mixed layer", &indices.mixedLayer},
          Row{"most unstable", &indices.mostUnstable}}) {
        const Ascent& ascent = *row.ascent;
        text += fmt::format("{:<16}{:>10.0f}{:>10.1f}{}{}{}\n", row.name, ascent.capeJPerKg,
                            ascent.cinJPerKg, pointText(ascent.condensation),
                            pointText(ascent.freeConvection), pointText(ascent.equilibrium));
    }
    return text + "LCL, LFC and EL are above the ground.\n";
}

std::string windText(const WindIndices& wind) {
    const auto line = [](const char* name, const std::optional<glm::dvec2>& w) {
        return w ? fmt::format("{:<22}{:.1f}, {:.1f} m/s ({:.1f} m/s)\n", name, w->x, w->y,
                               glm::length(*w))
                 : std::string();
    };
    std::string text = '\n' + line("shear, 0 to 1 km", wind.shear1MPerS) +
                       line("shear, 0 to 6 km", wind.shear6MPerS);
    if (!wind.motion) return text;
    text += line("right-moving storm", wind.motion->rightMPerS) +
            line("left-moving storm", wind.motion->leftMPerS) +
            line("mean wind, 0 to 6 km", wind.motion->meanMPerS);
    return text + fmt::format(
                      "SRH, 0 to 1 km        {:.0f} m²/s², of the right-moving storm\n"
                      "SRH, 0 to 3 km        {:.0f} m²/s²\n",
                      *wind.helicity1, *wind.helicity3);
}

/// The greatest and least of each quantity, and where.
std::string extremesText(const ColumnReport& report) {
    std::string text = fmt::format("\n{:<34}{:>12}{:>11}{:>12}{:>11}\n", "quantity", "greatest",
                                   "at km", "least", "at km");
    for (const Profile& profile : report.profiles) {
        std::vector<std::pair<double, double>> values;
        for (std::size_t i = 0; i < profile.values.size(); ++i) {
            if (!std::isfinite(profile.values[i])) continue;
            values.emplace_back(profile.values[i], report.heightsM[i] * kKmPerM);
        }
        const std::string name =
            fmt::format("{}, {}", info(profile.quantity).label, info(profile.quantity).unit);
        if (values.empty()) {
            text += fmt::format("{:<34}{:>12}\n", name, "missing");
            continue;
        }
        const auto [least, greatest] =
            std::ranges::minmax_element(values, {}, &std::pair<double, double>::first);
        text += fmt::format("{:<34}{:>12.4g}{:>11.2f}{:>12.4g}{:>11.2f}\n", name, greatest->first,
                            greatest->second, least->first, least->second);
    }
    return text;
}

Json pointJson(const std::optional<ParcelPoint>& point) {
    if (!point) return nullptr;
    return {{"pressure_pa", point->pressurePa},
            {"above_ground_m", point->heightM},
            {"parcel_temperature_k", point->temperatureK}};
}

Json ascentJson(const Ascent& ascent) {
    return {{"cape_j_per_kg", ascent.capeJPerKg},
            {"cin_j_per_kg", ascent.cinJPerKg},
            {"lcl", pointJson(ascent.condensation)},
            {"lfc", pointJson(ascent.freeConvection)},
            {"el", pointJson(ascent.equilibrium)}};
}

Json numberJson(const std::optional<double>& number) {
    return number ? Json(*number) : Json(nullptr);
}

Json vectorJson(const std::optional<glm::dvec2>& vector) {
    return vector ? Json{vector->x, vector->y} : Json(nullptr);
}

Json motionJson(const WindIndices& wind, glm::dvec2 StormMotion::*of) {
    return vectorJson(wind.motion ? std::optional((*wind.motion).*of) : std::nullopt);
}

}  // namespace

std::string probeText(const Dataset& dataset, const ColumnReport& report) {
    std::string text = fmt::format(
        "time      {}\nplace     x {:.2f}, y {:.2f} km (column {}, {}){}\nground    {:.0f} m above "
        "sea level\n",
        timeOf(dataset, report).label, report.positionM.x * kKmPerM, report.positionM.y * kKmPerM,
        report.column.x, report.column.y, report.geo ? ", " + geoText(*report.geo) : "",
        report.groundM);
    for (const double height : report.freezingM) {
        text += fmt::format("0 °C      at {:.0f} m\n", height);
    }
    if (report.tropopauseM) text += fmt::format("tropopause at {:.0f} m\n", *report.tropopauseM);
    text += extremesText(report);
    if (report.convection) text += convectionText(*report.convection);
    if (report.wind) text += windText(*report.wind);
    if (!report.lacks.empty()) text += '\n';
    for (const std::string& lack : report.lacks) text += "not known: " + lack + '\n';
    return text;
}

std::string probeJson(const Dataset& dataset, const ColumnReport& report) {
    Json json{{"time", timeOf(dataset, report).label},
              {"column", {report.column.x, report.column.y}},
              {"x_m", report.positionM.x},
              {"y_m", report.positionM.y}};
    if (report.geo) {
        json["latitude_deg"] = report.geo->latitudeDeg;
        json["longitude_deg"] = report.geo->longitudeDeg;
    }
    json["ground_m"] = report.groundM;
    json["freezing_m"] = report.freezingM;
    json["tropopause_m"] = report.tropopauseM ? Json(*report.tropopauseM) : Json(nullptr);
    json["height_m"] = report.heightsM;
    for (const Profile& profile : report.profiles) {
        json["profiles"][std::string(info(profile.quantity).id)] = {
            {"unit", info(profile.quantity).unit}, {"values", profile.values}};
    }
    if (report.convection) {
        json["parcels"] = {{"surface", ascentJson(report.convection->surface)},
                           {"mixed_layer", ascentJson(report.convection->mixedLayer)},
                           {"most_unstable", ascentJson(report.convection->mostUnstable)}};
    }
    if (report.wind) {
        const WindIndices& wind = *report.wind;
        json["wind"] = {{"shear_0_1_km_m_per_s", vectorJson(wind.shear1MPerS)},
                        {"shear_0_6_km_m_per_s", vectorJson(wind.shear6MPerS)},
                        {"right_mover_m_per_s", motionJson(wind, &StormMotion::rightMPerS)},
                        {"left_mover_m_per_s", motionJson(wind, &StormMotion::leftMPerS)},
                        {"mean_0_6_km_m_per_s", motionJson(wind, &StormMotion::meanMPerS)},
                        {"srh_0_1_km_m2_per_s2", numberJson(wind.helicity1)},
                        {"srh_0_3_km_m2_per_s2", numberJson(wind.helicity3)}};
    }
    json["not_known"] = report.lacks;
    return json.dump(2) + '\n';
}

}  // namespace neph
