// compare_test.cpp: images alternately, when figures of two images are computed, and what they
// are.
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "app/ui/compare/compare.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

using Clock = ui::CompareErrors::Clock;

/// A ramp of grey, times `gain`.
ImageF ramp(float gain) {
    ImageF image;
    image.size = {16, 8};
    for (int i = 0; i < 16 * 8; ++i) {
        const float grey = gain * static_cast<float>(1 + i % 16) / 16.0f;
        image.pixels.emplace_back(grey, grey, grey, 1.0f);
    }
    return image;
}

ui::PairState images(std::uint64_t a, std::uint64_t b, int pathsOfB, bool settled = false) {
    ui::PairState state;
    state.a = a;
    state.b = b;
    state.whole = true;
    state.settled = settled;
    state.traced = ReferenceProgress{.samples = pathsOfB};
    return state;
}

void finish(ui::CompareErrors& errors, Clock::time_point at) {
    while (!errors.poll(at)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

TEST_CASE("An image a tenth brighter than its reference has those figures and one colour") {
    const ui::PairFigures figures = ui::figuresOf({ramp(1.1f), ramp(1.0f), {}, {}});
    CHECK(figures.errors.bias == doctest::Approx(0.1).epsilon(1e-5));
    // sqrt(mean (r/10)^2) / mean r of 1/16 to 1: 0.1 sqrt(93.5) / 8.5
    CHECK(figures.errors.relRmse == doctest::Approx(0.11376).epsilon(1e-4));
    CHECK(figures.errors.p95 == doctest::Approx(0.1).epsilon(1e-5));
    CHECK(figures.flip > 0.0);
    CHECK(figures.scale.bothSigns);
    CHECK(figures.colours.size == glm::ivec2(16, 8));
    REQUIRE(figures.colours.rgba.size() == std::size_t{4 * 16 * 8});
    for (std::size_t i = 0; i < figures.colours.rgba.size(); i += 4) {
        CHECK(figures.colours.rgba[i] > figures.colours.rgba[i + 2]);  // too bright: red
    }
}

TEST_CASE("Noise that the halves of the reference tell of is subtracted the figures") {
    ui::LinearPair pair{ramp(1.0f), ramp(1.0f), {}, {ramp(1.0f), ramp(1.0f)}};
    for (std::size_t i = 0; i < pair.b.pixels.size(); ++i) {
        const float noise = i % 2 == 0 ? 0.02f : -0.02f;
        pair.halvesB[0].pixels[i] += glm::vec4(glm::vec3(noise), 0.0f);
        pair.halvesB[1].pixels[i] += glm::vec4(glm::vec3(i % 4 < 2 ? noise : -noise), 0.0f);
        pair.b.pixels[i] = (pair.halvesB[0].pixels[i] + pair.halvesB[1].pixels[i]) / 2.0f;
    }
    const ImageErrors errors = ui::figuresOf(pair).errors;
    CHECK(errors.noise > 0.01);
    CHECK(errors.relRmse < 0.5 * errors.relRmseRaw);
}

TEST_CASE("Figures wait for whole images, for an even number of paths, and two seconds") {
    ui::CompareErrors errors;
    const Clock::time_point start = Clock::now();
    const auto later = [&](double seconds) {
        return start + std::chrono::milliseconds(static_cast<int>(1e3 * seconds));
    };
    ui::PairState drafts = images(1, 1, 2);
    drafts.whole = false;
    CHECK_FALSE(errors.wants(drafts, start));
    CHECK_FALSE(errors.wants(images(1, 1, 1), start));
    REQUIRE(errors.wants(images(1, 2, 2), start));
    errors.start({ramp(1.1f), ramp(1.0f), {}, {}}, start);
    finish(errors, later(0.1));
    REQUIRE(errors.current());
    CHECK_FALSE(errors.wants(images(1, 2, 2), later(60.0)));  // nothing new
    CHECK_FALSE(errors.wants(images(1, 4, 4), later(1.0)));
    CHECK(errors.wants(images(1, 4, 4), later(2.2)));
    CHECK_FALSE(errors.wants(images(1, 5, 5), later(2.2)));
    CHECK(errors.current());                                 // with fewer paths
    CHECK(errors.wants(images(1, 5, 5, true), later(0.2)));  // the last there will be
    errors.wants(images(2, 5, 5), later(0.3));
    CHECK_FALSE(errors.current());  // A has become another image
}

TEST_CASE("Figures that take long are computed less often: a quarter of the time at most") {
    ui::CompareErrors errors;
    const Clock::time_point start = Clock::now();
    REQUIRE(errors.wants(images(1, 2, 2), start));
    errors.start({ramp(1.1f), ramp(1.0f), {}, {}}, start);
    finish(errors, start + std::chrono::seconds(10));
    CHECK_FALSE(errors.wants(images(1, 4, 4), start + std::chrono::seconds(39)));
    CHECK(errors.wants(images(1, 4, 4), start + std::chrono::seconds(41)));
}

TEST_CASE("What cannot be compared is told in words") {
    ui::CompareErrors errors;
    REQUIRE(errors.wants(images(1, 2, 2), Clock::now()));
    errors.start({ramp(1.0f), ramp(0.0f), {}, {}}, Clock::now());
    finish(errors, Clock::now());
    CHECK_FALSE(errors.figures());
    CHECK_FALSE(errors.fault().empty());
}

TEST_CASE("In turns each image is seen for half a second, and nothing counts as moving") {
    Headless gui;
    Session session(noReaders());
    ui::Ui ui(session);
    ui.compare.second = true;
    REQUIRE(ui::runAction(ui, "compare.flicker"));
    int ofB = 0;
    for (int i = 0; i < 40; ++i) {
        ui.next.againS = 10.0;
        gui.frame([&] { drawCompare(contextOf(ui), ui.compare, ui.errors); });
        ofB += ui.compare.flickered;
        CHECK(ui.next.againS > 0.0);
        CHECK(ui.next.againS <= 0.5);
    }
    CHECK(ofB >= 19);
    CHECK(ofB <= 21);
    CHECK_FALSE(ui.next.animates);
    REQUIRE(ui::runAction(ui, "compare.flicker"));
    CHECK(ui.compare.mode == CompareMode::single);
}

TEST_CASE("The reference is offered for anything but the reference alone") {
    Session session(noReaders());
    ui::Ui ui(session);
    CHECK(ui::runAction(ui, "compare.reference"));
    CHECK(ui.compare.trace);
    session.document.look.engine = Engine::reference;
    CHECK_FALSE(ui::runAction(ui, "compare.reference"));
    ui.compare.second = true;
    CHECK(ui::runAction(ui, "compare.reference"));
}

TEST_CASE("Error image and figures fit into the window, with figures and before") {
    Headless gui;
    Session session(noReaders());
    ui::Ui ui(session);
    ui.compare.second = ui.compare.figures = true;
    REQUIRE(ui::runAction(ui, "compare.error"));
    int textures = 0;
    ui.services.showImage = [&](const Image8& image) {
        ++textures;
        return ui::LoadedImage{7, image.size};
    };
    gui.frame([&] { drawCompare(contextOf(ui), ui.compare, ui.errors); });
    CHECK(textures == 0);
    REQUIRE(ui.errors.wants(images(1, 2, 2), Clock::now()));
    ui.errors.start({ramp(1.1f), ramp(1.0f), {}, {}}, Clock::now());
    for (int i = 0; i < 5000 && textures == 0; ++i) {
        gui.frame([&] { drawCompare(contextOf(ui), ui.compare, ui.errors); });
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(textures == 1);
    CHECK(ui.errors.texture == 7);
}
