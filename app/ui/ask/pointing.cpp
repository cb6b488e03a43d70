// pointing.cpp: rays of the mouse through the volume that is shown, clicks that choose a place, and
// drags that draw a section's line.
#include "app/ui/ask/pointing.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/camera/camera_view.h"
#include "app/ui/widgets/places.h"
#include "core/analysis/place.h"
#include "core/camera/camera_moves.h"
#include "core/look/medium.h"

namespace neph::ui {
namespace {

constexpr double kKm = 1e-3;
constexpr float kClickPx = 4.0f;  // a press that moves farther is a drag
constexpr float kBesideEms = 1.2f;
constexpr float kOpacity = 0.85f;
constexpr double kLeastShare = 1e-3;  // of the optical depth, for a species to be named

Camera cameraOf(const PanelContext& context) {
    const Session& session = context.session();
    return placeCamera(session.document.camera, gridOf(session), aspectOf(context.layout()));
}

/// The ray under the mouse; nothing beside the image or where the mouse is a panel's.
std::optional<glm::dvec3> rayUnderMouse(const PanelContext& context) {
    const Area image = context.layout().image;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::vec2 at(mouse.x, mouse.y);
    const bool inside = glm::all(glm::greaterThanEqual(at, image.lower)) &&
                        glm::all(glm::lessThan(at, image.upper));
    if (!inside || ImGui::GetIO().WantCaptureMouse || image.empty()) return {};
    const glm::dvec2 share((at - image.lower) / image.size());
    return cameraOf(context).rayDir({2.0 * share.x - 1.0, 1.0 - 2.0 * share.y});
}

/// Sea level, or the lowest side of what is shown where that is lower.
std::optional<glm::dvec3> meetGround(const RegularGrid& grid, const glm::dvec3& eye,
                                     const glm::dvec3& dir) {
    const double ground = std::min(grid.originM.z, 0.0);
    if (dir.z >= 0.0 || eye.z <= ground) return {};
    const glm::dvec3 at = eye + (ground - eye.z) / dir.z * dir;
    const glm::dvec3 upper = grid.upperM();
    const bool inside =
        at.x >= grid.originM.x && at.y >= grid.originM.y && at.x <= upper.x && at.y <= upper.y;
    if (!inside) return {};
    return at;
}

std::string placeLine(const Session& session, const char* what, const glm::dvec3& atM) {
    const DatasetInfo& info = *session.info();
    const auto geo = geoOf(info, session.document.time, glm::dvec2(atM));
    return fmt::format("{} x {:.1f}, y {:.1f}, {:.2f} km up{}\n", what, atM.x * kKm, atM.y * kKm,
                       atM.z * kKm, geo ? "\n    " + geoText(*geo) : "");
}

/// What is known of the air where cloud is met, as soon as its column has been read.
std::string airLines(const AskState& ask, const glm::dvec3& atM) {
    const auto& report = ask.pointed.value();
    if (!report || ask.pointed.busy() || report->heightsM.empty()) return {};
    const auto nearest = static_cast<std::size_t>(
        std::ranges::min_element(report->heightsM, {},
                                 [&](double heightM) { return std::abs(heightM - atM.z); }) -
        report->heightsM.begin());
    std::string text;
    for (const Quantity quantity : {Quantity::temperature, Quantity::pressure, Quantity::upwardWind,
                                    Quantity::windSpeed, Quantity::reflectivity}) {
        const Profile* profile = report->find(quantity);
        if (profile == nullptr) continue;
        text += fmt::format("{}{:.3g} {}", text.empty() ? "" : ", ", profile->values[nearest],
                            info(quantity).unit);
    }
    return text.empty() ? text : text + '\n';
}

/// Asks for the column where cloud is met. A reader with one handle leaves the air unsaid.
void askAir(const PanelContext& context, AskState& ask, const PointedAt& at) {
    ask.pointed.poll();
    if (ask.pointed.busy()) context.next.again(0.0);
    const auto when = askedTimeOf(context.session());
    if (!when || !at.ray.metM) return;
    const glm::dvec2 place(*at.ray.metM);
    const ColumnQuestion question{*when, columnAt(when->data->info(), place)};
    if (ask.pointed.asked() == question) return;
    const std::shared_ptr<Dataset> handle = when->data->anotherHandle();
    if (!handle) return;
    ask.pointed.ask(question, [&] {
        return [handle, time = when->time, place](const Progress&) {
            return readColumn(*handle, time, place);
        };
    });
    context.next.again(0.0);
}

std::string describe(const PanelContext& context, const AskState& ask, const PointedAt& at) {
    const Session& session = context.session();
    std::string text = session.shown()->timeLabel + '\n';
    if (!at.ray.metM) {
        return text + "no cloud on this line of sight" +
               (at.groundM ? "\n" + placeLine(session, "ground at", *at.groundM) : "");
    }
    text += placeLine(session, "cloud from", *at.ray.metM);
    text += at.ray.opaqueM ? placeLine(session, "opaque from", *at.ray.opaqueM)
                           : std::string("not opaque on this line of sight\n");
    text += fmt::format("optical depth {:.3g}\n", at.ray.depth);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        if (at.ray.depths[s] < kLeastShare * at.ray.depth) continue;
        text += fmt::format("{}: depth {:.2g}, {:.0f} % of what is seen", kSpecies[s].label,
                            at.ray.depths[s], 100.0 * at.ray.seen[s]);
        if (at.ray.extinctionPerM[s] > 0.0) {
            text += fmt::format(", {:.2g} /km", 1e3 * at.ray.extinctionPerM[s]);
        }
        if (at.ray.contentKgPerM3[s] > 0.0) {
            text += fmt::format(", {:.2g} g/m³", 1e3 * at.ray.contentKgPerM3[s]);
        }
        text += '\n';
    }
    return text + airLines(ask, *at.ray.metM);
}

/// Beside the mouse, not under it, and within the image as far as there is room.
void drawBox(const Area& image, const std::string& text) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float gap = kBesideEms * ImGui::GetFontSize();
    const ImVec2 words = ImGui::CalcTextSize(text.c_str());
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const glm::vec2 size{words.x + 2.0f * padding.x, words.y + 2.0f * padding.y};
    glm::vec2 at{mouse.x + gap, mouse.y + gap};
    if (at.x + size.x > image.upper.x) at.x = mouse.x - gap - size.x;
    if (at.y + size.y > image.upper.y) at.y = mouse.y - gap - size.y;
    at = glm::max(at, image.lower);
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowBgAlpha(kOpacity);
    if (ImGui::Begin("##probe", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::TextUnformatted(text.c_str());
        place("ask.probe_box");
    }
    ImGui::End();
}

void stroke(glm::vec2 a, glm::vec2 b) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(0, 0, 0, 170), 4.0f);
    list->AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(255, 205, 90, 255), 2.0f);
}

