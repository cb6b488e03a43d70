// look_test.cpp: the rows of the look table, and values in and out as text, and which act.
#include "core/look/look.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/optics/phase_functions.h"
#include "tests/text.h"

using namespace neph;

namespace {

std::string messageOf(auto&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

std::size_t sizeOf(const Parameter& row) {
    if (row.kind == ParameterKind::toggle) return sizeof(bool);
    return row.kind == ParameterKind::colour ? sizeof(glm::vec3) : sizeof(float);
}

/// The parameters of the phase function of cloud that act when it is of this kind.
std::set<std::string> acting(PhaseKind kind) {
    Look look;
    look.of(Species::cloud).phase.kind = kind;
    std::set<std::string> ids;
    for (const Parameter& row : lookTable()) {
        if (row.id.starts_with("cloud.phase_") && applies(row, look)) ids.insert(row.id);
    }
    return ids;
}

}  // namespace

TEST_CASE("Every parameter has its own id, a label, a group and a line of help") {
    std::set<std::string> ids;
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        CHECK(ids.insert(row.id).second);
        CHECK_FALSE(row.label.empty());
        CHECK_FALSE(row.group.empty());
        CHECK_FALSE(row.help.empty());
        CHECK(row.choices.size() == row.choiceLabels.size());
    }
}

TEST_CASE("No two parameters share a byte of the look") {
    std::set<std::size_t> bytes;
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        CHECK(row.offset + sizeOf(row) <= sizeof(Look));
        for (std::size_t i = 0; i < sizeOf(row); ++i) CHECK(bytes.insert(row.offset + i).second);
    }
}

TEST_CASE("Every default is a value that the parameter takes") {
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        Look look;
        CHECK_NOTHROW(setValue(look, row, defaultOf(row)));
        CHECK(look == Look{});
    }
}

TEST_CASE("Default radii are those of table 3 of the paper") {
    const Look look;
    CHECK(look.of(Species::cloud).effectiveRadiusM == 0.01e-3f);
    CHECK(look.of(Species::ice).effectiveRadiusM == 1e-3f);
    CHECK(look.of(Species::rain).effectiveRadiusM == 1e-3f);
    CHECK(look.of(Species::snow).effectiveRadiusM == 2e-3f);
    CHECK(look.of(Species::graupel).effectiveRadiusM == 2.5e-3f);
}

TEST_CASE("Every value that text can give is read back from its own text") {
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        const ParameterValue value = defaultOf(row);
        CHECK(parseValue(row, formatValue(row, value)) == value);
        for (std::size_t i = 0; i < row.choices.size(); ++i) {
            CHECK(parseValue(row, row.choices[i]) == ParameterValue(static_cast<int>(i)));
        }
        if (row.kind != ParameterKind::number) continue;
        for (const double end : {row.range.lo, row.range.hi}) {
            const ParameterValue bound = static_cast<float>(end);
            CHECK(parseValue(row, formatValue(row, bound)) == bound);
        }
    }
}

TEST_CASE("An assignment sets the one parameter that it names") {
    Look look;
    applyAssignment(look, "cloud.mixing_scale=0.5");
    CHECK(look.of(Species::cloud).mixingScale == 0.5f);
    applyAssignment(look, "mode.transport=low_albedo");
    CHECK(look.transport == Transport::lowAlbedo);
    applyAssignment(look, "sky.zenith=0.1,0.2,0.3");
    CHECK(look.skyZenith == glm::vec3(0.1f, 0.2f, 0.3f));
    applyAssignment(look, "ground.visible=false");
    CHECK_FALSE(look.groundVisible);
    applyAssignment(look, "view.planes=64");
    CHECK(look.planes == 64);
    Look expected;
    expected.of(Species::cloud).mixingScale = 0.5f;
    expected.transport = Transport::lowAlbedo;
    expected.skyZenith = {0.1f, 0.2f, 0.3f};
    expected.groundVisible = false;
    expected.planes = 64;
    CHECK(look == expected);
}

TEST_CASE("A value out of range is refused with id, value and range, and changes nothing") {
    Look look;
    const std::string text = messageOf([&] { applyAssignment(look, "cloud.mixing_scale=100.1"); });
    CHECK(contains(text, "cloud.mixing_scale"));
    CHECK(contains(text, "100.1"));
    CHECK(contains(text, "from 0 to 100"));
    CHECK(look == Look{});
}

TEST_CASE("Text that is no value of the parameter is refused") {
    for (const char* assignment :
         {"cloud.mixing_scale=", "cloud.mixing_scale=1x", "cloud.mixing_scale=nan",
          "cloud.mixing_scale=inf", "cloud.mixing_scale=1e99", "view.planes=64.5",
          "mode.transport=translucen", "ground.visible=maybe", "sky.zenith=0.1,0.2",
          "sky.zenith=0.1,0.2,0.3,0.4", "sky.zenith=0.1,0.2,1.5", "no_equals_sign"}) {
        CAPTURE(assignment);
        Look look;
        CHECK_THROWS_AS(applyAssignment(look, assignment), Error);
        CHECK(look == Look{});
    }
}

TEST_CASE("A value that is not a number is refused, however it is given") {
    Look look;
    const Parameter& row = parameter("cloud.mixing_scale");
    CHECK_THROWS_AS(setValue(look, row, std::numeric_limits<float>::quiet_NaN()), Error);
    CHECK_THROWS_AS(setValue(look, row, std::numeric_limits<float>::infinity()), Error);
    CHECK_THROWS_AS(setValue(look, row, 1), Error);
    CHECK(look == Look{});
}

