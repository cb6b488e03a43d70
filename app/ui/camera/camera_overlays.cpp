// camera_overlays.cpp: scale bar, compass rose with the sun's path, and height ruler over the
// image, and how flight goes. Light strokes on dark ones, so that they are seen before cloud and
// before sky.
#include "app/ui/camera/camera_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/ui/camera/camera_view.h"
#include "app/ui/camera/sun_chart.h"
#include "app/ui/camera/sun_drag.h"
#include "app/ui/widgets/input.h"
#include "core/look/sun.h"

namespace neph::ui {
namespace {

constexpr ImU32 kLight = IM_COL32(240, 242, 245, 255);
constexpr ImU32 kDark = IM_COL32(0, 0, 0, 170);
constexpr ImU32 kNorth = IM_COL32(235, 110, 90, 255);
constexpr ImU32 kFaint = IM_COL32(240, 242, 245, 60);
constexpr ImU32 kSun = IM_COL32(255, 205, 90, 255);
constexpr ImU32 kSunBelow = IM_COL32(255, 205, 90, 110);
constexpr ImU32 kPlate = IM_COL32(20, 22, 26, 190);
constexpr float kMarginEms = 1.0f;      // from the image's edge
constexpr float kBarShare = 0.22f;      // of the image's width, at most
constexpr float kBarEms = 12.0f;        // at most
constexpr float kTickEms = 1.9f;        // between labels of the ruler, at least
constexpr float kLeastRulerEms = 3.0f;  // from its foot to its top, to be drawn
constexpr double kInside = 0.97;        // of the image, for the ruler to stand in

/// 1, 2 or 5 times a power of ten, not more than `most`.
double roundBelow(double most) {
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= most) return step * decade;
    }
    return decade;
}

double roundAbove(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least) return step * decade;
    }
    return 10.0 * decade;
}

/// Draws over the image, and nowhere else.
class Overlay {
  public:
    Overlay(const Session& session, const Layout& layout)
        : area_(layout.image),
          grid_(gridOf(session)),
          pose_(session.document.camera),
          camera_(placeCamera(pose_, grid_, aspectOf(layout))) {
        list_->PushClipRect({area_.lower.x, area_.lower.y}, {area_.upper.x, area_.upper.y});
    }
    ~Overlay() { list_->PopClipRect(); }
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    void scaleBar() const;
    void compass() const;
    void sunOnRose(const Session& session, SunHandle lit) const;
    void sunInImage(glm::vec2 at) const;
    void heightRuler() const;
    void flight(const CameraTools& tools) const;

  private:
    struct Tick {
        double heightM = 0.0;
        glm::vec2 at{0.0f};
    };

    void line(glm::vec2 a, glm::vec2 b, float width = 1.0f, ImU32 colour = kLight) const {
        const float px = width * em_ / 14.0f;
        list_->AddLine({a.x, a.y}, {b.x, b.y}, kDark, px + 2.5f * em_ / 14.0f);
        list_->AddLine({a.x, a.y}, {b.x, b.y}, colour, px);
    }
    void text(glm::vec2 at, const std::string& words, ImU32 colour = kLight) const {
        for (const glm::vec2 off : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1),
                                    glm::vec2(0, -1), glm::vec2(1, 1)}) {
            list_->AddText({at.x + off.x, at.y + off.y}, kDark, words.c_str());
        }
        list_->AddText({at.x, at.y}, colour, words.c_str());
    }
    static glm::vec2 sizeOf(const std::string& words) {
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        return {size.x, size.y};
    }
    /// Place on the screen; none where it is beside the image or behind the eye.
    std::optional<glm::vec2> screenOf(const glm::dvec3& pointM) const {
        const auto ndc = ndcOf(camera_, pointM);
        if (!ndc || std::abs(ndc->x) > kInside || std::abs(ndc->y) > kInside) return {};
        const glm::vec2 share{(ndc->x + 1.0) / 2.0, (1.0 - ndc->y) / 2.0};
        return area_.lower + share * area_.size();
    }
    double unitM() const { return std::max(grid_.extentM().x, grid_.extentM().y); }
    void circle(glm::vec2 middle, float radius, ImU32 colour) const {
        const float px = em_ / 14.0f;
        list_->AddCircle({middle.x, middle.y}, radius, kDark, 0, 3.0f * px);
        list_->AddCircle({middle.x, middle.y}, radius, colour, 0, px);
    }
    void hours(const SunChart& chart, const std::vector<SunPathPoint>& path) const;
    std::vector<Tick> ticksAt(glm::dvec2 placeM, double stepM) const;
    std::vector<Tick> ruler() const;

    ImDrawList* list_ = ImGui::GetBackgroundDrawList();
    Area area_;
    RegularGrid grid_;
    CameraPose pose_;
    Camera camera_;
    float em_ = ImGui::GetFontSize();
};

