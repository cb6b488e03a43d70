// denoised_preview_test.cpp: when images of paths are denoised, and that what comes of it is what
// `denoised` makes.
#include "app/workbench/denoised_preview.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "core/image/denoise.h"

using namespace neph;

namespace {

using Clock = DenoisedPreview::Clock;
using std::chrono::milliseconds;

constexpr glm::ivec2 kTracedPx{40, 30};

std::array<ImageF, 2> halvesOf(glm::ivec2 sizePx = kTracedPx) {
    std::array<ImageF, 2> halves{ImageF{sizePx, {}}, ImageF{sizePx, {}}};
    for (int i = 0; i < sizePx.x * sizePx.y; ++i) {
        halves[0].pixels.emplace_back(0.5f + 0.1f * static_cast<float>(i % 3));
        halves[1].pixels.emplace_back(0.5f + 0.1f * static_cast<float>(i % 5));
    }
    return halves;
}

TracedImage after(int samples, bool last = false) {
    return {kTracedPx, samples, last};
}

DenoisedPreview::Made waitFor(DenoisedPreview& preview, Clock::time_point at) {
    for (;;) {
        if (auto made = preview.take(at)) return *made;
        std::this_thread::sleep_for(milliseconds(1));
    }
}

/// Denoises, which takes `took` by the clock that the test keeps; returns when it ended.
Clock::time_point denoiseFor(DenoisedPreview& preview, const TracedImage& of, Clock::time_point at,
                             milliseconds took) {
    preview.start(halvesOf(), of, at);
    CHECK_FALSE(preview.wants(after(1000, true), at));  // one at a time
    waitFor(preview, at + took);
    return at + took;
}

}  // namespace

TEST_CASE("One path per pixel has no halves, and halves are equally good after an even number") {
    const DenoisedPreview preview;
    const Clock::time_point now = Clock::now();
    CHECK_FALSE(preview.wants(after(0), now));
    CHECK_FALSE(preview.wants(after(1, true), now));
    CHECK(preview.wants(after(2), now));
    CHECK_FALSE(preview.wants(after(3), now));
    CHECK(preview.wants(after(3, true), now));
}

TEST_CASE("An image is denoised again with twice the paths, and once more at its end") {
    DenoisedPreview preview;
    Clock::time_point now = Clock::now();
    now = denoiseFor(preview, after(2), now, milliseconds(10)) + milliseconds(60000);
    CHECK_FALSE(preview.wants(after(2), now));
    CHECK(preview.wants(after(4), now));
    now = denoiseFor(preview, after(4), now, milliseconds(10)) + milliseconds(60000);
    CHECK_FALSE(preview.wants(after(6), now));
    CHECK(preview.wants(after(8), now));
    CHECK(preview.wants(after(5, true), now));
    now = denoiseFor(preview, after(5, true), now, milliseconds(10)) + milliseconds(60000);
    CHECK_FALSE(preview.wants(after(5, true), now));
}

TEST_CASE(
    "Previews of a size are half a second apart at least, and take a third of the time at most") {
    for (const int tookMs : {10, 900}) {
        CAPTURE(tookMs);
        DenoisedPreview preview;
        const Clock::time_point ended =
            denoiseFor(preview, after(2), Clock::now(), milliseconds(tookMs));
        const milliseconds pause(std::max(500, 2 * tookMs));
        CHECK_FALSE(preview.wants(after(64), ended + pause - milliseconds(1)));
        CHECK(preview.wants(after(64), ended + pause));
        CHECK(preview.wants(after(64, true), ended));  // nothing is left to do but that
    }
}

TEST_CASE("A preview is what the halves make, and says how many paths it is of") {
    std::atomic<int> woken = 0;
    DenoisedPreview preview([&woken] { ++woken; });
    const Clock::time_point now = Clock::now();
    preview.start(halvesOf(), after(8), now);
    const DenoisedPreview::Made made = waitFor(preview, now);
    CHECK(made.of.samples == 8);
    CHECK(made.of.sizePx == kTracedPx);
    const std::array<ImageF, 2> halves = halvesOf();
    CHECK((made.image.pixels == denoised(halves[0], halves[1]).pixels));
    CHECK(woken == 1);
    CHECK_FALSE(preview.take(now));
}

TEST_CASE("Nothing comes of what was forgotten, and the next image need not wait") {
    DenoisedPreview preview;
    const Clock::time_point now = Clock::now();
    preview.start(halvesOf(), after(64), now);
    preview.forget();
    CHECK_FALSE(preview.busy());
    CHECK(preview.wants(after(2), now));
    preview.start(halvesOf({20, 10}), {{20, 10}, 2, false}, now);
    CHECK(waitFor(preview, now).of.sizePx == glm::ivec2(20, 10));
}

TEST_CASE("A larger image is denoised with as few paths, and has but to leave time for paths") {
    DenoisedPreview preview;
    const Clock::time_point ended = denoiseFor(preview, after(2), Clock::now(), milliseconds(10));
    const TracedImage larger{2 * kTracedPx, 2, false};
    CHECK_FALSE(preview.wants(larger, ended + milliseconds(19)));
    CHECK(preview.wants(larger, ended + milliseconds(20)));
}

TEST_CASE("An image that begins again does not take the place of a better preview of it") {
    DenoisedPreview preview;
    Clock::time_point now = Clock::now();
    now = denoiseFor(preview, after(8), now, milliseconds(10)) + milliseconds(60000);
    CHECK_FALSE(preview.wants({kTracedPx / 2, 2, false}, now));
    CHECK_FALSE(preview.wants(after(2), now));
    CHECK_FALSE(preview.wants(after(8, true), now));
    CHECK(preview.wants(after(16), now));
}
