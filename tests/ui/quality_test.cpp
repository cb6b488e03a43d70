// quality_test.cpp: how finely made-up machines, slow and fast, get to draw.
#include "app/ui/quality.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

constexpr glm::ivec2 kWindowPx{1280, 720};
constexpr int kPlanes = 256;

/// A machine whose frames cost a part that shrinks with the work and one that does not.
struct Machine {
    double fullMs, fixedMs;
    double frameMs(const ui::Draft& draft) const {
        return fixedMs +
               fullMs * draft.sizePx.x * draft.sizePx.y * draft.planes / (1280.0 * 720.0 * kPlanes);
    }
};

/// The frame that a long drag ends up with.
ui::Draft drag(ui::QualityControl& quality, const Machine& machine) {
    for (int i = 0; i < 30; ++i) {
        const ui::Draft draft = quality.draft(0.0, kWindowPx, kPlanes);
        quality.measured(draft, machine.frameMs(draft), kWindowPx, kPlanes);
    }
    return quality.draft(0.0, kWindowPx, kPlanes);
}

}  // namespace

TEST_CASE("In motion a frame comes to follow the hand, on slow machines and fast") {
    for (const Machine machine : {Machine{50.0, 1.0}, Machine{500.0, 5.0}, Machine{5000.0, 20.0}}) {
        CAPTURE(machine.fullMs);
        ui::QualityControl quality;
        CHECK(machine.frameMs(drag(quality, machine)) <= ui::kMotionMs);
    }
}

TEST_CASE("A fast machine draws in full all the time") {
    ui::QualityControl quality;
    const ui::Draft draft = drag(quality, {20.0, 1.0});
    CHECK(draft.sizePx == kWindowPx);
    CHECK(draft.planes == kPlanes);
    CHECK(draft.step == ui::kFullStep);
}

TEST_CASE("At rest the picture gets finer and ends in full") {
    ui::QualityControl quality;
    drag(quality, {6000.0, 10.0});
    int step = -1, pixels = 0;
    for (const double rest : {0.0, 0.3, 1.1, 8.1}) {
        const ui::Draft draft = quality.draft(rest, kWindowPx, kPlanes);
        CHECK(draft.step > step);
        CHECK(draft.sizePx.x >= pixels);
        step = draft.step;
        pixels = draft.sizePx.x;
    }
    CHECK(step == ui::kFullStep);
    CHECK(pixels == kWindowPx.x);
}

TEST_CASE("A picture that takes long is not begun after a short rest") {
    ui::QualityControl quality;
    const Machine machine{6000.0, 10.0};
    drag(quality, machine);
    CHECK(machine.frameMs(quality.draft(0.3, kWindowPx, kPlanes)) < 600.0);
    CHECK(machine.frameMs(quality.draft(1.1, kWindowPx, kPlanes)) < 2000.0);
}

TEST_CASE("Drafts stay within the window and the planes, whatever their size") {
    ui::QualityControl quality;
    drag(quality, {1e6, 1e4});
    for (const glm::ivec2 window : {glm::ivec2(1, 1), glm::ivec2(20, 4000), kWindowPx}) {
        const ui::Draft draft = quality.draft(0.0, window, 16);
        CHECK(draft.sizePx.x >= 1);
        CHECK(draft.sizePx.y >= 1);
        CHECK(draft.sizePx.x <= window.x);
        CHECK(draft.sizePx.y <= window.y);
        CHECK(draft.planes == 16);
    }
}

TEST_CASE("Preparation that is not repeated does not count against the refinement") {
    ui::QualityControl quality;
    const Machine machine{1000.0, 5.0};
    drag(quality, machine);
    const ui::Draft before = quality.draft(0.7, kWindowPx, kPlanes);
    const ui::Draft moving = quality.draft(0.0, kWindowPx, kPlanes);
    quality.measured(moving, 2000.0, kWindowPx, kPlanes, false);
    CHECK(quality.draft(0.7, kWindowPx, kPlanes) == before);
}
