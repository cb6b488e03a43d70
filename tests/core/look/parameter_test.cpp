// parameter_test.cpp: the rows of the table, values in and out as text, and what they go without.
#include "core/look/parameter.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#include "core/base/error.h"
#include "core/look/known_error.h"
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

/// Another value that the row takes.
ParameterValue otherThan(const Parameter& row, const ParameterValue& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return !std::get<bool>(value);
        case ParameterKind::choice:
            return std::get<int>(value) == 0 ? 1 : 0;
        case ParameterKind::integer:
            return std::get<int>(value) + 1;
        case ParameterKind::colour:
            return glm::vec3(0.123f);
        case ParameterKind::number:
            break;
    }
    const auto lo = static_cast<float>(row.range.lo), hi = static_cast<float>(row.range.hi);
    return std::get<float>(value) == hi ? lo : hi;
}

}  // namespace

TEST_CASE("Every parameter has its own id, a label, a group and a line of help") {
    std::set<std::string> ids;
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        CHECK(ids.insert(row.id).second);
        CHECK_FALSE(row.label.empty());
        CHECK_FALSE(row.group.empty());
        CHECK_FALSE(row.help.empty());
        CHECK(row.choices.empty() == (row.kind != ParameterKind::choice));
        for (const Choice& choice : row.choices) {
            CAPTURE(choice.id);
            CHECK_FALSE(choice.id.empty());
            CHECK_FALSE(choice.label.empty());
            CHECK_FALSE(choice.help.empty());
        }
    }
}

TEST_CASE("The table is the rows of looks and then those of the sampling") {
    REQUIRE(lookTable().size() + samplingTable().size() == parameterTable().size());
    std::set<std::string> sampling;
    for (const Parameter& row : samplingTable()) {
        CHECK(row.part == ParameterPart::sampling);
        sampling.insert(row.id);
    }
    CHECK(sampling == std::set<std::string>{"view.quality", "view.light_voxels",
                                            "view.target_error", "view.seed"});
    for (const Parameter& row : lookTable()) CHECK(row.part != ParameterPart::sampling);
    CHECK(&lookTable().front() == &parameterTable().front());
    CHECK(&samplingTable().back() == &parameterTable().back());
}

TEST_CASE("A parameter that is set has the value, and no other has changed") {
    const ParameterSet before;
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        const ParameterValue value = otherThan(row, defaultOf(row));
        ParameterSet after;
        setValue(after, row, value);
        CHECK(valueOf(after, row) == value);
        CHECK((after.look == before.look) == (row.part == ParameterPart::sampling));
        CHECK((after.sampling == before.sampling) == (row.part != ParameterPart::sampling));
        for (const Parameter& other : parameterTable()) {
            if (&other != &row) CHECK(valueOf(after, other) == valueOf(before, other));
        }
        setValue(after, row, defaultOf(row));
        CHECK(after == before);
    }
}

TEST_CASE("Every default is a value that the parameter takes") {
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        ParameterSet values;
        CHECK_NOTHROW(setValue(values, row, defaultOf(row)));
        CHECK(values == ParameterSet{});
    }
}

TEST_CASE("Every value that text can give is read back from its own text") {
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        const ParameterValue value = defaultOf(row);
        CHECK(parseValue(row, formatValue(row, value)) == value);
        for (std::size_t i = 0; i < row.choices.size(); ++i) {
            CHECK(parseValue(row, row.choices[i].id) == ParameterValue(static_cast<int>(i)));
        }
        if (row.kind != ParameterKind::number) continue;
        for (const double end : {row.range.lo, row.range.hi}) {
            const ParameterValue bound = static_cast<float>(end);
            CHECK(parseValue(row, formatValue(row, bound)) == bound);
        }
    }
}

