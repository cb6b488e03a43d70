// section_figures.cpp: sections as plots and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/figures.h"

namespace neph {
namespace {

constexpr double kKm = 1e-3;

std::vector<double> inKm(const std::vector<double>& metres) {
    std::vector<double> km;
    for (const double m : metres) km.push_back(kKm * m);
    return km;
}

std::string labelOf(Quantity quantity) {
    return fmt::format("{}, {}", info(quantity).label, info(quantity).unit);
}

struct Span {
    double least = 0.0, greatest = 0.0;
};

Span spanOf(const std::vector<float>& values) {
    Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const float value : values) {
        if (!std::isfinite(value)) continue;
        span.least = std::min(span.least, static_cast<double>(value));
        span.greatest = std::max(span.greatest, static_cast<double>(value));
    }
    return span.least <= span.greatest ? span : Span{};
}

/// Limits of colours that suit the quantity, round ones where none are asked for.
Span limitsOf(const SectionField& field, const ColourLimits& asked) {
    const Span span = spanOf(field.values);
    Span limits = span;
    const Colouring colouring = info(field.quantity).colouring;
    if (colouring == Colouring::fromZero) limits.least = 0.0;
    if (colouring == Colouring::aroundZero) {
        limits.greatest = std::max(std::abs(span.least), std::abs(span.greatest));
        limits.least = -limits.greatest;
    }
    if (field.quantity == Quantity::reflectivity) limits.least = std::max(limits.least, 0.0);
    limits.least = asked.from.value_or(limits.least);
    limits.greatest = asked.to.value_or(limits.greatest);
    if (!(limits.greatest > limits.least)) limits.greatest = limits.least + 1.0;
    return limits;
}

plot::Field coloursOf(const CrossSection& section, const ColourLimits& asked) {
    const SectionField& first = section.fields.front();
    const Span limits = limitsOf(first, asked);
    plot::Field field;
    field.label = labelOf(first.quantity);
    field.edgesX = plot::edgesAround(inKm(section.acrossM));
    field.edgesY = plot::edgesAround(inKm(section.upM));
    field.values = first.values;
    field.from = limits.least;
    field.to = limits.greatest;
    const bool signedValues = info(first.quantity).colouring == Colouring::aroundZero;
    field.map = signedValues ? plot::ColourMap::diverging : plot::ColourMap::sequential;
    return field;
}

plot::Contours contoursOf(const CrossSection& section, const SectionField& field) {
    plot::Contours contours;
    contours.label = labelOf(field.quantity);
    contours.x = inKm(section.acrossM);
    contours.y = inKm(section.upM);
    contours.values = field.values;
    const Span span = spanOf(field.values);
    contours.levels = plot::roundLevels(span.least, span.greatest, 10);
    return contours;
}

plot::Curve groundOf(const CrossSection& section) {
    plot::Curve ground;
    ground.ink = plot::Ink::ground;
    ground.filledBelow = true;
    for (std::size_t i = 0; i < section.acrossM.size(); ++i) {
        ground.points.push_back({kKm * section.acrossM[i], kKm * section.groundM[i]});
    }
    return ground;
}

void addTemperatureLines(plot::Figure& figure, const CrossSection& section) {
    struct Line {
        double celsius;
        plot::Ink ink;
    };
    for (const Line& line : {Line{0.0, plot::Ink::red}, Line{-20.0, plot::Ink::cyan}}) {
        plot::Contours contours = contoursOf(section, section.fields.back());
        contours.label = fmt::format("{:g} °C", line.celsius);
        contours.levels = {line.celsius};
        contours.ink = line.ink;
        contours.width = 1.5;
        figure.contours.push_back(std::move(contours));
    }
    if (section.tropopauseM.empty()) return;
    plot::Curve tropopause;
    tropopause.label = "Tropopause";
    tropopause.ink = plot::Ink::purple;
    tropopause.dashed = true;
    for (std::size_t i = 0; i < section.acrossM.size(); ++i) {
        tropopause.points.push_back({kKm * section.acrossM[i], kKm * section.tropopauseM[i]});
    }
    figure.curves.push_back(std::move(tropopause));
}

}  // namespace

plot::Figure sectionFigure(const CrossSection& section, const ColourLimits& asked,
                           const std::string& title, const std::string& subtitle) {
    plot::Figure figure;
    figure.title = title;
    figure.subtitle = subtitle;
    figure.field = coloursOf(section, asked);
    const plot::Field& field = *figure.field;
    figure.x = {section.vertical ? "Along the section, km" : "x, km",
                field.edgesX.front(),
                field.edgesX.back(),
                false,
                {}};
    figure.y = {section.vertical ? "Height above sea level, km" : "y, km",
                field.edgesY.front(),
                field.edgesY.back(),
                false,
                {}};
    figure.equalScale = !section.vertical;
    const std::size_t fields = section.fields.size() - (section.temperatureLast ? 1 : 0);
    for (std::size_t i = 1; i < fields; ++i) {
        figure.contours.push_back(contoursOf(section, section.fields[i]));
    }
    if (section.temperatureLast) addTemperatureLines(figure, section);
    if (section.vertical) figure.curves.push_back(groundOf(section));
    return figure;
}

plot::Table sectionTable(const CrossSection& section) {
    plot::Table table;
    plot::Column across{section.vertical ? "along [m]" : "x [m]", {}, {}};
    plot::Column up{section.vertical ? "height [m]" : "y [m]", {}, {}};
    for (std::size_t k = 0; k < section.upM.size(); ++k) {
        for (const double at : section.acrossM) {
            across.numbers.push_back(at);
            up.numbers.push_back(section.upM[k]);
        }
    }
    table.columns = {std::move(across), std::move(up)};
    for (const SectionField& field : section.fields) {
        plot::Column column{
            fmt::format("{} [{}]", info(field.quantity).id, info(field.quantity).unit), {}, {}};
        column.numbers.assign(field.values.begin(), field.values.end());
        table.columns.push_back(std::move(column));
    }
    return table;
}

}  // namespace neph
