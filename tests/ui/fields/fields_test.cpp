// fields_test.cpp: the fields' rows, what they link and show, and the list of steps.
#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <thread>

#include "app/ui/fields/fields_link.h"
#include "app/ui/fields/fields_panel.h"
#include "app/ui/fields/fields_plots.h"
#include "app/ui/fields/groups_panel.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/history_panel.h"
#include "app/ui/widgets/places.h"
#include "core/look/colours.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;
using doctest::Approx;

namespace {

using Draw = void (*)(ui::Ui&);

void drawFields(ui::Ui& ui) {
    ui::drawFields(ui::contextOf(ui), ui.fields);
}

void drawFind(ui::Ui& ui) {
    ui::drawFind(ui::contextOf(ui), ui.fields);
}

void drawHistory(ui::Ui& ui) {
    if (ui.showHistory) ui::drawHistory(ui.session(), ui.showHistory, ui.historySeen);
}

/// A panel in a window of 400 x 700 pixels, for a session with a cloud and nothing else.
struct Panel {
    explicit Panel(Draw drawn = drawFields) : draw(drawn) {
        ui::wantPlaces(true);
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        REQUIRE(waitUntilShown(session));
        frame();
        frame();
    }
    ~Panel() { ui::wantPlaces(false); }

    void frame() {
        ui::clearPlaces();
        gui.frame([&] {
            ImGui::SetNextWindowPos({0.0f, 0.0f});
            ImGui::SetNextWindowSize({400.0f, 700.0f});
            ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
            draw(state);
            ImGui::End();
        });
        session.history.settle(session.document, ImGui::IsAnyMouseDown(), 0.0);
    }
    void moveTo(const std::string& place, float share = 0.5f) {
        const auto where = ui::placeOf(place);
        REQUIRE_MESSAGE(where.has_value(), place);
        ImGui::GetIO().MousePos = {where->lower.x + share * (where->upper.x - where->lower.x),
                                   (where->lower.y + where->upper.y) / 2.0f};
        frame();
    }
    void press(bool down) {
        ImGui::GetIO().MouseDown[0] = down;
        frame();
    }
    void click(const std::string& place, float share = 0.5f) {
        moveTo(place, share);
        press(true);
        press(false);
    }
    Look& look() { return session.document.look; }

    Headless gui;
    std::shared_ptr<FakeSeries> series = std::make_shared<FakeSeries>();
    Session session{openFake(series)};
    ui::Ui state{session};
    Draw draw;
};

}  // namespace

TEST_CASE("A field that the data lack has words where the others have a slider, until unfolded") {
    Panel panel;
    CHECK(ui::placeOf("cloud.mixing_scale").has_value());
    CHECK_FALSE(ui::placeOf("snow.mixing_scale").has_value());
    panel.click("snow.fold", 0.02f);
    panel.frame();
    CHECK(ui::placeOf("snow.mixing_scale").has_value());
    CHECK(ui::placeOf("snow.phase_plot").has_value());
    CHECK((panel.look() == Look{}));
}

TEST_CASE("A double click on a field's name puts its mixing scale back to the preset's") {
    Panel panel;
    panel.session.presetLook.of(Species::cloud).mixingScale = 0.25f;
    panel.look().of(Species::cloud).mixingScale = 40.0f;
    panel.look().of(Species::cloud).visible = false;
    panel.click("cloud.mixing_scale:label");
    CHECK(panel.look().of(Species::cloud).mixingScale == 40.0f);  // one click does nothing
    for (int i = 0; i < 10; ++i) panel.frame();
    panel.click("cloud.mixing_scale:label");
    panel.press(true);
    panel.press(false);
    CHECK(panel.look().of(Species::cloud).mixingScale == 0.25f);
    CHECK_FALSE(panel.look().of(Species::cloud).visible);
    CHECK(panel.look().of(Species::rain).mixingScale == 1.0f);
}

TEST_CASE("Several fields are unfolded at once") {
    Panel panel;
    panel.click("rain.fold", 0.02f);
    panel.frame();
    CHECK(ui::placeOf("rain.albedo").has_value());
    panel.click("cloud.fold", 0.02f);  // above it
    panel.frame();
    CHECK(ui::placeOf("cloud.albedo").has_value());
    CHECK(ui::placeOf("rain.albedo").has_value());
}

TEST_CASE("The eye hides a field; solo shows one alone, and again those before, a step each") {
    Panel panel;
    panel.click("snow.visible");
    CHECK_FALSE(panel.look().of(Species::snow).visible);
    const Look before = panel.look();
    panel.click("cloud.solo");
    for (int s = 0; s < kSpeciesCount; ++s) {
        CHECK(panel.look().species[static_cast<std::size_t>(s)].visible == (s == 0));
    }
    panel.click("rain.solo");  // goes over to another
    CHECK(ui::isSolo(panel.look(), Species::rain));
    panel.click("rain.solo");
    CHECK((panel.look() == before));
    CHECK(panel.session.history.steps() == std::vector<std::string>{"Snow: Visible on -> off",
                                                                    "Cloud alone", "Rain alone",
                                                                    "All fields as before"});
    panel.session.jumpTo(2);
    CHECK(ui::isSolo(panel.look(), Species::cloud));
    panel.session.undo();
    CHECK((panel.look() == before));
}

