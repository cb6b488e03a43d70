// slot_preview_test.cpp: the denoised preview of a slot whose image is traced: what the screen has
// of it, and that nothing else has.
#include <doctest/doctest.h>

#include <thread>

#include "app/gl/context.h"
#include "app/workbench/slot.h"
#include "tests/core/fake_series.h"

using namespace neph;

namespace {

constexpr glm::ivec2 kPlacePx{16, 12};

/// A slot that shows made-up data as the reference draws them.
struct TracedSlot {
    Slot slot{openFake(std::make_shared<FakeSeries>()), [] {}};
    ui::Profile profile;

    TracedSlot() {
        restart();
        slot.session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        while (slot.session.shown() == nullptr) {
            slot.takeData();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// With an image that has yet to be drawn.
    void restart() {
        slot.session.document.look = {};
        slot.session.document.look.engine = groundTruth();
        slot.session.document.look.of(Species::cloud).mixingScale = 0.01f;  // short paths
        slot.session.document.sampling.targetError = 1e-6f;                 // never reached
        slot.updatePreview(false);
        slot.redraw();
    }
    void draw() {
        DrawRequest request;
        request.placePx = kPlacePx;
        request.preview = true;
        request.panels = [] { return 0.0; };
        request.yields = [] { return false; };
        slot.draw(request, profile);
    }
    void drawUntil(const auto& reached) {
        while (!reached()) draw();
    }
    bool full(int samples) const { return slot.whole() && slot.report.samples >= samples; }
    /// Until what is being denoised is shown.
    void denoise() {
        slot.updatePreview(true);
        while (slot.denoises()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            slot.updatePreview(true);
        }
    }
};

TracedSlot& tracedSlot() {
    static const gl::HeadlessContext context;
    static TracedSlot traced;
    traced.restart();
    return traced;
}

double worst(const ImageF& a, const ImageF& b) {
    REQUIRE(a.size == b.size);
    double most = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec4 d = glm::abs(a.pixels[i] - b.pixels[i]);
        most = std::max(most, static_cast<double>(std::max({d.x, d.y, d.z})));
    }
    return most;
}

/// Of the halves, which are of equally many paths.
ImageF meanOf(const ui::LinearHalves& halves) {
    ImageF mean = halves[0];
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        mean.pixels[i] = 0.5f * (mean.pixels[i] + halves[1].pixels[i]);
    }
    return mean;
}

}  // namespace

TEST_CASE("A preview is on the screen while more paths come, and what is compared never is one") {
    TracedSlot& traced = tracedSlot();
    Slot& slot = traced.slot;
    traced.drawUntil([&] { return traced.full(2); });
    const unsigned texture = slot.texture();
    CHECK(slot.canPreview());
    CHECK_FALSE(slot.updatePreview(false));
    CHECK(slot.texture() == texture);

    traced.denoise();
    CHECK(slot.report.previewSamples == 2);
    const unsigned preview = slot.texture();
    CHECK(preview != texture);
    CHECK(slot.textureSizePx() == kPlacePx);
    CHECK(worst(slot.linear(), meanOf(slot.halves())) < 1e-4);

    traced.drawUntil([&] { return traced.full(4); });
    CHECK(slot.texture() == preview);  // nobody has asked for another
    CHECK(slot.report.previewSamples == 2);
    CHECK(slot.report.reference.samples == 4);
    CHECK(worst(slot.linear(), meanOf(slot.halves())) < 1e-4);

    CHECK(slot.updatePreview(false));
    CHECK(slot.texture() == texture);
    CHECK(slot.report.previewSamples == 0);
}

TEST_CASE("A preview goes with the image it is of, and none of another camera comes after it") {
    TracedSlot& traced = tracedSlot();
    Slot& slot = traced.slot;
    traced.drawUntil([&] { return traced.full(2); });
    traced.denoise();
    REQUIRE(slot.report.previewSamples == 2);
    slot.session.document.camera.azimuthDeg += 30.0f;
    slot.noteChanges();
    traced.draw();
    CHECK(slot.report.previewSamples == 0);

    traced.drawUntil([&] { return slot.report.samples >= 2; });
    slot.updatePreview(true);
    REQUIRE(slot.denoises());
    slot.session.document.camera.azimuthDeg += 30.0f;
    CHECK_FALSE(slot.updatePreview(true));  // before the slot has looked, too
    slot.noteChanges();
    CHECK_FALSE(slot.denoises());
    traced.draw();
    CHECK_FALSE(slot.updatePreview(true));
    CHECK(slot.report.previewSamples == 0);
}

TEST_CASE("A preview that is made while the exposure changes has the new one") {
    TracedSlot& traced = tracedSlot();
    Slot& slot = traced.slot;
    traced.drawUntil([&] { return traced.full(2); });
    slot.updatePreview(true);
    slot.session.document.look.exposureEv += 1.0f;
    slot.noteChanges();
    CHECK(slot.denoises());
    traced.denoise();
    CHECK(slot.report.previewSamples == 2);
    traced.draw();  // the tones of the image itself
    CHECK(slot.report.previewSamples == 2);
}

TEST_CASE("An engine without halves has no preview") {
    TracedSlot& traced = tracedSlot();
    traced.slot.session.document.look.engine = Engine::slicing;
    traced.slot.noteChanges();
    traced.draw();
    CHECK_FALSE(traced.slot.canPreview());
    CHECK_FALSE(traced.slot.updatePreview(true));
    CHECK_FALSE(traced.slot.denoises());
}
