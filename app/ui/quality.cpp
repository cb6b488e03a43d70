// quality.cpp: a share of the full work, spread evenly over width, height and planes.
#include "app/ui/quality.h"

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

constexpr double kMinShare = 0.004;  // a sixth in each direction; coarser shows nothing useful
constexpr int kMinPlanes = 24;
constexpr int kMinSidePx = 16;

Draft share(double work, glm::ivec2 windowPx, int planes, int step) {
    if (work >= 0.9) return {windowPx, planes, kFullStep};
    const double side = std::cbrt(work);
    const auto scaled = [side](int whole, int least) {
        return std::min(whole, std::max(least, static_cast<int>(std::lround(whole * side))));
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
    if (restS < kSettleS) return share(motionShare_, windowPx, planes, 0);
    if (restS >= kFullS || fullMs_ <= kRefineMs) return {windowPx, planes, kFullStep};
    return share(std::max(motionShare_, kRefineMs / fullMs_), windowPx, planes, 1);
}

void QualityControl::measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx,
                              int planes) {
    if (milliseconds <= 0.0) return;
    const double work = workOf(draft, windowPx, planes);
    fullMs_ = milliseconds / work;
    // Part of a frame's cost does not shrink with the picture, so approach the aim step by step.
    const double ideal = work * kMotionAimMs / milliseconds;
    motionShare_ = std::clamp(ideal, motionShare_ * 0.4, motionShare_ * 1.6);
    motionShare_ = std::clamp(motionShare_, kMinShare, 1.0);
}

}  // namespace neph::ui
