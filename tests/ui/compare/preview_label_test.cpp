// preview_label_test.cpp: what is on screen of a denoised preview, and when it can be had.
#include "app/ui/compare/preview_label.h"

#include <doctest/doctest.h>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/widgets/places.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// Vertices of what is drawn over the image.
int drawnOver(Headless& gui, ui::Ui& state) {
    gui.frame([&] { ui::draw(state); });
    return ImGui::GetBackgroundDrawList()->VtxBuffer.Size;
}

}  // namespace

TEST_CASE("The denoised preview is a setting that can be had where there is an image of paths") {
    Session session(noReaders());
    ui::Ui state(session);
    const ui::Action& action = *ui::findAction("compare.preview");
    CHECK_FALSE(ui::runChord(state, action.chord));
    CHECK_FALSE(state.settings.denoisedPreview);
    CHECK(contains(ui::helpOf(action, state), "Needs an image of the reference"));
    state.previews.possible[1] = true;  // beside an image of another engine
    CHECK_FALSE(contains(ui::helpOf(action, state), "Needs"));
    CHECK(ui::runChord(state, action.chord));
    CHECK(state.settings.denoisedPreview);
    CHECK(ui::isChecked(action, state));
    CHECK(ui::runAction(state, "compare.preview"));
    CHECK_FALSE(state.settings.denoisedPreview);
}

TEST_CASE("The status line says that a preview is shown, as long as one is") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    ui::wantPlaces(true);
    state.settings.denoisedPreview = true;  // but there is none yet
    for (const int samples : {0, 16, 0}) {
        state.report.previewSamples = samples;
        ui::clearPlaces();
        gui.frame([&] { ui::draw(state); });
        CHECK(ui::placeOf("status.preview").has_value() == (samples > 0));
    }
    ui::wantPlaces(false);
}

TEST_CASE("The image that is a preview is labelled, wherever it is, and no other") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.previews.samples[1] = 4;
    const int bare = drawnOver(gui, state);
    state.previews.samples[0] = 16;
    CHECK(drawnOver(gui, state) > bare);
    state.previews.samples = {0, 4};
    state.compare.second = true;
    state.compare.active = 1;
    const int labelled = drawnOver(gui, state);
    state.previews.samples = {16, 0};
    CHECK(drawnOver(gui, state) < labelled);
    state.compare.mode = CompareMode::split;
    const int ofA = drawnOver(gui, state);
    state.previews.samples = {16, 4};
    CHECK(drawnOver(gui, state) > ofA);
    state.compare.mode = CompareMode::error;  // once there are colours in the place of the images
    state.errors.texture = 1;
    const int covered = drawnOver(gui, state);
    state.previews.samples = {0, 0};
    CHECK(drawnOver(gui, state) == covered);
}
