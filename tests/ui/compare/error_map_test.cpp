// error_map_test.cpp: what is on screen of a measured error.
#include "app/ui/compare/error_map.h"

#include <doctest/doctest.h>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/widgets/places.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

MeasuredError measured() {
    MeasuredError error;
    error.errors.relRmse = 0.03;
    error.errors.relRmseSigma = 0.004;
    error.sizePx = {2, 1};
    error.paths = 8;
    return error;
}

}  // namespace

TEST_CASE("A map has a scale of both signs that what is grey does not shrink") {
    std::vector<float> errors(1000, 0.0f);
    errors[0] = -0.3f;
    errors[1] = 0.4f;
    const ui::ErrorMap map = ui::errorMapOf({100, 10}, errors);
    CHECK(map.scale.bothSigns);
    CHECK(map.scale.most == doctest::Approx(0.5));
    CHECK(map.colours.size == glm::ivec2(100, 10));
    const auto& rgba = map.colours.rgba;
    CHECK(rgba[0] < rgba[2]);    // too dark: blue
    CHECK(rgba[4] > rgba[6]);    // too bright: red
    CHECK(rgba[8] == rgba[10]);  // grey
    CHECK(ui::errorMapOf({2, 1}, std::vector<float>(2, 0.0f)).scale.most > 0.0);
}

TEST_CASE("The status line has the error once there is one, or while it is being measured") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    ui::wantPlaces(true);
    const auto isSaid = [&] {
        ui::clearPlaces();
        gui.frame([&] { ui::draw(state); });
        return ui::placeOf("status.error").has_value();
    };
    CHECK_FALSE(isSaid());
    state.report.measuring = true;
    CHECK(isSaid());
    state.report.measuring = false;
    state.report.error = measured();
    CHECK(isSaid());
    ui::wantPlaces(false);
}

TEST_CASE("The map is a texture while it is shown, of the newest error, and of one image alone") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    unsigned made = 0;
    std::vector<unsigned> dropped;
    state.services.showImage = [&](const Image8& image) {
        return ui::LoadedImage{++made, image.size};
    };
    state.services.dropImage = [&](unsigned texture) { dropped.push_back(texture); };
    state.report.error = measured();
    const auto found = [] {
        return std::make_shared<const ui::ErrorMap>(
            ui::errorMapOf({2, 1}, std::vector<float>{0.1f, -0.1f}));
    };
    const auto frame = [&] { gui.frame([&] { ui::draw(state); }); };
    state.errorMeter.found = found();
    frame();
    CHECK(made == 0);  // nobody wants it
    REQUIRE(ui::runAction(state, "compare.error_map"));
    state.errorMeter.found = found();
    frame();
    frame();
    CHECK(made == 1);
    state.errorMeter.found = found();
    frame();
    CHECK(made == 2);
    CHECK(dropped == std::vector<unsigned>{1});
    REQUIRE(ui::runAction(state, "compare.error_map"));
    frame();
    CHECK(state.errorMeter.texture == 0);
    CHECK(dropped.size() == 2);
}

TEST_CASE(
    "The reference has no error to measure, and at rest it is measured as asked or as usual") {
    Session session(noReaders());
    ui::Ui state(session);
    REQUIRE(ui::runAction(state, "compare.measure"));
    CHECK(state.errorMeter.toggled);
    session.document.look.engine = groundTruth();
    CHECK_FALSE(ui::runAction(state, "compare.measure"));
    CHECK_FALSE(ui::runAction(state, "compare.error_map"));
    CHECK_FALSE(state.errorMeter.atRest(state.settings));
    state.errorMeter.atRestByDefault = true;
    CHECK(state.errorMeter.atRest(state.settings));
    REQUIRE(ui::runAction(state, "compare.measure_at_rest"));
    CHECK(state.settings.measureAtRest == false);
    CHECK_FALSE(state.errorMeter.atRest(state.settings));
}
