// radius_plan_test.cpp: what stands in for what, said in words, and the extinction of cells.
#include "core/volume/radius_plan.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/volume/radius_scheme.h"
#include "tests/text.h"

using namespace neph;
using doctest::Approx;

namespace {

/// A data set of `scheme` with ratios of all species.
DatasetInfo dataOf(Microphysics scheme) {
    DatasetInfo data;
    data.microphysics = scheme;
    data.scheme = scheme == Microphysics::unknown ? "" : "Some scheme";
    for (int s = 0; s < kSpeciesCount; ++s) {
        VariableInfo& ratio = data.variables.emplace_back();
        ratio.name = "Q" + std::to_string(s);
        ratio.role = VariableRole::mixingRatio;
        ratio.species = static_cast<Species>(s);
    }
    return data;
}

void add(DatasetInfo& data, const std::string& name, VariableRole role,
         std::optional<Species> species = {}) {
    VariableInfo& variable = data.variables.emplace_back();
    variable.name = name;
    variable.role = role;
    variable.species = species;
}

RadiusPlan planOf(Species s, RadiusSource source, const DatasetInfo& data) {
    Look look;
    look.of(s).radiusSource = source;
    return planRadii(look, data);
}

RadiusPlan ruled(Species s, const RadiusRule& rule) {
    RadiusPlan plan;
    plan.rules[static_cast<std::size_t>(s)] = rule;
    return plan;
}

}  // namespace

TEST_CASE("A look of constant radii needs nothing of the model, whatever its optics") {
    DatasetInfo data = dataOf(Microphysics::thompson);
    add(data, "RE_ICE", VariableRole::effectiveRadius, Species::ice);
    Look look;
    look.radiationOptics = RadiationOptics::wrfRrtmg;
    CHECK(planRadii(look, data) == RadiusPlan{});
}

TEST_CASE("A look of one extinction for all holds masses") {
    Look look;
    look.of(Species::ice).radiusSource = RadiusSource::scheme;
    look.extinction = ExtinctionMode::equal;
    CHECK(planRadii(look, dataOf(Microphysics::thompson)) == RadiusPlan{});
}

TEST_CASE("A species that the model lacks is not planned and not complained of") {
    Look look;
    look.of(Species::hail).radiusSource = RadiusSource::file;
    DatasetInfo data = dataOf(Microphysics::thompson);
    data.variables.pop_back();
    CHECK(planRadii(look, data) == RadiusPlan{});
}

TEST_CASE("Radii of the file are read with what fills their gaps") {
    DatasetInfo data = dataOf(Microphysics::thompson);
    add(data, "RE_ICE", VariableRole::effectiveRadius, Species::ice);
    add(data, "QNICE", VariableRole::numberConcentration, Species::ice);
    add(data, "RE_SNOW", VariableRole::effectiveRadius, Species::snow);
    add(data, "temp", VariableRole::airTemperature);
    const RadiusPlan ice = planOf(Species::ice, RadiusSource::file, data);
    CHECK(ice.notes.empty());
    CHECK(ice.of(Species::ice).source == RadiusSource::file);
    CHECK(ice.of(Species::ice).radiusVariable == "RE_ICE");
    CHECK(ice.of(Species::ice).numberVariable == "QNICE");
    CHECK(ice.of(Species::ice).temperatureVariable.empty());
    CHECK(ice.holdsMass(Species::snow));
    const RadiusPlan snow = planOf(Species::snow, RadiusSource::file, data);
    CHECK(snow.of(Species::snow).temperatureVariable == "temp");
}

