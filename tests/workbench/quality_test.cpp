// quality_test.cpp: how finely made-up machines, slow and fast, get to draw.
#include "app/workbench/quality.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

constexpr glm::ivec2 kWindowPx{1280, 720};

/// A machine whose images cost a part that shrinks with the work and one that does not, and whose
/// panels cost something too.
struct Machine {
    double fullMs, fixedMs, panelsMs = 8.0;
    double imageMs(const ui::Draft& draft) const {
        return fixedMs + fullMs * draft.detail * draft.sizePx.x * draft.sizePx.y / (1280.0 * 720.0);
    }
};

/// The image that a long drag ends up with.
ui::Draft drag(ui::QualityControl& quality, const Machine& machine) {
    for (int i = 0; i < 30; ++i) {
        const ui::Draft draft = quality.draft(0.0, kWindowPx);
        quality.measured(draft, machine.imageMs(draft), kWindowPx);
        quality.measuredPanels(machine.panelsMs);
    }
    return quality.draft(0.0, kWindowPx);
}

}  // namespace

TEST_CASE("In motion there come to be 30 frames per second, panels and window included") {
    for (const Machine machine : {Machine{20.0, 1.0, 2.0}, Machine{500.0, 2.0, 5.0},
                                  Machine{700.0, 5.0, 15.0}, Machine{2000.0, 8.0, 8.0}}) {
        CAPTURE(machine.fullMs);
        ui::QualityControl quality;
        CHECK(machine.imageMs(drag(quality, machine)) + machine.panelsMs <= 1000.0 / 30.0);
    }
}

TEST_CASE("The time that panels leave is used: cheaper panels, a finer image") {
    ui::QualityControl slow, quick;
    const ui::Draft beside = drag(slow, {700.0, 2.0, 22.0});
    const ui::Draft alone = drag(quick, {700.0, 2.0, 1.0});
    CHECK(alone.sizePx.x > beside.sizePx.x);
    CHECK(alone.detail > beside.detail);
}

TEST_CASE(
    "A frame that the machine was late with changes nothing, and sizes do not go to and fro") {
    ui::QualityControl quality;
    const Machine machine{700.0, 4.0};
    const ui::Draft settled = drag(quality, machine);
    for (int i = 0; i < 200; ++i) {
        const ui::Draft draft = quality.draft(0.0, kWindowPx);
        CHECK(draft == settled);
        // Every seventh image takes four times as long, the others vary by a twentieth.
        const double late = i % 7 == 0 ? 4.0 : i % 2 == 0 ? 0.95 : 1.05;
        quality.measured(draft, late * machine.imageMs(draft), kWindowPx);
        quality.measuredPanels(machine.panelsMs);
    }
}

TEST_CASE("A machine that becomes slower while the mouse moves is followed within half a second") {
    ui::QualityControl quality;
    drag(quality, {200.0, 2.0});
    const Machine slower{1200.0, 2.0};
    double spentMs = 0.0;
    while (slower.imageMs(quality.draft(0.0, kWindowPx)) + slower.panelsMs > 1000.0 / 30.0) {
        const ui::Draft draft = quality.draft(0.0, kWindowPx);
        quality.measured(draft, slower.imageMs(draft), kWindowPx);
        spentMs += slower.imageMs(draft) + slower.panelsMs;
        REQUIRE(spentMs < 500.0);
    }
}

TEST_CASE("Images in motion have no side that is a power of two") {
    for (const double fullMs : {100.0, 300.0, 900.0, 2700.0, 8100.0}) {
        CAPTURE(fullMs);
        ui::QualityControl quality;
        const ui::Draft draft = drag(quality, {fullMs, 2.0});
        CHECK((draft.sizePx.x & (draft.sizePx.x - 1)) != 0);
        CHECK((draft.sizePx.y & (draft.sizePx.y - 1)) != 0);
    }
}

TEST_CASE("A fast machine draws in full all the time") {
    ui::QualityControl quality;
    CHECK(drag(quality, {15.0, 1.0}) == ui::Draft{kWindowPx, 1.0, ui::kFullStep});
}