/// In pieces, since a line of the world is cut where it leaves the image.
void drawLine(const PanelContext& context, const glm::dvec3& from, const glm::dvec3& to) {
    constexpr int kPieces = 48;
    std::optional<glm::vec2> last;
    for (int i = 0; i <= kPieces; ++i) {
        const auto at = onScreen(context, glm::mix(from, to, static_cast<double>(i) / kPieces));
        if (last && at) stroke(*last, *at);
        last = at;
    }
}

void drawSectionLine(const PanelContext& context, const AskState& ask) {
    const SectionCut& section = ask.section;
    if (!ask.showSection || !section.vertical || section.fromM == section.toM) return;
    const RegularGrid grid = gridOf(context.session());
    const double low = std::max(grid.originM.z, 0.0), high = grid.upperM().z;
    const glm::dvec3 from(section.fromM, low), to(section.toM, low);
    drawLine(context, from, to);
    drawLine(context, from, {section.fromM, high});
    drawLine(context, to, {section.toM, high});
}

void drawPlace(const PanelContext& context, const AskState& ask) {
    if (!ask.showColumn || !ask.placed) return;
    const RegularGrid grid = gridOf(context.session());
    drawLine(context, {ask.placeM, std::max(grid.originM.z, 0.0)}, {ask.placeM, grid.upperM().z});
}

