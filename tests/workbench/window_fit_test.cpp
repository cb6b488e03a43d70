// window_fit_test.cpp: windows on the screens of laptops, with panels and frames.
#include "app/workbench/window_fit.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

// 1366 x 768 with a bar of 28 pixels at the top; a title of 37 and borders of 1.
constexpr ScreenBox kLaptop{{0, 28}, {1366, 740}};
constexpr WindowFrame kFrame{{1, 37}, {1, 1}};

bool within(const ScreenBox& window, const ScreenBox& area, const WindowFrame& frame) {
    const glm::ivec2 from = window.at - frame.before;
    const glm::ivec2 to = window.at + window.size + frame.after;
    return from.x >= area.at.x && from.y >= area.at.y && to.x <= area.at.x + area.size.x &&
           to.y <= area.at.y + area.size.y;
}

}  // namespace

TEST_CASE("A window that is larger than the screen is cut to fit, title and all") {
    const ScreenBox window = fitOn(kLaptop, {{43, 24}, {1280, 720}}, kFrame);
    CHECK(window.size == glm::ivec2(1280, 702));
    CHECK(within(window, kLaptop, kFrame));
    CHECK(fitOn(kLaptop, {{0, 0}, {2560, 1440}}, kFrame).size == glm::ivec2(1364, 702));
}

TEST_CASE("A window that fits stays where it is") {
    const ScreenBox fits{{100, 80}, {1200, 600}};
    CHECK(fitOn(kLaptop, fits, kFrame) == fits);
}

TEST_CASE("A window beyond an edge is brought back, also from a screen that is gone") {
    for (const glm::ivec2 at : {glm::ivec2(-300, -50), glm::ivec2(3000, 400), glm::ivec2(200, 700),
                                glm::ivec2(-5000, 9000)}) {
        const ScreenBox window = fitOn(kLaptop, {at, {1000, 640}}, kFrame);
        CHECK(window.size == glm::ivec2(1000, 640));
        CHECK(within(window, kLaptop, kFrame));
    }
    // On the second of two screens.
    const ScreenBox right{{1366, 0}, {1024, 768}};
    CHECK(within(fitOn(right, {{1300, 10}, {1280, 720}}, kFrame), right, kFrame));
}

TEST_CASE("The least size yields to a small screen") {
    CHECK(leastOn(kLaptop, {960, 600}, kFrame) == glm::ivec2(960, 600));
    CHECK(leastOn({{0, 0}, {800, 600}}, {960, 600}, kFrame) == glm::ivec2(798, 562));
    CHECK(leastOn({{0, 0}, {0, 0}}, {960, 600}, kFrame) == glm::ivec2(1, 1));
}

TEST_CASE("The screen of a window is the one it shares most with") {
    const ScreenBox window{{1200, 100}, {400, 300}};
    CHECK(sharedArea(window, {{0, 0}, {1366, 768}}) == 166 * 300);
    CHECK(sharedArea(window, {{1366, 0}, {1024, 768}}) == 234 * 300);
    CHECK(sharedArea(window, {{5000, 0}, {100, 100}}) == 0);
}