TEST_CASE("A machine that draws the full image within 0.8 s shows it within one second") {
    ui::QualityControl quality;
    drag(quality, {700.0, 1.0});
    CHECK(quality.draft(0.0, kWindowPx).step == 0);
    CHECK(quality.draft(0.1, kWindowPx) == ui::Draft{kWindowPx, 1.0, ui::kFullStep});
}

TEST_CASE("What small images cost beside their work is learned from the first full one") {
    ui::QualityControl quality;
    const Machine machine{600.0, 8.0};
    drag(quality, machine);
    CHECK(quality.draft(0.1, kWindowPx).step == 1);
    const ui::Draft full{kWindowPx, 1.0, ui::kFullStep};
    quality.measured(full, machine.imageMs(full), kWindowPx);
    drag(quality, machine);
    CHECK(quality.draft(0.1, kWindowPx) == full);
}

TEST_CASE("On a slow machine the image gets finer at rest and ends in full") {
    ui::QualityControl quality;
    drag(quality, {6000.0, 2.0});
    int step = -1, pixels = 0;
    for (const double rest : {0.0, 0.3, 1.1, 8.1}) {
        const ui::Draft draft = quality.draft(rest, kWindowPx);
        CHECK(draft.step > step);
        CHECK(draft.sizePx.x >= pixels);
        step = draft.step;
        pixels = draft.sizePx.x;
    }
    CHECK(step == ui::kFullStep);
    CHECK(pixels == kWindowPx.x);
}

TEST_CASE("An image that takes long is not begun after a short rest") {
    ui::QualityControl quality;
    const Machine machine{6000.0, 10.0};
    drag(quality, machine);
    CHECK(machine.imageMs(quality.draft(0.3, kWindowPx)) < 500.0);
    CHECK(machine.imageMs(quality.draft(1.1, kWindowPx)) < 2000.0);
}

TEST_CASE("Drafts stay within the window and the planes, whatever their size") {
    ui::QualityControl quality;
    drag(quality, {1e6, 1e4});
    for (const glm::ivec2 window : {glm::ivec2(1, 1), glm::ivec2(20, 4000), kWindowPx}) {
        const ui::Draft draft = quality.draft(0.0, window);
        CHECK(draft.sizePx.x >= 1);
        CHECK(draft.sizePx.y >= 1);
        CHECK(draft.sizePx.x <= window.x);
        CHECK(draft.sizePx.y <= window.y);
        CHECK(ui::planesOf(draft, 16) == 16);
        CHECK(ui::planesOf(draft, 512) >= 24);
        CHECK(ui::planesOf(draft, 512) < 200);
    }
    CHECK(ui::planesOf({kWindowPx, 1.0, ui::kFullStep}, 512) == 512);
}

TEST_CASE("Where steps are not to be thinned any further, pixels are") {
    ui::QualityControl quality;
    const Machine machine{2000.0, 2.0};
    const ui::Draft even = drag(quality, machine);
    CHECK(even.detail < 0.5);
    const ui::Draft finer = quality.draft(0.0, kWindowPx, 0.5);
    CHECK(finer.detail == 0.5);
    CHECK(finer.sizePx.x < even.sizePx.x);
    CHECK(machine.imageMs(finer) + machine.panelsMs <= 1000.0 / 30.0);
}

TEST_CASE("A full image at rest is averaged with others until there are sixteen") {
    const ui::Draft full{kWindowPx, 1.0, ui::kFullStep};
    std::optional<ui::Draft> shown;
    int images = 0;
    while (const auto next = ui::nextDraft(shown, full, true)) {
        CHECK(next->sample == images);
        CHECK(next->sizePx == kWindowPx);
        shown = next;
        REQUIRE(++images <= 16);
    }
    CHECK(images == 16);
}

