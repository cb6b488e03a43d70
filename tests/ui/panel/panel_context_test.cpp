// panel_context_test.cpp: a panel with nothing around it but its context.
#include "app/ui/panel/panel_context.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "app/ui/camera/camera_panel.h"
#include "app/ui/data/session_files.h"
#include "app/ui/widgets/places.h"
#include "core/preset/preset.h"
#include "tests/temporary_folder.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// What a shell would hand to a panel, with actions that only write down that they were run.
struct Bare {
    Session session{noReaders()};
    Session* active = &session;
    Settings settings;
    ui::Services services;
    ui::Requests requests;
    ui::NextFrame next;
    ui::Columns columns;
    std::string disabled;          ///< the one action that cannot be run
    std::vector<std::string> ran;  ///< ids, in the order in which they were run

    ui::PanelContext context() {
        return {.active = active,
                .settings = settings,
                .services = services,
                .requests = requests,
                .next = next,
                .columns = columns,
                .actions = {.face =
                                [this](std::string_view id) {
                                    return ui::ActionFace{.tooltip = std::string(id),
                                                          .enabled = id != disabled};
                                },
                            .run = [this](std::string_view id) { ran.emplace_back(id); }}};
    }
};

}  // namespace

TEST_CASE("A panel's buttons ask for actions by their ids, those that are enabled") {
    Headless gui;
    Bare bare;
    ui::CameraTools tools;
    ui::Playback playback;
    ui::wantPlaces(true);
    const auto frame = [&] {
        ui::clearPlaces();
        gui.frame([&] {
            ImGui::SetNextWindowPos({0.0f, 0.0f});
            ImGui::SetNextWindowSize({400.0f, 700.0f});
            ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
            ui::drawCamera(bare.context(), tools, playback);
            ImGui::End();
        });
    };
    const auto click = [&](const char* name) {
        const auto where = ui::placeOf(name);
        CAPTURE(name);
        REQUIRE(where.has_value());
        ImGui::GetIO().MousePos = {(where->lower.x + where->upper.x) / 2.0f,
                                   (where->lower.y + where->upper.y) / 2.0f};
        frame();
        for (const bool down : {true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
    };
    frame();
    frame();
    click("group:Camera");
    frame();
    bare.disabled = "camera.north";
    click("camera.fit");
    click("camera.north");
    click("camera.bookmark");
    CHECK(bare.ran == std::vector<std::string>{"camera.fit", "camera.bookmark"});
    ui::wantPlaces(false);
    ui::clearPlaces();
}

TEST_CASE("A preset among the files to open is left to those who know presets") {
    const TemporaryFolder folder;
    savePreset(folder / "p.json", Preset{});
    Bare bare;
    ui::SessionDialogs dialogs;
    ui::openFiles(bare.context(), dialogs, {(folder / "p.json").string()});
    CHECK(bare.requests.preset == (folder / "p.json").string());
    CHECK(bare.session.presetName.empty());
}

TEST_CASE("The session of a context is the active one, though another takes its place") {
    Bare bare;
    Session other(noReaders());
    const ui::PanelContext context = bare.context();
    CHECK(&context.session() == &bare.session);
    bare.active = &other;
    CHECK(&context.session() == &other);
}