TEST_CASE("Linked fields follow a drag by its factor, there and back, in one step") {
    Panel panel;
    panel.look().of(Species::rain).mixingScale = 40.0f;
    panel.session.history.commit(panel.session.document);
    const Look before = panel.look();
    panel.click("fields.link:liquid");
    panel.moveTo("cloud.mixing_scale", 0.2f);
    panel.press(true);
    panel.moveTo("cloud.mixing_scale", 0.99f);  // beyond the bound of rain
    CHECK(panel.look().of(Species::rain).mixingScale == 100.0f);
    panel.moveTo("cloud.mixing_scale", 0.5f);
    panel.press(false);
    const double factor = static_cast<double>(panel.look().of(Species::cloud).mixingScale);
    CHECK(factor < 1.0);
    CHECK(static_cast<double>(panel.look().of(Species::rain).mixingScale) ==
          Approx(40.0 * factor).epsilon(1e-4));
    CHECK(panel.look().of(Species::ice).mixingScale == 1.0f);
    CHECK(panel.session.history.undoLabel() == "Cloud, Rain: Mixing scale");
    panel.session.undo();
    CHECK((panel.look() == before));
}

TEST_CASE("What is linked goes over to the group and to no other, what is a field's own does not") {
    const Look before;
    Look look;
    look.of(Species::ice).phase.kind = PhaseKind::solidColumn;
    look.of(Species::ice).effectiveRadiusM *= 0.5f;
    look.of(Species::ice).densityKgPerM3 = 500.0f;
    look.of(Species::ice).colour = glm::vec3(0.5f);
    look.of(Species::ice).visible = false;
    ui::follow(look, before, before, Species::ice);
    for (const Species s : {Species::snow, Species::graupel, Species::hail}) {
        SpeciesLook wanted = before.of(s);
        wanted.phase.kind = PhaseKind::solidColumn;
        wanted.effectiveRadiusM *= 0.5f;
        CHECK((look.of(s) == wanted));
    }
    for (const Species s : {Species::cloud, Species::rain}) CHECK((look.of(s) == before.of(s)));
    // From zero there is no factor.
    Look zero = before;
    zero.of(Species::cloud).mixingScale = 0.0f;
    Look more = zero;
    more.of(Species::cloud).mixingScale = 0.3f;
    ui::follow(more, zero, zero, Species::cloud);
    CHECK(more.of(Species::rain).mixingScale == 0.3f);
}

TEST_CASE("The angle on the phase plot is 0 looking into the sun and 180 degrees with it behind") {
    Document document;
    document.camera.azimuthDeg = 180.0f;  // the eye stands in the south and looks north
    document.camera.elevationDeg = 0.0f;
    const auto angleDeg = [&](float azimuth, float elevation) {
        document.look.sunAzimuthDeg = azimuth;
        document.look.sunElevationDeg = elevation;
        return glm::degrees(ui::scatteringAngle(document, {}));
    };
    CHECK(angleDeg(0.0f, 0.0f) == Approx(0.0));
    CHECK(angleDeg(180.0f, 0.0f) == Approx(180.0));
    CHECK(angleDeg(90.0f, 0.0f) == Approx(90.0));
    CHECK(angleDeg(0.0f, 60.0f) == Approx(60.0));
}