TEST_CASE("An assignment sets the one parameter that it names") {
    ParameterSet values;
    applyAssignment(values, "cloud.mixing_scale=0.5");
    CHECK(values.look.of(Species::cloud).mixingScale == 0.5f);
    applyAssignment(values, "light.transport=low_albedo");
    CHECK(values.look.transport == Transport::lowAlbedo);
    applyAssignment(values, "sky.zenith=0.1,0.2,0.3");
    CHECK(values.look.skyZenith == glm::vec3(0.1f, 0.2f, 0.3f));
    applyAssignment(values, "ground.visible=false");
    CHECK_FALSE(values.look.groundVisible);
    applyAssignment(values, "view.planes=64");
    CHECK(values.look.planes == 64);
    applyAssignment(values, "view.seed=7");
    CHECK(values.sampling.seed == 7);
    ParameterSet expected;
    expected.look.of(Species::cloud).mixingScale = 0.5f;
    expected.look.transport = Transport::lowAlbedo;
    expected.look.skyZenith = {0.1f, 0.2f, 0.3f};
    expected.look.groundVisible = false;
    expected.look.planes = 64;
    expected.sampling.seed = 7;
    CHECK(values == expected);
}

TEST_CASE("Values as assignments are read back one by one") {
    ParameterSet values;
    values.sampling = {.quality = 0.25f, .lightVoxels = 5000, .targetError = 0.05f, .seed = 7};
    const std::string text = formatAssignments(samplingTable(), values);
    CHECK(text == "view.quality=0.25 view.light_voxels=5000 view.target_error=0.05 view.seed=7");
    ParameterSet again;
    std::istringstream words(text);
    for (std::string word; words >> word;) applyAssignment(again, word);
    CHECK(again == values);
}

TEST_CASE("A number as the screen shows it is in the unit of the screen") {
    const auto number = [](const char* id, const char* text) {
        return std::get<float>(parseScreenValue(parameter(id), text));
    };
    CHECK(number("rain.effective_radius", "250") == doctest::Approx(250e-6f));
    CHECK(number("view.target_error", "5") == doctest::Approx(0.05f));
    CHECK(number("view.target_error", "50") == 0.5f);  // a bound
    CHECK(number("view.quality", "2") == 2.0f);
    CHECK(std::get<int>(parseScreenValue(parameter("view.engine"), "slicing")) == 1);
    CHECK(contains(messageOf([&] { number("view.target_error", "0"); }), "from 0.05 to 50 %"));
    CHECK(contains(messageOf([&] { number("view.target_error", "51"); }), "from 0.05 to 50 %"));
}

TEST_CASE("A value out of range is refused with id, value and range, and changes nothing") {
    ParameterSet values;
    const std::string text =
        messageOf([&] { applyAssignment(values, "cloud.mixing_scale=100.1"); });
    CHECK(contains(text, "cloud.mixing_scale"));
    CHECK(contains(text, "100.1"));
    CHECK(contains(text, "from 0 to 100"));
    CHECK(values == ParameterSet{});
}

TEST_CASE("Text that is no value of the parameter is refused") {
    for (const char* assignment :
         {"cloud.mixing_scale=", "cloud.mixing_scale=1x", "cloud.mixing_scale=nan",
          "cloud.mixing_scale=inf", "cloud.mixing_scale=1e99", "view.planes=64.5",
          "light.transport=translucen", "ground.visible=maybe", "sky.zenith=0.1,0.2",
          "sky.zenith=0.1,0.2,0.3,0.4", "sky.zenith=0.1,0.2,1.5", "no_equals_sign"}) {
        CAPTURE(assignment);
        ParameterSet values;
        CHECK_THROWS_AS(applyAssignment(values, assignment), Error);
        CHECK(values == ParameterSet{});
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
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        const ParameterSet before;
        ParameterSet after;
        setValue(after, row, otherThan(row, defaultOf(row)));
        CHECK(firstDifference(before, after) == row.invalidates);
        const bool inLook = row.part != ParameterPart::sampling;
        CHECK(firstDifference(before.look, after.look).has_value() == inLook);
    }
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
    look.of(Species::ice).radiusSource = RadiusSource::number;
    CHECK_FALSE(applies(parameter("ice.effective_radius"), look));
    CHECK_FALSE(applies(parameter("ice.density"), look));
    CHECK(applies(parameter("snow.effective_radius"), look));
}

