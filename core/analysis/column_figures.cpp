// column_figures.cpp: skew-T log-p, hodograph and profiles of a column.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/air/thermodynamics.h"
#include "core/analysis/figures.h"

namespace neph {
namespace {

constexpr double kKm = 1e-3;
constexpr const char* kNotKnown = "not known";
constexpr double kLowestPa = 1.05e5, kHighestPa = 1e4;
constexpr double kColdestC = -40.0, kWarmestC = 45.0;
constexpr double kSkewC = 85.0;  // by how much isotherms lean over the height of the plot

/// Isotherms lean to the right; heights are the logarithm of pressure.
glm::dvec2 skewed(double pressurePa, double temperatureK) {
    const double up = std::log(kLowestPa / pressurePa) / std::log(kLowestPa / kHighestPa);
    return {temperatureK - kFreezingK + kSkewC * up, up};
}

plot::Curve curveOf(plot::Ink ink, double width) {
    plot::Curve curve;
    curve.ink = ink;
    curve.width = width;
    return curve;
}

plot::Curve backgroundCurve(plot::Ink ink) {
    plot::Curve curve = curveOf(ink, 0.7);
    curve.opacity = 0.3;
    return curve;
}

/// Pressures from the lower to the upper side of the plot.
std::vector<double> plotPressures() {
    std::vector<double> pressures;
    for (double p = kLowestPa; p >= kHighestPa; p -= 2500.0) pressures.push_back(p);
    pressures.push_back(kHighestPa);
    return pressures;
}

/// Isotherms, dry adiabats, pseudoadiabats and lines of equal mixing ratio.
void addBackground(plot::Figure& figure) {
    for (double celsius = -120.0; celsius <= 40.0; celsius += 10.0) {
        plot::Curve curve =
            backgroundCurve(celsius == 0.0 ? plot::Ink::cyan : plot::Ink::foreground);
        for (const double p : {kLowestPa, kHighestPa}) {
            curve.points.push_back(skewed(p, celsius + kFreezingK));
        }
        figure.curves.push_back(std::move(curve));
    }
    for (double theta = 240.0; theta <= 460.0; theta += 20.0) {
        plot::Curve curve = backgroundCurve(plot::Ink::orange);
        for (const double p : plotPressures()) {
            curve.points.push_back(skewed(p, theta / potentialTemperatureK(p, 1.0)));
        }
        figure.curves.push_back(std::move(curve));
    }
    for (double celsius = -10.0; celsius <= 36.0; celsius += 6.0) {
        plot::Curve curve = backgroundCurve(plot::Ink::green);
        for (const double p : plotPressures()) {
            if (p < 2e4) break;
            curve.points.push_back(skewed(p, pseudoadiabatK(1e5, celsius + kFreezingK, p)));
        }
        figure.curves.push_back(std::move(curve));
    }
    for (const double gramsPerKg : {0.4, 1.0, 2.0, 4.0, 8.0, 16.0, 24.0}) {
        plot::Curve curve = backgroundCurve(plot::Ink::blue);
        curve.dashed = true;
        for (const double p : {kLowestPa, 5e4}) {
            curve.points.push_back(skewed(p, dewPointK(p, 1e-3 * gramsPerKg)));
        }
        figure.curves.push_back(std::move(curve));
    }
}

void addSounding(plot::Figure& figure, const Sounding& sounding, const Ascent& ascent) {
    plot::Curve dew = curveOf(plot::Ink::green, 2.2), air = curveOf(plot::Ink::red, 2.2);
    dew.label = "Dew point";
    air.label = "Temperature";
    for (const SoundingLevel& level : sounding.levels) {
        if (level.pressurePa < kHighestPa) break;
        air.points.push_back(skewed(level.pressurePa, level.temperatureK));
        const double dewPoint = dewPointK(level.pressurePa, level.vapourRatio);
        if (dewPoint > 150.0) dew.points.push_back(skewed(level.pressurePa, dewPoint));
    }
    plot::Curve parcel = curveOf(plot::Ink::foreground, 1.6);
    parcel.label = "Parcel";
    parcel.dashed = true;
    for (const ParcelPoint& point : ascent.way) {
        if (point.pressurePa < kHighestPa) break;
        parcel.points.push_back(skewed(point.pressurePa, point.temperatureK));
    }
    figure.curves.push_back(std::move(dew));
    figure.curves.push_back(std::move(air));
    figure.curves.push_back(std::move(parcel));
}

void addBarbs(plot::Figure& figure, const Sounding& sounding) {
    constexpr double kApart = 0.035;  // of the plot's height
    double last = -1.0;
    for (const SoundingLevel& level : sounding.levels) {
        const double up = skewed(level.pressurePa, 0.0).y;
        if (level.pressurePa < kHighestPa || up - last < kApart || !level.windMPerS) continue;
        figure.barbs.push_back({{kWarmestC - 9.0, up}, *level.windMPerS});
        last = up;
    }
}

std::string pointText(const std::optional<ParcelPoint>& point) {
    if (!point) return "none";
    return fmt::format("{:.0f} hPa, {:.0f} m", 0.01 * point->pressurePa, point->heightM);
}

void addAscentNotes(plot::Figure& figure, const char* name, const Ascent& ascent) {
    figure.notes.emplace_back(fmt::format("CAPE, {}", name),
                              fmt::format("{:.0f} J/kg", ascent.capeJPerKg));
    figure.notes.emplace_back(fmt::format("CIN, {}", name),
                              fmt::format("{:.0f} J/kg", ascent.cinJPerKg));
    figure.notes.emplace_back("  LCL", pointText(ascent.condensation));
    figure.notes.emplace_back("  LFC", pointText(ascent.freeConvection));
    figure.notes.emplace_back("  EL", pointText(ascent.equilibrium));
}

std::string windText(glm::dvec2 windMPerS) {
    // From where it blows, clockwise from the grid's y axis.
    const double from = glm::degrees(std::atan2(-windMPerS.x, -windMPerS.y));
    return fmt::format("{:.0f}°, {:.0f} m/s", from < 0.0 ? from + 360.0 : from,
                       glm::length(windMPerS));
}

void addWindNotes(plot::Figure& figure, const WindIndices& wind) {
    const auto shear = [](const std::optional<glm::dvec2>& of) {
        return of ? fmt::format("{:.1f} m/s", glm::length(*of)) : std::string(kNotKnown);
    };
    const auto helicity = [](const std::optional<double>& of) {
        return of ? fmt::format("{:.0f} m²/s²", *of) : std::string(kNotKnown);
    };
    figure.notes.emplace_back("Shear 0–1 km", shear(wind.shear1MPerS));
    figure.notes.emplace_back("Shear 0–6 km", shear(wind.shear6MPerS));
    figure.notes.emplace_back("SRH 0–1 km", helicity(wind.helicity1));
    figure.notes.emplace_back("SRH 0–3 km", helicity(wind.helicity3));
    if (!wind.motion) return;
    figure.notes.emplace_back("Right mover", windText(wind.motion->rightMPerS));
    figure.notes.emplace_back("Left mover", windText(wind.motion->leftMPerS));
}

}  // namespace

plot::Figure skewTFigure(const ColumnReport& report, ParcelSource source, const std::string& title,
                         const std::string& subtitle) {
    plot::Figure figure;
    figure.title = title;
    figure.subtitle = subtitle;
    figure.x = {"Temperature, °C", kColdestC, kWarmestC, false, {}};
    figure.y = {"Pressure, hPa", 0.0, 1.0, false, {}};
    for (const int hPa : {1000, 850, 700, 500, 400, 300, 250, 200, 150, 100}) {
        figure.y.ticks.push_back({skewed(100.0 * hPa, 0.0).y, std::to_string(hPa)});
    }
    figure.meaning = [](glm::dvec2 at) {
        const double pressurePa = kLowestPa * std::pow(kHighestPa / kLowestPa, at.y);
        return fmt::format("{:.0f} hPa, {:.1f} °C", 0.01 * pressurePa, at.x - kSkewC * at.y);
    };
    addBackground(figure);
    if (!report.sounding) return figure;
    const std::array ascents{&report.convection->surface, &report.convection->mixedLayer,
                             &report.convection->mostUnstable};
    addSounding(figure, *report.sounding, *ascents[static_cast<std::size_t>(source)]);
    addBarbs(figure, *report.sounding);
    addAscentNotes(figure, "surface", report.convection->surface);
    addAscentNotes(figure, "mixed layer", report.convection->mixedLayer);
    addAscentNotes(figure, "most unstable", report.convection->mostUnstable);
    if (report.wind) addWindNotes(figure, *report.wind);
    return figure;
}

plot::Figure hodographFigure(const ColumnReport& report) {
    plot::Figure figure;
    figure.title = "Hodograph";
    figure.equalScale = true;
    struct Layer {
        double fromM, toM;
        plot::Ink ink;
        const char* label;
    };
    const Sounding& sounding = *report.sounding;
    const double top = windTopM(sounding);
    double most = 10.0;
    for (const Layer& layer : {Layer{0.0, 1000.0, plot::Ink::red, "0–1 km"},
                               Layer{1000.0, 3000.0, plot::Ink::orange, "1–3 km"},
                               Layer{3000.0, 6000.0, plot::Ink::green, "3–6 km"},
                               Layer{6000.0, 10000.0, plot::Ink::blue, "6–10 km"}}) {
        if (layer.fromM >= top) break;
        plot::Curve curve = curveOf(layer.ink, 2.2);
        curve.label = layer.label;
        constexpr int kSteps = 40;
        for (int i = 0; i <= kSteps; ++i) {
            const glm::dvec2 wind = windAt(
                sounding, std::lerp(layer.fromM, std::min(layer.toM, top), double(i) / kSteps));
            curve.points.push_back(wind);
            most = std::max({most, std::abs(wind.x), std::abs(wind.y)});
        }
        figure.curves.push_back(std::move(curve));
    }
    most *= 1.1;
    figure.x = {"Wind along x, m/s", -most, most, false, {}};
    figure.y = {"Wind along y, m/s", -most, most, false, {}};
    if (!report.wind->motion) return figure;
    const StormMotion& motion = *report.wind->motion;
    figure.marks = {{motion.rightMPerS, "right", plot::Ink::foreground, true},
                    {motion.leftMPerS, "left", plot::Ink::foreground, true},
                    {motion.meanMPerS, "mean", plot::Ink::foreground, true}};
    return figure;
}

plot::Figure profileFigure(const ColumnReport& report, const std::string& title) {
    constexpr std::array kInks{plot::Ink::foreground, plot::Ink::cyan,   plot::Ink::blue,
                               plot::Ink::orange,     plot::Ink::purple, plot::Ink::red};
    plot::Figure figure;
    figure.title = title;
    double most = 0.1;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const Profile* profile = report.find(static_cast<Quantity>(s));
        if (profile == nullptr) continue;
        plot::Curve curve = curveOf(kInks[static_cast<std::size_t>(s)], 1.8);
        curve.label = info(profile->quantity).label;
        for (std::size_t i = 0; i < profile->values.size(); ++i) {
            curve.points.push_back({profile->values[i], kKm * report.heightsM[i]});
            most = std::max(most, profile->values[i]);
        }
        figure.curves.push_back(std::move(curve));
    }
    figure.x = {"Mixing ratio, g/kg", 0.0, 1.05 * most, false, {}};
    figure.y = {"Height above sea level, km",
                kKm * report.groundM,
                kKm * report.heightsM.back(),
                false,
                {}};
    return figure;
}

plot::Table columnTable(const ColumnReport& report) {
    plot::Table table;
    table.columns.push_back({"height [m]", report.heightsM, {}});
    for (const Profile& profile : report.profiles) {
        table.columns.push_back(
            {fmt::format("{} [{}]", info(profile.quantity).id, info(profile.quantity).unit),
             profile.values,
             {}});
    }
    return table;
}

}  // namespace neph
