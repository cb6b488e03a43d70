// monkey_test.cpp: ten thousand random events on the panels; nothing may break, whatever is hit.
#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <random>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "tests/core/fake_series.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

constexpr int kEvents = 10000;
constexpr int kEventsAFrame = 5;

/// One random event; commands are carried out at once, as the workbench does between frames.
void event(std::mt19937& random, ui::Ui& state) {
    const auto draw = [&random](int count) {
        return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    ImGuiIO& io = ImGui::GetIO();
    switch (draw(9)) {
        case 0:
        case 1:
            io.MousePos = {static_cast<float>(draw(1300) - 10), static_cast<float>(draw(740) - 10)};
            break;
        case 2:
            io.MousePos.x += static_cast<float>(draw(41) - 20);
            io.MousePos.y += static_cast<float>(draw(41) - 20);
            break;
        case 3:
        case 4:
            io.MouseDown[draw(3)] = draw(2) == 0;
            break;
        case 5:
            io.MouseWheel = static_cast<float>(draw(7) - 3);
            break;
        case 6:
            io.AddInputCharacter(static_cast<unsigned>(' ' + draw(95)));
            break;
        case 7:
            io.KeyShift = draw(4) == 0;
            io.KeyCtrl = draw(4) == 0;
            io.KeysDown[draw(512)] = draw(2) == 0;
            break;
        default:
            ui::runChord(state,
                         {static_cast<ui::Key>(draw(ui::kKeyCount)), draw(3) == 0, draw(3) == 0});
    }
}

void checkDocument(const Document& document) {
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        ParameterSet copy = document;
        CHECK_NOTHROW(setValue(copy, row, valueOf(document, row)));
    }
    const CameraPose& pose = document.camera;
    CHECK(std::isfinite(pose.azimuthDeg));
    CHECK(std::abs(pose.elevationDeg) <= 90.0f);
    CHECK(pose.distance >= kMinDistance);
    CHECK(pose.distance <= kMaxDistance);
    CHECK(pose.fovDeg >= kMinFovDeg);
    CHECK(pose.fovDeg <= kMaxFovDeg);
}

}  // namespace

TEST_CASE("Ten thousand random events leave a document that is whole and can be undone") {
    const TemporaryFolder folder;
    const std::string home = folder.path().string();
    const Environment homes[] = {{"HOME", home},
                                 {"XDG_DATA_HOME", home},
                                 {"XDG_CONFIG_HOME", home},
                                 {"XDG_CACHE_HOME", home},
                                 {"XDG_STATE_HOME", home}};
    Headless gui;
    Session session(openFake(std::make_shared<FakeSeries>()));
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
    REQUIRE(waitUntilShown(session));
    ui::Ui state(session);
    std::mt19937 random(20261122);
    for (int i = 0; i < kEvents; i += kEventsAFrame) {
        for (int k = 0; k < kEventsAFrame; ++k) event(random, state);
        session.poll();
        gui.frame([&] { ui::draw(state); });
        state.requests = {};
        if (!ImGui::IsAnyMouseDown()) session.history.commit(session.document);
        if (i % 500 == 0) checkDocument(session.document);
    }
    ImGui::GetIO().MouseDown[0] = ImGui::GetIO().MouseDown[1] = ImGui::GetIO().MouseDown[2] = false;
    checkDocument(session.document);
    session.history.commit(session.document);
    const Document last = session.document;
    while (session.undo()) checkDocument(session.document);
    while (session.redo()) {
    }
    CHECK(session.document == last);
}
