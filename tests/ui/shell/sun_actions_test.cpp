// sun_actions_test.cpp: the sun in the panel, by date and by its three buttons.
#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <thread>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/widgets/places.h"
#include "core/geo/map_place.h"
#include "core/look/sun.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// A grid of 8 km whose middle is at Brasilia, and times from 2010-03-15 12:10 UTC on.
std::shared_ptr<FakeSeries> brasilia() {
    auto series = std::make_shared<FakeSeries>();
    series->map = {.projection = "+proj=merc +lon_0=-47.882778 +R=6370000"};
    const auto middle = MapPlace(series->map).positionM({-15.793889, -47.882778});
    REQUIRE(middle);
    series->map.originM = *middle - 4000.0;
    series->firstUtc = utcOfText("2010-03-15T12:10:00Z");
    return series;
}

void openAndShow(Session& session, int time) {
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, time);
    REQUIRE(waitUntilShown(session));
}

}  // namespace

TEST_CASE("What is shown has the place of its middle and the date of its time") {
    Session session(openFake(brasilia()));
    CHECK_FALSE(session.where().place);
    openAndShow(session, 2);
    REQUIRE(session.where().place);
    CHECK(session.where().place->geo.latitudeDeg == doctest::Approx(-15.793889));
    CHECK(utcText(session.where().utc.value()) == "2010-03-15T12:30:00Z");
    // Azimuth 76.249630, zenith angle 44.139862 degrees by NREL's SPA [Reda04].
    session.document.look.sunSource = SunSource::date;
    const SunState sun = sunStateOf(session.document.look, session.where());
    CHECK(std::abs(sun.azimuthDeg - 76.2496f) < 0.01f);
    CHECK(std::abs(sun.elevationDeg - (90.0f - 44.1399f)) < 0.01f);
}

TEST_CASE("A region that is shown has the place of its own middle") {
    Session session(openFake(brasilia()));
    openAndShow(session, 0);
    const double whole = session.where().place.value().geo.longitudeDeg;
    session.setRegion(BoxM{{0.0, 0.0, 0.0}, {2000.0, 8000.0, 2000.0}});
    for (int i = 0; i < 10000 && session.shown()->grid.size.x == 8; ++i) {
        session.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const double middle = session.shown()->grid.originM.x + 0.5 * session.shown()->grid.extentM().x;
    // On Mercator's map a metre is a metre of the equator.
    CHECK(session.where().place.value().geo.longitudeDeg - whole ==
          doctest::Approx(glm::degrees((middle - 4000.0) / 6370000.0)).epsilon(1e-3));
}

TEST_CASE("The panel says which of date and place the data state, and its buttons move the sun") {
    Headless gui;
    Session session(openFake(brasilia()));
    openAndShow(session, 2);
    ui::Ui state(session);
    ui::wantPlaces(true);
    const auto frame = [&] {
        ui::clearPlaces();
        gui.frame([&] { ui::draw(state); });
    };
    Look& look = session.document.look;
    for (int i = 0; i < 3; ++i) frame();
    CHECK_FALSE(ui::placeOf("sun.date_text").has_value());
    look.sunSource = SunSource::date;
    const Document before = session.document;
    for (int i = 0; i < 3; ++i) frame();
    CHECK(session.document == before);
    CHECK(ui::placeOf("sun.date_text").has_value());
    CHECK(ui::placeOf("sun.place_text").has_value());
    CHECK(ui::placeOf("sun.noon").has_value());

    CHECK(ui::runAction(state, "sun.golden_hour"));
    CHECK(look.sunSource == SunSource::angles);
    CHECK(std::abs(look.sunAzimuthDeg - 76.2496f) < 0.01f);
    CHECK(look.sunElevationDeg == 6.0f);
    CHECK(ui::runAction(state, "sun.noon"));
    CHECK(look.sunAzimuthDeg == 180.0f);
    session.document.camera.azimuthDeg = 200.0f;
    CHECK(ui::runAction(state, "sun.backlit"));
    CHECK(look.sunAzimuthDeg == 20.0f);
    CHECK(look.sunElevationDeg == 10.0f);
    ui::wantPlaces(false);
}
