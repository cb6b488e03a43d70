// camera_view.cpp: commands of the camera that the menu, the panel and the path share.
#include "app/ui/camera/camera_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/camera/camera_path_edit.h"
#include "core/volume/framing.h"

namespace neph::ui {
namespace {

constexpr double kEyeHeightM = 1.7;       // of somebody who stands
constexpr double kLeastFromTarget = 0.1;  // of a place on the ground, in larger extents
constexpr double kStepS = 4.0;            // from key to key unless told otherwise; tuned by eye
constexpr std::size_t kMaxBookmarks = 200;

/// A name that no bookmark has yet.
std::string freshName(const std::vector<Bookmark>& bookmarks) {
    for (std::size_t i = bookmarks.size() + 1;; ++i) {
        std::string name = fmt::format("View {}", i);
        if (std::ranges::find(bookmarks, name, &Bookmark::name) == bookmarks.end()) return name;
    }
}

}  // namespace

RegularGrid gridOf(const Session& session) {
    if (session.shown()) return session.shown()->grid;
    return {{1, 1, 1}, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
}

double aspectOf(const Layout& layout) {
    const glm::dvec2 size(imageBox(layout).size());
    return size.x / size.y;
}

void look(Session& session, View view, double aspect) {
    if (!session.shown()) return;
    session.document.camera =
        framed(view, session.document.camera, *session.shown(), session.document.look, aspect);
}

void frameOpened(Session& session, double aspect) {
    if (!session.takeUnframed()) return;
    look(session, View::fit, aspect);
    session.homeCamera = session.document.camera;
    session.history.restart(session.document);
}

void lookFromGround(Session& session, CameraTools& tools) {
    const RegularGrid grid = gridOf(session);
    CameraPose& pose = session.document.camera;
    const glm::dvec3 target = grid.originM + grid.extentM() * glm::dvec3(pose.target);
    const glm::dvec3 away = placeCamera(pose, grid, 1.0).eyeWorld - target;
    const double least = kLeastFromTarget * std::max(grid.extentM().x, grid.extentM().y);
    const double along = std::max(std::hypot(away.x, away.y), least);
    const glm::dvec3 outward = compassDirWorld(pose.azimuthDeg, 0.0f);
    const double heightM = std::max(grid.originM.z, 0.0) + kEyeHeightM;
    const double upDeg = glm::degrees(std::atan2(target.z - heightM, along));
    const Observer observer{target.x + outward.x * along,
                            target.y + outward.y * along,
                            heightM,
                            static_cast<double>(pose.azimuthDeg) + 180.0,
                            upDeg,
                            static_cast<double>(pose.fovDeg)};
    const auto stood = poseOf(observer, grid);
    tools.outOfReach = !stood;
    if (stood) takeView(pose, *stood);
}

void addBookmark(Session& session) {
    Document& document = session.document;
    if (document.bookmarks.size() >= kMaxBookmarks) {
        session.say(Message::Kind::warning,
                    fmt::format("There are {} bookmarks, which is as many as there may be: "
                                "delete one first",
                                kMaxBookmarks));
        return;
    }
    document.bookmarks.push_back({freshName(document.bookmarks), document.camera});
}

void addPathKey(Session& session, const Playback& playback) {
    Document& document = session.document;
    CameraPath& path = document.path;
    // Where the path stands between two of its keys, there; else at its end.
    const bool within = playback.led && playback.atS < durationS(path);
    const double atS = within ? playback.atS : path.keys.empty() ? 0.0 : durationS(path) + kStepS;
    if (!insertKey(path, atS, document.camera)) {
        session.say(Message::Kind::warning,
                    "The path has the largest number of keys allowed: delete one first");
    }
}

std::string lengthText(double lengthM) {
    return std::abs(lengthM) < 999.5 ? fmt::format("{:.3g} m", lengthM)
                                     : fmt::format("{:.3g} km", lengthM / 1e3);
}

}  // namespace neph::ui