TEST_CASE("A curve is computed when its phase function changes, droplets beside the panels") {
    ui::FieldsState state;
    Look look;
    const ui::PhaseCurve::Made* curve = ui::curveOf(state, look, Species::ice);
    REQUIRE((curve != nullptr));
    CHECK((curve->table == makePhaseTable(look.of(Species::ice).phase)));
    CHECK(ui::curveOf(state, look, Species::ice) == curve);
    look.of(Species::cloud).phase.radiusM = 2e-6f;
    for (int i = 0; i < 30000 && ui::curveOf(state, look, Species::cloud) == nullptr; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    curve = ui::curveOf(state, look, Species::cloud);
    REQUIRE((curve != nullptr));
    CHECK(curve->spec.radiusM == 2e-6f);
    CHECK(curve->asymmetry == phaseAsymmetry(look.of(Species::cloud).phase));
}

TEST_CASE("The depth along the view is that of what is shown, and follows look and camera") {
    Panel panel;
    // Straight down on the cloud of 1 g/m³ and 10 µm, 500 m deep in its layer: 150 m²/kg, 75, less
    // what the layer gives the one above it between their centres, and gets: as much.
    panel.session.document.camera.target = {0.45f, 0.5f, 0.1f};
    panel.session.document.camera.elevationDeg = 89.9f;
    const auto total = [&] { return ui::probeDepth(panel.state.fields, panel.session)->total(); };
    const double one = total();
    CHECK(one == Approx(75.0).epsilon(0.02));
    panel.look().of(Species::cloud).mixingScale = 2.0f;
    CHECK(total() == Approx(2.0 * one));
    panel.session.document.camera.target.x = 0.05f;  // beside it
    CHECK(total() == Approx(0.0));
}

TEST_CASE("A histogram has both axes labelled, with units, and counts every cell in its range") {
    FieldHistogram histogram;
    CHECK(ui::histogramFigure(histogram).curves.empty());
    histogram.holding = Holding::content;
    for (int i = 0; i < 1000; ++i) histogram.add(2e-4f);
    histogram.add(3e-3f);
    const plot::Figure figure = ui::histogramFigure(histogram);
    CHECK(figure.x.label == "Mass content, g/m\u00b3");
    CHECK(figure.y.label == "Cells");
    CHECK(figure.x.logarithmic);
    CHECK(figure.y.logarithmic);
    CHECK(figure.x.from == Approx(0.1));  // whole decades around 0.2 and 3 g/m³
    CHECK(figure.x.to == Approx(10.0));
    CHECK(figure.y.to == Approx(1e4));
    REQUIRE(figure.curves.size() == 1);
    const auto countAt = [&](double gPerM3) {
        const auto& points = figure.curves.front().points;
        for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
            if (points[i].x <= gPerM3 && gPerM3 < points[i + 1].x) return points[i].y;
        }
        return -1.0;
    };
    CHECK(countAt(0.2) == 1000.0);
    CHECK(countAt(3.0) == 1.0);
    CHECK(countAt(1.0) < 1.0);  // none, below the first tick
}

TEST_CASE("Field colours change to those that the colour-blind can tell, and back to table 2") {
    Panel panel;
    CHECK(ui::runAction(panel.state, "edit.accessible_colours"));
    CHECK(hasFieldColours(panel.look(), FieldColours::accessible));
    // Blue of Okabe and Ito is (0, 114, 178) of 255 in sRGB.
    const glm::dvec3 srgb(srgbFromLinear(panel.look().of(Species::rain).colour) * 255.0f);
    CHECK(srgb.g == Approx(114.0).epsilon(1e-4));
    CHECK(srgb.b == Approx(178.0).epsilon(1e-4));
    CHECK(panel.session.history.undoLabel() == "Colour-blind-safe field colours");
    CHECK(ui::runAction(panel.state, "edit.accessible_colours"));
    CHECK((panel.look() == Look{}));
}

TEST_CASE("A click in the list of steps goes there") {
    Panel panel(drawHistory);
    for (const float ev : {1.0f, 2.0f, 3.0f}) {
        panel.look().exposureEv = ev;
        panel.session.history.commit(panel.session.document);
    }
    CHECK(ui::runAction(panel.state, "edit.history"));
    panel.frame();
    panel.frame();
    panel.click("history:1");
    CHECK(panel.look().exposureEv == 1.0f);
    panel.click("history:3");
    CHECK(panel.look().exposureEv == 3.0f);
    panel.click("history:0");
    CHECK((panel.look() == Look{}));
    CHECK(panel.session.history.steps().size() == 3);
}

TEST_CASE("A parameter is found by part of its label, id or help, of any field") {
    Panel panel(drawFind);
    panel.state.fields.find = "snow albedo";
    panel.frame();
    CHECK(ui::placeOf("snow.albedo").has_value());
    CHECK_FALSE(ui::placeOf("rain.albedo").has_value());
    panel.state.fields.find = "2^EV";
    panel.frame();
    CHECK(ui::placeOf("view.exposure").has_value());
    CHECK_FALSE(ui::placeOf("snow.albedo").has_value());
    panel.click("find.clear");
    CHECK(panel.state.fields.find.empty());
}

TEST_CASE("Below a haze that follows the humidity stands what it comes to") {
    Panel panel([](ui::Ui& ui) { ui::drawGroups(ui::contextOf(ui)); });
    panel.look().skyModel = SkyModel::atmosphere;
    panel.frame();
    CHECK_FALSE(ui::placeOf("sky.haze_text").has_value());
    panel.look().haze = Haze::humidity;
    panel.frame();
    CHECK(ui::placeOf("sky.haze_text").has_value());
    CHECK(ui::placeOf("sky.visibility").has_value());
    panel.look().haze = Haze::aerosol;
    panel.frame();
    CHECK(ui::placeOf("sky.haze_text").has_value());
    panel.look().skyModel = SkyModel::gradient;
    panel.frame();
    CHECK_FALSE(ui::placeOf("sky.haze_text").has_value());
}