TEST_CASE("What the file lacks is replaced by the next source, and said") {
    DatasetInfo data = dataOf(Microphysics::thompson);
    add(data, "QNICE", VariableRole::numberConcentration, Species::ice);
    const RadiusPlan byNumber = planOf(Species::ice, RadiusSource::file, data);
    CHECK(byNumber.of(Species::ice).source == RadiusSource::number);
    REQUIRE(byNumber.notes.size() == 1);
    CHECK(byNumber.notes[0] ==
          "Ice: the file has no effective radius; the number of particles gives the size instead.");
    const RadiusPlan byScheme = planOf(Species::graupel, RadiusSource::file, data);
    CHECK(byScheme.of(Species::graupel).source == RadiusSource::scheme);
    REQUIRE(byScheme.notes.size() == 1);
    CHECK(byScheme.notes[0] ==
          "Graupel: the file has no effective radius and no number of particles; the microphysics "
          "scheme gives the size instead.");
}

TEST_CASE("Where the scheme says nothing either, the assumption is named") {
    const RadiusPlan unknown =
        planOf(Species::ice, RadiusSource::scheme, dataOf(Microphysics::unknown));
    REQUIRE(unknown.notes.size() == 1);
    CHECK(unknown.notes[0] ==
          "Ice: the file has no known microphysics scheme; a radius of 30 µm is assumed instead.");
    const RadiusPlan lin = planOf(Species::cloud, RadiusSource::scheme, dataOf(Microphysics::lin));
    REQUIRE(lin.notes.size() == 1);
    CHECK(contains(lin.notes[0], "no size by its scheme, Some scheme; 100 droplets per cm³"));
    CHECK(planOf(Species::rain, RadiusSource::scheme, dataOf(Microphysics::lin)).notes.empty());
    const RadiusPlan uncounted =
        planOf(Species::ice, RadiusSource::file, dataOf(Microphysics::morrison));
    REQUIRE(uncounted.notes.size() == 1);
    CHECK(contains(uncounted.notes[0], "no number of particles; a radius of 30 µm is assumed"));
}

TEST_CASE("Snow whose scheme needs the temperature does without where there is none, and says so") {
    DatasetInfo data = dataOf(Microphysics::wsm6);
    const RadiusPlan without = planOf(Species::snow, RadiusSource::scheme, data);
    REQUIRE(without.notes.size() == 1);
    CHECK(contains(without.notes[0], "no air temperature; the size distribution of Lin"));
    add(data, "temp", VariableRole::airTemperature);
    CHECK(planOf(Species::snow, RadiusSource::scheme, data).notes.empty());
}

TEST_CASE("Droplets are as many as the run prescribes") {
    DatasetInfo data = dataOf(Microphysics::morrison);
    data.cloudDropletsPerM3 = 7e8;
    const RadiusPlan plan = planOf(Species::cloud, RadiusSource::number, data);
    CHECK(plan.notes.empty());
    std::array values{1e-3f};
    contentToExtinction(plan, Species::cloud, {}, values);
    const ParticleSize size =
        sizeFromNumber(Microphysics::morrison, Species::cloud, {1e-3, 7e8, kFreezingK});
    CHECK(static_cast<double>(values[0]) == Approx(1.5e-3 / (1000.0 * size.radiusM)));
}

TEST_CASE("A scheme that is not known leaves the number that the run prescribes to size droplets") {
    DatasetInfo data = dataOf(Microphysics::unknown);
    data.cloudDropletsPerM3 = 7e7;
    const RadiusPlan asked = planOf(Species::cloud, RadiusSource::scheme, data);
    const RadiusPlan numbered = planOf(Species::cloud, RadiusSource::number, data);
    CHECK(asked.rules == numbered.rules);
    REQUIRE(asked.notes.size() == 1);
    CHECK(asked.notes[0].find("the number of particles gives the size instead") !=
          std::string::npos);
}

