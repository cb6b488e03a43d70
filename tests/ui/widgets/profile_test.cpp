// profile_test.cpp: the overlay of what an image cost: its rows from image to image, its
// place.
#include "app/ui/widgets/profile.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <limits>
#include <utility>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

ui::Profile profile(const std::vector<std::string>& passes, const std::string& redone) {
    ui::Profile made;
    made.engine = "March";
    made.device = "a device with a name that is far too long for the width of the overlay";
    made.image = {{"image", "640 x 360 px", "128 steps"}, {"frame", "12.00 ms", "83.3 fps"}};
    for (const std::string& pass : passes) made.passes.push_back({pass, "1.00 ms", "50 %", 0.5});
    made.samples = {{"rays", "230.40 k", ""}};
    made.memory = {{"GPU memory", "45.2 MiB", ""}, {"  light", "5.0 MiB", ""}};
    made.redone = redone;
    return made;
}

std::vector<std::string> labels(const std::vector<ui::ProfileRow>& rows) {
    std::vector<std::string> found;
    found.reserve(rows.size());
    for (const ui::ProfileRow& row : rows) found.push_back(row.label + (row.old ? " (old)" : ""));
    return found;
}

using Labels = std::vector<std::string>;

/// What of a window is seen, pixels; lower above upper when nothing is.
struct Extent {
    glm::vec2 lower{std::numeric_limits<float>::max()};
    glm::vec2 upper{std::numeric_limits<float>::lowest()};
};

Extent seenOf(const std::string& window) {
    Extent seen;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        if (list._OwnerName == nullptr || list._OwnerName != window) continue;
        for (const ImDrawCmd& part : list.CmdBuffer) {
            const glm::vec2 low(part.ClipRect.x, part.ClipRect.y);
            const glm::vec2 high(part.ClipRect.z, part.ClipRect.w);
            for (unsigned k = 0; k < part.ElemCount; ++k) {
                const auto index = list.IdxBuffer[static_cast<int>(part.IdxOffset + k)];
                const ImVec2 at = list.VtxBuffer[static_cast<int>(part.VtxOffset + index)].pos;
                const glm::vec2 clipped = glm::clamp(glm::vec2(at.x, at.y), low, high);
                seen.lower = glm::min(seen.lower, clipped);
                seen.upper = glm::max(seen.upper, clipped);
            }
        }
    }
    return seen;
}

}  // namespace

TEST_CASE("Passes that an image did without stay in their place, as old ones") {
    ui::Profile shown;
    ui::update(shown, profile({"eye", "resolve"}, "eye > resolve"), true);
    CHECK(labels(shown.passes) == Labels{"eye", "resolve"});
    ui::update(shown, profile({"bake medium", "light", "eye", "resolve"}, "medium > light"), true);
    CHECK(labels(shown.passes) == Labels{"bake medium", "light", "eye", "resolve"});
    ui::update(shown, profile({"light", "background", "resolve"}, "light"), true);
    CHECK(labels(shown.passes) ==
          Labels{"bake medium (old)", "light", "background", "eye (old)", "resolve"});
    CHECK(shown.passes[0].share == 0.0);
    CHECK(shown.passes[0].value == "1.00 ms");
    CHECK(shown.passes[0].note.empty());
    CHECK(shown.passes[1].note == "50 %");
    CHECK(shown.passes[1].share == 0.5);
}

TEST_CASE("A refinement does not hide what the last change redid") {
    ui::Profile shown;
    ui::update(shown, profile({"light", "eye"}, "light > eye > resolve"), true);
    ui::update(shown, profile({"eye"}, "eye > resolve"), false);
    CHECK(shown.redone == "light > eye > resolve");
    ui::update(shown, profile({"resolve"}, "resolve"), true);
    CHECK(shown.redone == "resolve");
}

TEST_CASE("Another engine begins a new profile") {
    ui::Profile shown;
    ui::update(shown, profile({"bake medium", "light", "eye"}, "medium > light"), true);
    ui::Profile slicing = profile({"eye"}, "eye > resolve");
    slicing.engine = "Half-angle slicing";
    ui::update(shown, slicing, false);
    CHECK(labels(shown.passes) == Labels{"eye"});
    CHECK(shown.redone == "eye > resolve");
}

TEST_CASE("F3 shows and hides the overlay and has the image drawn again for its times") {
    Session session(noReaders());
    ui::Ui state(session);
    CHECK(ui::runChord(state, {ui::Key::f3}));
    CHECK(state.showProfile);
    CHECK(std::exchange(state.requests.redraw, false));
    CHECK(ui::runChord(state, {ui::Key::f3}));
    CHECK_FALSE(state.showProfile);
    CHECK_FALSE(state.requests.redraw);
}

TEST_CASE("The overlay keeps to the corner of the image, whatever the name of the device") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.profile = profile({"bake medium", "light", "eye", "resolve"}, "medium > light");
    for (int i = 0; i < 2; ++i) gui.frame([&] { ui::draw(state); });
    CHECK(seenOf("##profile").lower.x > seenOf("##profile").upper.x);  // not asked for
    state.showProfile = true;
    for (const bool panels : {true, false}) {
        state.columns.shown = panels;
        for (int i = 0; i < 3; ++i) gui.frame([&] { ui::draw(state); });
        const Extent seen = seenOf("##profile");
        const float edge = state.layout().image.upper.x;
        CHECK(edge == (panels ? 1280.0f - 270.0f : 1280.0f));
        CHECK(seen.upper.x < edge);
        CHECK(seen.upper.x > edge - 2.0f * ImGui::GetFontSize());
        CHECK(seen.lower.x > 640.0f);  // the middle of the image stays free
        CHECK(seen.lower.y > 0.0f);
        CHECK(seen.upper.y < 360.0f);
    }
}

TEST_CASE("The hand reaches the image through the overlay") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.profile = profile({"eye"}, "eye");
    state.showProfile = true;
    ImGuiIO& io = ImGui::GetIO();
    const auto frame = [&] { gui.frame([&] { ui::draw(state); }); };
    for (int i = 0; i < 3; ++i) frame();
    const Extent seen = seenOf("##profile");
    io.MousePos = {seen.upper.x - 20.0f, seen.upper.y - 20.0f};
    frame();
    const float before = session.document.camera.azimuthDeg;
    io.MouseDown[0] = true;
    frame();
    io.MousePos.x -= 30.0f;
    frame();
    CHECK(session.document.camera.azimuthDeg != before);
}