/// A cross and its label, whatever lies before it.
void drawPins(const PanelContext& context) {
    constexpr float kArmPx = 5.0f;
    for (const Pin& pin : context.session().document.pins) {
        const auto at = onScreen(context, pin.positionM);
        if (!at) continue;
        stroke(*at - glm::vec2(kArmPx, 0.0f), *at + glm::vec2(kArmPx, 0.0f));
        stroke(*at - glm::vec2(0.0f, kArmPx), *at + glm::vec2(0.0f, kArmPx));
        ImDrawList* list = ImGui::GetBackgroundDrawList();
        const ImVec2 text{at->x + 2.0f * kArmPx, at->y - 0.5f * ImGui::GetFontSize()};
        list->AddText({text.x + 1.0f, text.y + 1.0f}, IM_COL32(0, 0, 0, 200), pin.label.c_str());
        list->AddText(text, IM_COL32(255, 205, 90, 255), pin.label.c_str());
    }
}

void pinDown(Session& session, const std::optional<glm::dvec3>& place) {
    std::vector<Pin>& pins = session.document.pins;
    if (!place) {
        session.say(Message::Kind::warning, "There is neither cloud nor ground under the mouse");
    } else if (pins.size() >= kMaxPins) {
        session.say(Message::Kind::warning, "There are as many pins as there may be: delete one");
    } else {
        pins.push_back({fmt::format("P{}", pins.size() + 1), *place});
    }
}

std::optional<glm::dvec3> chosenPlace(const PointedAt& at) {
    return at.ray.metM ? at.ray.metM : at.groundM;
}

/// The line goes with the mouse along the ground, or through the clouds that it points at.
void drawByDrag(AskState& ask, const std::optional<PointedAt>& at) {
    if (!at) return;
    const auto place = at->groundM ? at->groundM : at->ray.metM;
    if (!place) return;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        ask.section.fromM = ask.section.toM = glm::dvec2(*place);
        ask.lineGiven = true;
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && ask.lineGiven) {
        ask.section.toM = glm::dvec2(*place);
    }
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) ask.drawing = false;
}

}  // namespace

std::optional<AskedTime> askedTimeOf(const Session& session) {
    if (!session.data() || !session.shown()) return {};
    const Document& document = session.document;
    const Ensemble* ensemble = session.ensemble();
    if (ensemble == nullptr) return AskedTime{session.data(), document.time};
    if (document.member == kMeanMember) return {};
    const auto own = ensemble->timeIn(document.member, document.time);
    if (!own) return {};
    return AskedTime{ensemble->runOf(document.member), *own};
}

std::optional<PointedAt> pointedAt(const PanelContext& context) {
    const Session& session = context.session();
    const auto& held = session.held();
    const auto dir = rayUnderMouse(context);
    if (!held || !dir) return {};
    const SpeciesVolume& volume = *held->volume;
    const glm::dvec3 eye = cameraOf(context).eyeWorld;
    const MediumPlan plan = planMedium(session.document.look, volume.holdings(), volume.cellM());
    return PointedAt{probeRay(volume, plan, eye, *dir), meetGround(volume.grid, eye, *dir)};
}

std::optional<glm::vec2> onScreen(const PanelContext& context, const glm::dvec3& positionM) {
    const auto ndc = ndcOf(cameraOf(context), positionM);
    if (!ndc || std::abs(ndc->x) > 1.0 || std::abs(ndc->y) > 1.0) return {};
    const Area image = context.layout().image;
    return image.lower + glm::vec2(0.5 * (ndc->x + 1.0), 0.5 * (1.0 - ndc->y)) * image.size();
}

void drawPointing(const PanelContext& context, AskState& ask) {
    place("image", context.layout().image);
    drawSectionLine(context, ask);
    drawPlace(context, ask);
    drawPins(context);
    if (std::exchange(ask.pin, false)) {
        const auto pointed = pointedAt(context);
        pinDown(context.session(), pointed ? chosenPlace(*pointed) : std::nullopt);
    }
    if (!ask.probes && !ask.drawing && !ask.showColumn) return;
    const auto at = pointedAt(context);
    if (ask.drawing) return drawByDrag(ask, at);
    if (!at) return;
    const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
    const bool clicked =
        ImGui::IsMouseReleased(ImGuiMouseButton_Left) && std::hypot(moved.x, moved.y) < kClickPx;
    const auto place = chosenPlace(*at);
    if (clicked && place) {
        ask.placeM = glm::dvec2(*place);
        ask.placed = true;
    }
    if (ask.probes && !ImGui::IsAnyMouseDown()) {
        askAir(context, ask, *at);
        drawBox(context.layout().image, describe(context, ask, *at));
    }
}

}  // namespace neph::ui