TEST_CASE("Nothing replaces an image at rest but a finer one") {
    const ui::Draft moving{{320, 180}, 0.25, 0}, finer{{640, 360}, 0.5, 1};
    const ui::Draft full{kWindowPx, 1.0, ui::kFullStep};
    CHECK(ui::nextDraft({}, moving, true) == moving);
    CHECK_FALSE(ui::nextDraft(moving, moving, true));
    CHECK(ui::nextDraft(moving, finer, true) == finer);
    CHECK_FALSE(ui::nextDraft(finer, moving, true));
    CHECK_FALSE(ui::nextDraft(full, moving, false));
    CHECK(ui::nextDraft(full, moving, true)->sizePx == kWindowPx);
}

TEST_CASE("Paths at rest: four times the pixels each, then one a pixel after the other") {
    const ui::Draft moving{{81, 45}, 1.0, 0};
    constexpr double kSlowMs = 100e3;
    const auto at = [&](const std::optional<ui::Draft>& shown, double restS, bool more = true) {
        return ui::nextTraced(shown, moving, kWindowPx, restS, kSlowMs, more);
    };
    std::optional<ui::Draft> shown = at({}, 0.0);
    CHECK(shown == moving);
    CHECK_FALSE(at(shown, 0.0));  // the user holds it
    for (const glm::ivec2 size : {glm::ivec2(162, 90), {324, 180}}) {
        shown = at(shown, 0.1);
        CHECK(shown == ui::Draft{size, 1.0, 1});
    }
    // Of 648 x 360 the full image is hardly four times as much.
    for (int sample = 0; sample < 3; ++sample) {
        shown = at(shown, 0.1);
        CHECK(shown == ui::Draft{kWindowPx, 1.0, ui::kFullStep, sample});
    }
    CHECK_FALSE(at(shown, 60.0, false));  // its error is small enough
}

TEST_CASE("Smaller images of paths have as many paths as asked for before there is a larger one") {
    const ui::Draft moving{{81, 45}, 1.0, 0};
    const auto after = [&](const ui::Draft& shown, double restS) {
        return ui::nextTraced(shown, moving, kWindowPx, restS, 100e3, true, 2);
    };
    CHECK_FALSE(after(moving, 0.0));  // the user holds it
    const ui::Draft second{{81, 45}, 1.0, 0, 1};
    CHECK(after(moving, 0.1) == second);
    CHECK(after(second, 0.1) == ui::Draft{{162, 90}, 1.0, 1});
    CHECK(after({{324, 180}, 1.0, 1}, 0.1) == ui::Draft{{324, 180}, 1.0, 1, 1});
    CHECK(after({{324, 180}, 1.0, 1, 1}, 0.1) == ui::Draft{kWindowPx, 1.0, ui::kFullStep});
    CHECK(after({kWindowPx, 1.0, ui::kFullStep}, 0.1) ==
          ui::Draft{kWindowPx, 1.0, ui::kFullStep, 1});
}

TEST_CASE("Where an image of paths is quick there is no smaller one before it") {
    const ui::Draft moving{{324, 180}, 1.0, 0};
    const ui::Draft full{kWindowPx, 1.0, ui::kFullStep};
    CHECK(ui::nextTraced(moving, moving, kWindowPx, 0.1, 500.0, true) == full);
    CHECK(ui::nextTraced({}, full, kWindowPx, 0.0, 20.0, true) == full);
}

TEST_CASE("In motion the first image of paths is as small as any, however slow they are") {
    for (const double fullMs : {1e2, 1e4, 1e6}) {
        CAPTURE(fullMs);
        ui::QualityControl quality(ui::kLeastShare);
        const double leastDetail = traitsOf(Engine::reference).leastDetail;
        const ui::Draft first = quality.draft(0.0, kWindowPx, leastDetail);
        CHECK(first.sizePx.x <= 81);  // a sixteenth of the width
        CHECK(first.detail == 1.0);
        const Machine machine{fullMs, 1.0};
        for (int i = 0; i < 40; ++i) {
            const ui::Draft draft = quality.draft(0.0, kWindowPx, leastDetail);
            quality.measured(draft, machine.imageMs(draft), kWindowPx);
        }
        const ui::Draft settled = quality.draft(0.0, kWindowPx, leastDetail);
        if (fullMs > 1e3) {
            CHECK(settled == first);
        } else {
            CHECK(settled.sizePx.x > 2 * first.sizePx.x);
        }
    }
}