void Overlay::scaleBar() const {
    const double distanceM = static_cast<double>(pose_.distance) * unitM();
    const double mPerPx =
        2.0 * camera_.tanHalfFovY * distanceM / static_cast<double>(area_.size().y);
    const float most = std::min(kBarShare * area_.size().x, kBarEms * em_);
    const double lengthM = roundBelow(mPerPx * static_cast<double>(most));
    const auto px = static_cast<float>(lengthM / mPerPx);
    const glm::vec2 left{area_.lower.x + kMarginEms * em_, area_.upper.y - kMarginEms * em_};
    const glm::vec2 right = left + glm::vec2(px, 0.0f), up{0.0f, -0.45f * em_};
    line(left, right, 2.0f);
    line(left, left + up, 2.0f);
    line(right, right + up, 2.0f);
    text(left + glm::vec2(0.3f * em_, -1.45f * em_),
         fmt::format("{} at {}", lengthText(lengthM), lengthText(distanceM)));
}

void Overlay::compass() const {
    const SunChart chart = sunChartOf(area_, pose_);
    list_->AddCircleFilled({chart.middle.x, chart.middle.y}, chart.radius, IM_COL32(0, 0, 0, 70));
    for (const float heightDeg : {30.0f, 60.0f}) {
        list_->AddCircle({chart.middle.x, chart.middle.y},
                         chart.radius * (1.0f - heightDeg / 90.0f), kFaint);
    }
    circle(chart.middle, chart.radius, kLight);
    constexpr std::array<const char*, 4> kWinds{"N", "E", "S", "W"};
    for (int i = 0; i < 4; ++i) {
        const double azimuthDeg = 90.0 * i;
        const ImU32 colour = i == 0 ? kNorth : kLight;
        const glm::vec2 rim = chart.at({azimuthDeg, 0.0});
        line(chart.at({azimuthDeg, i == 0 ? 30.0 : 12.0}), rim, i == 0 ? 2.5f : 1.0f, colour);
        const std::string name = kWinds[static_cast<std::size_t>(i)];
        const glm::vec2 label = rim + 0.6f * em_ * glm::normalize(rim - chart.middle);
        text(label - sizeOf(name) / 2.0f, name, colour);
    }
}

/// Beside a path: away from the zenith, where hours stand apart, and near the rim towards it.
glm::vec2 besidePath(const SunChart& chart, glm::vec2 at, glm::vec2 next) {
    const glm::vec2 along = next - at, outward = at - chart.middle;
    const float length = glm::length(along);
    if (length == 0.0f) return {0.0f, 1.0f};
    const glm::vec2 normal = glm::vec2(-along.y, along.x) / length;
    const float off = glm::dot(outward, normal);
    const bool turned = (off < 0.0f) != (glm::length(outward) > 0.65f * chart.radius);
    return turned ? -normal : normal;
}