TEST_CASE("Extinction of ice is 3 Q content over 4 density radius, and 0 where there is none") {
    RadiusRule rule;
    rule.source = RadiusSource::file;
    rule.scheme = Microphysics::thompson;  // ice of 890 kg/m³
    const std::array radius{20e-6f, 50e-6f, 20e-6f};
    std::array values{1e-3f, 1e-4f, 0.0f};
    const RadiusGaps gaps =
        contentToExtinction(ruled(Species::ice, rule), Species::ice,
                            {.radiusM = radius, .numberPerM3 = {}, .temperatureK = {}}, values);
    CHECK(static_cast<double>(values[0]) == Approx(1.5 * 1e-3 / (890.0 * 20e-6)));
    CHECK(static_cast<double>(values[1]) == Approx(1.5 * 1e-4 / (890.0 * 50e-6)));
    CHECK(values[2] == 0.0f);
    CHECK(gaps.cells == 2);
    CHECK(gaps.gaps == 0);
    CHECK(describe(gaps, rule, Species::ice).empty());
}

TEST_CASE(
    "Where the file has only its background radius, number and then scheme stand in, counted") {
    RadiusRule rule;
    rule.source = RadiusSource::file;
    rule.scheme = Microphysics::thompson;
    rule.radiusVariable = "RE_ICE";
    rule.numberVariable = "QNICE";
    const std::array radius{4.99e-6f, 4.99e-6f, 40e-6f, std::numeric_limits<float>::quiet_NaN()};
    const std::array number{1e5f, 0.0f, 1e5f, std::numeric_limits<float>::infinity()};
    std::array values{1e-4f, 1e-4f, 2e-4f, 1e-4f};
    const RadiusPlan plan = ruled(Species::ice, rule);
    const RadiusGaps gaps = contentToExtinction(plan, Species::ice, {radius, number, {}}, values);
    const ParticleSize byNumber =
        sizeFromNumber(Microphysics::thompson, Species::ice, {1e-4, 1e5, kFreezingK});
    CHECK(static_cast<double>(values[0]) == Approx(1.5e-4 / (890.0 * byNumber.radiusM)));
    const double assumed = 1.5e-4 / (917.0 * 30e-6);
    CHECK(static_cast<double>(values[1]) == Approx(assumed));
    CHECK(static_cast<double>(values[2]) == Approx(3e-4 / (890.0 * 40e-6)));
    CHECK(static_cast<double>(values[3]) == Approx(assumed));
    CHECK(gaps.cells == 4);
    CHECK(gaps.gaps == 3);
    CHECK(describe(gaps, rule, Species::ice) ==
          "Ice: RE_ICE gives no radius in 75 % of the cells, 60 % of the mass; number or scheme "
          "stand in.");
}

TEST_CASE("However strange the values of a cell, its extinction is a number") {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInf = std::numeric_limits<float>::infinity();
    for (const Microphysics scheme : {Microphysics::unknown, Microphysics::lin, Microphysics::wsm6,
                                      Microphysics::thompson, Microphysics::morrison}) {
        for (int s = 0; s < kSpeciesCount; ++s) {
            for (const RadiusSource source :
                 {RadiusSource::file, RadiusSource::number, RadiusSource::scheme}) {
                RadiusRule rule;
                rule.source = source;
                rule.scheme = scheme;
                for (const float odd : {kNan, kInf, -1.0f, 0.0f, 1e-30f, 1e30f}) {
                    for (const float content : {1e-30f, 1e-15f, 1e-3f, 1.0f}) {
                        for (int which = 0; which < 3; ++which) {
                            std::array<float, 3> cell{20e-6f, 1e6f, 250.0f};
                            cell[static_cast<std::size_t>(which)] = odd;
                            std::array values{content};
                            contentToExtinction(
                                ruled(static_cast<Species>(s), rule), static_cast<Species>(s),
                                {{&cell[0], 1}, {&cell[1], 1}, {&cell[2], 1}}, values);
                            CAPTURE(s);
                            CAPTURE(odd);
                            CAPTURE(content);
                            CHECK(std::isfinite(values[0]));
                            CHECK(values[0] >= 0.0f);
                        }
                    }
                }
            }
        }
    }
}