TEST_CASE("A mode that leaves a parameter without effect is named") {
    Look look;
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        CHECK(overruledBy(row, look).empty());
    }
    look.phaseMode = PhaseMode::uniform;
    CHECK(overruledBy(parameter("snow.phase"), look) == "Phase is Uniform");
    CHECK(overruledBy(parameter("light.uniform_phase"), look).empty());
    look.extinction = ExtinctionMode::equal;
    CHECK(overruledBy(parameter("rain.radius_source"), look) == "Extinction is Equal");
    look.noise = false;
    CHECK(overruledBy(parameter("ice.noise_amount"), look) == "Detail noise is off");
}

TEST_CASE(
    "Linked fields share sizes by factor, what they are by value, and how they are shown not") {
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        const std::string name = row.id.substr(row.id.find('.') + 1);
        LinkPolicy expected = row.species ? LinkPolicy::value : LinkPolicy::own;
        if (name == "mixing_scale" || name == "effective_radius") expected = LinkPolicy::factor;
        if (name == "visible" || name == "colour" || name == "density") expected = LinkPolicy::own;
        CHECK(row.link == expected);
    }
}

TEST_CASE("An option of the command line stands for one parameter, and says so") {
    std::set<std::string_view> names;
    for (const Parameter& row : parameterTable()) {
        if (row.alias.name.empty()) continue;
        CAPTURE(row.id);
        CHECK(row.alias.name.starts_with("--"));
        CHECK(names.insert(row.alias.name).second);
        CHECK_FALSE(row.alias.takes.empty());
        CHECK(contains(std::string(row.alias.help), row.id));
        CHECK(&parameterOfOption(row.alias.name) == &row);
    }
    CHECK(names ==
          std::set<std::string_view>{"--engine", "--quality", "--planes", "--error", "--seed"});
}

TEST_CASE("What makes up for scatterings that are not followed has no effect where all are") {
    Look look;
    for (const char* id : {"light.forward_angle", "light.forward_g", "light.phase_display",
                           "light.phase_truncation", "sky.skylight"}) {
        CAPTURE(id);
        look.phaseDisplay = PhaseDisplay::logarithmic;
        look.transport = Transport::full;
        look.engine = Engine::march;
        CHECK_FALSE(applies(parameter(id), look));
        look.engine = Engine::slicing;  // which does not know full transport
        CHECK(applies(parameter(id), look));
        look.transport = Transport::translucent;
        CHECK(applies(parameter(id), look));
    }
}

TEST_CASE("A parameter is found by its former name, and written by its own") {
    ParameterSet values;
    applyAssignment(values, "mode.transport=low_albedo");
    CHECK(values.look.transport == Transport::lowAlbedo);
    CHECK(parameter("mode.transport").id == "light.transport");
}

TEST_CASE("Ways of following light that have an error say so, and full transport says nothing") {
    Look look;
    look.engine = Engine::march;
    CHECK(knownErrorText(look).empty());
    look.transport = Transport::translucent;
    CHECK(knownErrorText(look).find("too dark") != std::string::npos);
    look.phaseDisplay = PhaseDisplay::logarithmic;
    CHECK(knownErrorText(look).find("not a radiance") != std::string::npos);
    look.transport = Transport::full;
    look.engine = Engine::slicing;
    CHECK_FALSE(knownErrorText(look).empty());
    look.engine = Engine::reference;
    CHECK(knownErrorText(look).empty());
}

TEST_CASE("An engine that does not know periodic sides says that they are open") {
    Look look;
    look.engine = Engine::slicing;
    CHECK(knownErrorText(look).find("sides are open") == std::string::npos);
    look.domainSides = DomainSides::periodic;
    CHECK(knownErrorText(look).find("; sides are open") != std::string::npos);
    look.engine = Engine::march;
    CHECK(knownErrorText(look).empty());
    look.engine = Engine::reference;
    CHECK(knownErrorText(look).empty());
}