TEST_CASE("An unknown id is answered with the nearest known one") {
    CHECK(findParameter("cloud.mixing_scal") == nullptr);
    CHECK(contains(messageOf([] { parameter("cloud.mixing_scal"); }), "cloud.mixing_scale?"));
    CHECK(nearestParameterId("sun.azimut") == "sun.azimuth");
}

TEST_CASE("What must be recomputed is the earliest stage of what differs") {
    const Look a;
    CHECK_FALSE(firstDifference(a, a).has_value());
    Look b;
    b.exposureEv = 1.0f;
    CHECK(firstDifference(a, b) == Stage::resolve);
    b.sunIntensity = 2.0f;
    CHECK(firstDifference(a, b) == Stage::eye);
    b.sunAzimuthDeg = 10.0f;
    CHECK(firstDifference(a, b) == Stage::light);
    b.of(Species::hail).mixingScale = 2.0f;
    CHECK(firstDifference(a, b) == Stage::medium);
}

TEST_CASE("A change of any parameter is noticed, with the stage of its row") {
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        const Look before;
        Look after;
        if (row.kind == ParameterKind::toggle) {
            setValue(after, row, !std::get<bool>(defaultOf(row)));
        } else if (row.kind == ParameterKind::choice) {
            setValue(after, row, std::get<int>(defaultOf(row)) == 0 ? 1 : 0);
        } else if (row.kind == ParameterKind::integer) {
            setValue(after, row, std::get<int>(defaultOf(row)) + 1);
        } else if (row.kind == ParameterKind::colour) {
            setValue(after, row, glm::vec3(0.123f));
        } else {
            const bool atTop = std::get<float>(defaultOf(row)) == static_cast<float>(row.range.hi);
            setValue(after, row, static_cast<float>(atTop ? row.range.lo : row.range.hi));
        }
        CHECK(firstDifference(before, after) == row.invalidates);
    }
}

TEST_CASE("The sun stands where compass and horizon say") {
    Look look;
    look.sunElevationDeg = 0.0f;
    look.sunAzimuthDeg = 90.0f;  // east is +x
    CHECK(sunDirWorld(look).x == doctest::Approx(1.0));
    look.sunAzimuthDeg = 0.0f;  // north is +y
    CHECK(sunDirWorld(look).y == doctest::Approx(1.0));
    look.sunElevationDeg = 30.0f;
    CHECK(sunDirWorld(look).z == doctest::Approx(0.5));
    CHECK(glm::length(sunDirWorld(look)) == doctest::Approx(1.0));
}

TEST_CASE("Every parameter that a phase function reads has a row") {
    for (std::size_t kind = 0; kind < phaseFunctions().size(); ++kind) {
        const PhaseFunction& function = phaseFunctions()[kind];
        CAPTURE(function.id);
        CHECK(acting(static_cast<PhaseKind>(kind)).size() == function.reads().size());
    }
}

TEST_CASE("A phase function shows the parameters that it has, and no others") {
    using Ids = std::set<std::string>;
    CHECK(acting(PhaseKind::isotropic) == Ids{});
    CHECK(acting(PhaseKind::henyeyGreenstein) == Ids{"cloud.phase_g"});
    CHECK(acting(PhaseKind::doubleHenyeyGreenstein) ==
          Ids{"cloud.phase_g", "cloud.phase_g2", "cloud.phase_weight"});
    CHECK(acting(PhaseKind::draine) == Ids{"cloud.phase_g", "cloud.phase_alpha"});
    CHECK(acting(PhaseKind::waterDroplets) == Ids{"cloud.phase_radius"});
    CHECK(acting(PhaseKind::roughAggregate) == Ids{"cloud.phase_radius"});
}

TEST_CASE("What is no parameter of a phase function acts with the engines that it is of") {
    Look look;
    for (const Parameter& row : lookTable()) {
        const bool ofPhase = row.id.find("phase_") != std::string::npos &&
                             row.id.find(".phase_truncation") == std::string::npos &&
                             row.id.find(".phase_display") == std::string::npos;
        CAPTURE(row.id);
        for (const Engine engine : {Engine::march, Engine::slicing, Engine::reference}) {
            look.engine = engine;
            const bool acts = (row.engines & bitOf(engine)) != 0;
            if (!ofPhase || !acts) CHECK(applies(row, look) == acts);
        }
    }
    look.engine = Engine::reference;
    CHECK_FALSE(applies(parameter("sky.skylight"), look));
    CHECK_FALSE(applies(parameter("light.phase_display"), look));
    CHECK(applies(parameter("sky.intensity"), look));
    CHECK(applies(parameter("view.seed"), look));
    look.engine = Engine::march;
    CHECK_FALSE(applies(parameter("view.seed"), look));
    CHECK(applies(parameter("sky.skylight"), look));
}

TEST_CASE("A change of where radii come from has the data read again, before anything else") {
    const Look a;
    Look b;
    b.of(Species::hail).mixingScale = 2.0f;
    b.of(Species::ice).radiusSource = RadiusSource::scheme;
    CHECK(firstDifference(a, b) == Stage::data);
    CHECK(Stage::data < Stage::medium);
}

TEST_CASE("A constant radius and its density act where the radius is a constant") {
    Look look;
    CHECK(applies(parameter("ice.effective_radius"), look));
    CHECK(applies(parameter("ice.density"), look));
    applyAssignment(look, "ice.radius_source=number");
    CHECK_FALSE(applies(parameter("ice.effective_radius"), look));
    CHECK_FALSE(applies(parameter("ice.density"), look));
    CHECK(applies(parameter("snow.effective_radius"), look));
}