/// Every hour a dot, every third its number where there is room, else every sixth; where the sun is
/// up.
void Overlay::hours(const SunChart& chart, const std::vector<SunPathPoint>& path) const {
    constexpr float kSmall = 0.78f;  // of the usual letters
    const int numbered = chart.radius > 3.3f * em_ ? 3 : 6;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const SunPathPoint& point = path[i];
        const int hour = static_cast<int>(point.hour);
        if (point.hour != hour || point.elevationDeg < 0.0) continue;
        const glm::vec2 at = chart.at({point.azimuthDeg, point.elevationDeg});
        const bool hasNumber = hour % numbered == 0;
        list_->AddCircleFilled({at.x, at.y}, (hasNumber ? 0.17f : 0.11f) * em_, kSun);
        if (!hasNumber) continue;
        const glm::vec2 next = chart.at({path[i + 1].azimuthDeg, path[i + 1].elevationDeg});
        const std::string label = fmt::format("{:02}Z", hour);
        const glm::vec2 where =
            at + 0.95f * em_ * besidePath(chart, at, next) - kSmall * sizeOf(label) / 2.0f;
        for (const glm::vec2 shade : {glm::vec2(1, 1), glm::vec2(-1, 0), glm::vec2(0, -1)}) {
            list_->AddText(nullptr, kSmall * em_, {where.x + shade.x, where.y + shade.y}, kDark,
                           label.c_str());
        }
        list_->AddText(nullptr, kSmall * em_, {where.x, where.y}, kLight, label.c_str());
    }
}

void Overlay::sunOnRose(const Session& session, SunHandle lit) const {
    const SunChart chart = sunChartOf(area_, pose_);
    const Look& look = session.document.look;
    const std::vector<SunPathPoint> path = sunPathOf(look, session.where());
    for (std::size_t i = 1; i < path.size(); ++i) {
        const SunPathPoint &from = path[i - 1], &to = path[i];
        const bool up = from.elevationDeg + to.elevationDeg > 0.0;
        if (!joined(from, to) || (!up && i % 2 == 0)) continue;  // dashes
        const glm::vec2 a = chart.at({from.azimuthDeg, from.elevationDeg});
        const glm::vec2 b = chart.at({to.azimuthDeg, to.elevationDeg});
        list_->AddLine({a.x, a.y}, {b.x, b.y}, up ? kSun : kSunBelow, 1.3f * em_ / 14.0f);
    }
    hours(chart, path);
    const SunState sun = sunStateOf(look, session.where());
    const glm::vec2 at =
        chart.at({static_cast<double>(sun.azimuthDeg), static_cast<double>(sun.elevationDeg)});
    const float radius = (lit == SunHandle::rose ? 0.5f : 0.38f) * em_;
    list_->AddCircleFilled({at.x, at.y}, radius + 1.5f * em_ / 14.0f, kDark);
    if (sun.elevationDeg >= 0.0f) {
        list_->AddCircleFilled({at.x, at.y}, radius, kSun);
    } else {
        list_->AddCircle({at.x, at.y}, radius, kSunBelow, 0, 1.5f * em_ / 14.0f);
    }
}

/// What the mouse would take, or holds.
void Overlay::sunInImage(glm::vec2 at) const {
    circle(at, sunReach(), kSun);
}

/// Whole steps of height above a place that are in the image.
std::vector<Overlay::Tick> Overlay::ticksAt(glm::dvec2 placeM, double stepM) const {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::ceil(grid_.originM.z / stepM - 1e-6));
    const int last = static_cast<int>(std::floor(grid_.upperM().z / stepM + 1e-6));
    for (int i = first; i <= last; ++i) {
        const double height = i * stepM;
        if (const auto at = screenOf({placeM.x, placeM.y, height})) ticks.push_back({height, *at});
    }
    return ticks;
}

