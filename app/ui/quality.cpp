// quality.cpp: a share of the full work, spread evenly over width, height and planes.
#include "app/ui/quality.h"

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

constexpr double kMinShare = 0.004;  // a sixth in each direction; coarser shows nothing useful
constexpr double kRung = 1.25;       // from one size to the next
constexpr int kMinPlanes = 24;
constexpr int kMinSidePx = 15;

/// Sizes come in rungs, and sides are odd: software drivers compile shaders anew for textures whose
/// sides are powers of two, and textures of a size seen before come cheap.
Draft share(double work, glm::ivec2 windowPx, int planes, int step) {
    if (work >= 0.9) return {windowPx, planes, kFullStep};
    const double rung = std::ceil(-std::log(std::cbrt(work)) / std::log(kRung) - 1e-9);
    const double side = std::pow(kRung, -rung);
    const auto scaled = [side](int whole, int least) {
        return std::min(whole, std::max(least, static_cast<int>(std::lround(whole * side)) | 1));
    };
    return {{scaled(windowPx.x, kMinSidePx), scaled(windowPx.y, kMinSidePx)},
            scaled(planes, kMinPlanes),
            step};
}

double workOf(const Draft& draft, glm::ivec2 windowPx, int planes) {
    return static_cast<double>(draft.sizePx.x) * draft.sizePx.y * draft.planes /
           (static_cast<double>(windowPx.x) * windowPx.y * planes);
}

}  // namespace

Draft QualityControl::draft(double restS, glm::ivec2 windowPx, int planes) const {
    double work = motionShare_;
    int step = 0;
    for (const Refinement& refinement : kRefinements) {
        if (restS < refinement.restS) break;
        if (fullMs_ <= refinement.milliseconds) return {windowPx, planes, kFullStep};
        work = std::max(work, refinement.milliseconds / fullMs_);
        ++step;
    }
    if (restS >= kFullS) return {windowPx, planes, kFullStep};
    return share(work, windowPx, planes, step);
}

void QualityControl::measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx,
                              int planes, bool drawnAlone) {
    if (milliseconds <= 0.0) return;
    const double work = workOf(draft, windowPx, planes);
    if (drawnAlone) fullMs_ = milliseconds / work;
    // Part of a frame's cost does not shrink with the picture, so approach the aim step by step.
    const double ideal = work * kMotionAimMs / milliseconds;
    motionShare_ = std::clamp(ideal, motionShare_ * 0.4, motionShare_ * 1.6);
    motionShare_ = std::clamp(motionShare_, kMinShare, 1.0);
}

}  // namespace neph::ui
