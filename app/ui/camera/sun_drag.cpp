// sun_drag.cpp: what the mouse is over, and where the sun goes with it.
#include "app/ui/camera/sun_drag.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/camera/camera_view.h"
#include "app/ui/camera/sun_chart.h"
#include "app/ui/widgets/places.h"
#include "core/look/sun.h"
#include "core/sky/air_columns.h"

namespace neph::ui {
namespace {

constexpr float kPathReachEms = 0.4f;  // in which a sun that may go anywhere takes to its path
constexpr double kDiscDeg = 0.27;      // radius; while any of it is up it can be taken

glm::vec2 mouseAt() {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {mouse.x, mouse.y};
}

Camera cameraOf(const PanelContext& context) {
    const Session& session = context.session();
    return placeCamera(session.document.camera, gridOf(session), aspectOf(context.layout()));
}

bool hidden(const Look& look, double eyeM, double up) {
    if (!look.groundVisible) return false;
    const bool round = look.skyModel == SkyModel::atmosphere;
    const double horizon = round ? horizonUp(std::max(eyeM, 0.0)) : 0.0;
    return up < horizon - std::sin(glm::radians(kDiscDeg));
}

SunChart chartOf(const PanelContext& context) {
    return sunChartOf(context.layout().image, context.session().document.camera);
}

glm::vec2 sunOnRose(const PanelContext& context) {
    const Session& session = context.session();
    const SunState sun = sunStateOf(session.document.look, session.where());
    return chartOf(context).at(
        {static_cast<double>(sun.azimuthDeg), static_cast<double>(sun.elevationDeg)});
}

std::optional<glm::vec2> placeOfHandle(const PanelContext& context, SunHandle handle) {
    if (handle == SunHandle::disc) return sunInImage(context);
    if (handle == SunHandle::rose && context.settings.compass) return sunOnRose(context);
    return {};
}

void namePlaces(const PanelContext& context) {
    const auto name = [&](const char* as, SunHandle handle) {
        const auto at = placeOfHandle(context, handle);
        if (at) place(as, {*at - sunReach(), *at + sunReach()});
    };
    name("sun.rose", SunHandle::rose);
    name("sun.disc", SunHandle::disc);
}

/// The rose lies over the image.
SunHandle handleUnder(const PanelContext& context, glm::vec2 mouse) {
    for (const SunHandle handle : {SunHandle::rose, SunHandle::disc}) {
        const auto at = placeOfHandle(context, handle);
        if (at && glm::distance(*at, mouse) <= sunReach()) return handle;
    }
    return SunHandle::none;
}

void keepBefore(SunDrag& drag, const Look& look) {
    drag.source = look.sunSource;
    drag.azimuthDeg = look.sunAzimuthDeg;
    drag.elevationDeg = look.sunElevationDeg;
    drag.hour = look.sunHour;
}

void putBack(const SunDrag& drag, Look& look) {
    look.sunSource = drag.source;
    look.sunAzimuthDeg = drag.azimuthDeg;
    look.sunElevationDeg = drag.elevationDeg;
    look.sunHour = drag.hour;
}

void moveOnRose(const PanelContext& context, glm::vec2 to) {
    Session& session = context.session();
    Look& look = session.document.look;
    const SunChart chart = chartOf(context);
    const Whereabouts where = session.where();
    const auto near = nearestOfPath(chart, sunPathOf(look, where), to);
    if (look.sunSource == SunSource::date && !where.utc && near) {
        look.sunHour = static_cast<float>(near->hour);
        return;
    }
    const bool onPath = near && near->distance <= kPathReachEms * ImGui::GetFontSize();
    const SkyDirection direction = onPath ? near->direction : chart.directionAt(to);
    setSunAngles(look, direction.azimuthDeg, direction.elevationDeg);
}

void moveDisc(const PanelContext& context, glm::vec2 to) {
    const Area image = context.layout().image;
    const glm::dvec2 share = glm::dvec2((to - image.lower) / image.size());
    const Camera camera = cameraOf(context);
    setDiscSeen(context.session().document.look,
                camera.rayDir({2.0 * share.x - 1.0, 1.0 - 2.0 * share.y}), camera.eyeWorld.z);
}

void moveSun(const PanelContext& context, const SunDrag& drag) {
    Session& session = context.session();
    const SunSource before = session.document.look.sunSource;
    const glm::vec2 to = mouseAt() + drag.toSun;
    if (drag.held == SunHandle::rose) {
        moveOnRose(context, to);
    } else {
        moveDisc(context, to);
    }
    if (session.document.look.sunSource == before) return;
    session.say(
        Message::Kind::note,
        "The sun stands by angles now; Sun by, in Sun and sky, returns it to date and place");
}

/// Takes what is under the mouse when the button goes down on it.
void take(const PanelContext& context, SunDrag& drag) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool free = !io.WantCaptureMouse && !ImGui::IsAnyItemActive() && !io.KeyShift &&
                      (clicked || !ImGui::IsAnyMouseDown());
    drag.hovered = free ? handleUnder(context, mouseAt()) : SunHandle::none;
    if (!clicked || drag.hovered == SunHandle::none) return;
    drag.held = drag.hovered;
    drag.given = true;
    drag.toSun = placeOfHandle(context, drag.held).value_or(mouseAt()) - mouseAt();
    keepBefore(drag, context.session().document.look);
}

}  // namespace

float sunReach() {
    return 0.9f * ImGui::GetFontSize();
}

std::optional<glm::vec2> sunInImage(const PanelContext& context) {
    const Session& session = context.session();
    const Area image = context.layout().image;
    const Look look = withSun(session.document.look, session.where());
    const Camera camera = cameraOf(context);
    const glm::dvec3 sun = discDirWorld(look, camera.eyeWorld.z);
    const auto ndc = ndcOf(camera, camera.eyeWorld + sun);
    if (!ndc || std::abs(ndc->x) > 1.0 || std::abs(ndc->y) > 1.0) return {};
    if (hidden(look, camera.eyeWorld.z, sun.z)) return {};
    const glm::vec2 share{(ndc->x + 1.0) / 2.0, (1.0 - ndc->y) / 2.0};
    return image.lower + share * image.size();
}

std::string sunWords(const Session& session) {
    const SunState sun = sunStateOf(session.document.look, session.where());
    std::string words = fmt::format("Sun: azimuth {:.1f}\u00b0, elevation {:.1f}\u00b0",
                                    sun.azimuthDeg, sun.elevationDeg);
    if (sun.byDate) words += fmt::format(", {} UTC", utcText(sun.utc).substr(11, 5));
    return words;
}

void dragSun(const PanelContext& context, SunDrag& drag, bool may) {
    const ImGuiIO& io = ImGui::GetIO();
    if (context.session().shown() == nullptr || context.layout().image.empty()) {
        drag = {};
        return;
    }
    if (!io.MouseDown[ImGuiMouseButton_Left]) {
        drag.held = SunHandle::none;
        drag.given = false;
    }
    namePlaces(context);
    drag.hovered = SunHandle::none;
    if (!drag.given && may) take(context, drag);
    if (drag.held == SunHandle::none) {
        if (drag.hovered != SunHandle::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        return;
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
        putBack(drag, context.session().document.look);
        drag.held = drag.hovered = SunHandle::none;
        return;
    }
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) moveSun(context, drag);
}

}  // namespace neph::ui