/// At the nearest of the domain's edges that is in the image, else at the target; empty where
/// heights lie on top of one another.
std::vector<Overlay::Tick> Overlay::ruler() const {
    const glm::dvec3 lower = grid_.originM, upper = grid_.upperM();
    const glm::dvec3 target = lower + grid_.extentM() * glm::dvec3(pose_.target);
    const double stepM = roundAbove(grid_.extentM().z / 50.0);
    std::vector<Tick> best;
    double nearest = 0.0;
    for (const glm::dvec2 edge : {glm::dvec2(lower), glm::dvec2(upper.x, lower.y),
                                  glm::dvec2(lower.x, upper.y), glm::dvec2(upper)}) {
        const double distance = glm::length(edge - glm::dvec2(camera_.eyeWorld));
        if (!best.empty() && distance >= nearest) continue;
        std::vector<Tick> ticks = ticksAt(edge, stepM);
        if (ticks.size() < 10) continue;  // less than a fifth of it is seen
        best = std::move(ticks);
        nearest = distance;
    }
    if (best.empty()) best = ticksAt(glm::dvec2(target), stepM);
    const bool tall =
        best.size() >= 2 && std::abs(best.front().at.y - best.back().at.y) >= kLeastRulerEms * em_;
    return tall ? best : std::vector<Tick>{};
}

void Overlay::heightRuler() const {
    const std::vector<Tick> fine = ruler();
    if (fine.empty()) return;
    line(fine.front().at, fine.back().at, 1.5f);
    const double spanM = fine.back().heightM - fine.front().heightM;
    const auto px = static_cast<double>(std::abs(fine.front().at.y - fine.back().at.y));
    const double labelM =
        roundAbove(std::max(spanM * static_cast<double>(kTickEms * em_) / px, 1.0));
    // Labels on the side where there is room.
    const bool left = fine.front().at.x > area_.upper.x - 5.0f * em_;
    const float side = left ? -1.0f : 1.0f;
    for (const Tick& tick : fine) {
        const double steps = tick.heightM / labelM;
        if (std::abs(steps - std::round(steps)) > 1e-6) continue;
        line(tick.at, tick.at + glm::vec2(side * 0.5f * em_, 0.0f), 1.5f);
        const std::string label = lengthText(tick.heightM);
        const glm::vec2 size = sizeOf(label);
        const float x = left ? -0.7f * em_ - size.x : 0.7f * em_;
        text(tick.at + glm::vec2(x, -size.y / 2.0f), label);
    }
}

void Overlay::flight(const CameraTools& tools) const {
    const std::string speed = lengthText(tools.flySpeed * unitM()) + "/s";
    const std::string words =
        tools.outOfReach
            ? "Flight ends here: too far from the domain"
            : "Flying at " + speed + "   W A S D  E Q   Shift: faster   Wheel: speed   G: end";
    const glm::vec2 size = sizeOf(words), pad{0.6f * em_, 0.3f * em_};
    const glm::vec2 at{(area_.lower.x + area_.upper.x - size.x) / 2.0f,
                       area_.lower.y + kMarginEms * em_};
    list_->AddRectFilled({at.x - pad.x, at.y - pad.y},
                         {at.x + size.x + pad.x, at.y + size.y + pad.y}, kPlate, pad.y);
    list_->AddText({at.x, at.y}, kLight, words.c_str());
}

}  // namespace

void drawCameraOverlays(const PanelContext& context, const CameraTools& tools) {
    const Layout layout = context.layout();
    if (context.session().shown() == nullptr || layout.image.empty()) return;
    const Overlay overlay(context.session(), layout);
    if (context.settings.heightRuler) overlay.heightRuler();
    if (context.settings.scaleBar) overlay.scaleBar();
    const SunHandle lit = tools.sun.lit();
    if (context.settings.compass) {
        overlay.compass();
        overlay.sunOnRose(context.session(), lit);
    }
    const auto disc = lit == SunHandle::disc ? sunInImage(context) : std::nullopt;
    if (disc) overlay.sunInImage(*disc);
    if (lit != SunHandle::none) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const glm::vec2 at{mouse.x, mouse.y}, ring(ImGui::GetFontSize());
        nextTooltipBeside({at - ring, at + ring});
        ImGui::SetTooltip("%s", sunWords(context.session()).c_str());
    }
    if (tools.flying || tools.fliesHeld) overlay.flight(tools);
}

}  // namespace neph::ui
