// quality.cpp: a share of the full work, spread evenly over width, height and steps.
#include "app/workbench/quality.h"

#include <algorithm>
#include <cmath>

namespace neph::ui {
namespace {

constexpr double kLargeShare = 0.1;  // an image that tells what a full one costs
constexpr double kFullShare = 0.9;   // from here on the full image is drawn
constexpr double kRung = 1.15;       // from one size to the next
constexpr double kStayAbove = 0.95;  // a size is kept while the aim is so many times its work
constexpr double kStayBelow = 1.45;  // or more: a tenth above what the next size needs
constexpr int kMinPlanes = 24;
constexpr int kMinSidePx = 15;
constexpr double kMargin = 0.9;     // of the time there is: frames of one size differ a little
constexpr double kMinAimMs = 10.0;  // for the image, where the panels alone take all there is
constexpr int kLarger = 2;          // times width and height, from one image of paths to the next
constexpr double kSmoothing = 0.2;  // weight of the last frame's panels

int scaled(int whole, double share, int least) {
    return std::min(whole, std::max(least, static_cast<int>(std::lround(whole * share)) | 1));
}

/// Sizes come in rungs: textures of a size seen before come cheap.
Draft share(double work, glm::ivec2 windowPx, int step, double leastDetail) {
    if (work >= kFullShare) return {windowPx, 1.0, kFullStep};
    const double ideal = std::sqrt(work / std::max(leastDetail, std::cbrt(work)));
    const double side = std::pow(kRung, -std::ceil(-std::log(ideal) / std::log(kRung) - 1e-9));
    return {{scaled(windowPx.x, side, kMinSidePx), scaled(windowPx.y, side, kMinSidePx)},
            std::max(leastDetail, side),
            step};
}

double workOf(const Draft& draft, glm::ivec2 windowPx) {
    return draft.detail * draft.sizePx.x * draft.sizePx.y /
           (static_cast<double>(windowPx.x) * windowPx.y);
}

}  // namespace

Draft QualityControl::draft(double restS, glm::ivec2 windowPx, double leastDetail) const {
    const Draft full{windowPx, 1.0, kFullStep};
    double work = motionShare_;
    int step = 0;
    for (const RefinementStep& refinement : kRefinements) {
        if (restS < refinement.restS) break;
        if (fullMs_ <= refinement.fullMs) return full;
        work = std::max(work, refinement.draftMs / fullMs_);
        ++step;
    }
    return restS >= kFullS ? full : share(work, windowPx, step, leastDetail);
}

void QualityControl::measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx) {
    if (milliseconds <= 0.0) return;
    const double work = workOf(draft, windowPx);
    double costMs = milliseconds / work;
    // At rest an image tells how to move only where it is quick enough to move with.
    if (draft.step == 0 || motionShare_ >= kFullShare || milliseconds <= aimMs()) {
        costsMs_[measured_++ % kRemembered] = costMs;
        costMs = medianCostMs();
        aim(work, costMs);
    }
    // Part of an image's cost does not shrink with it. How much is learned where a large one
    // follows small ones.
    fullMs_ = work < kLargeShare ? costMs * ratio_ : costMs;
    if (work < kLargeShare) {
        coarseMs_ = costMs;
    } else if (coarseMs_ > 0.0) {
        ratio_ = std::min(1.0, fullMs_ / coarseMs_);
    }
}

/// Time for the image in motion.
double QualityControl::aimMs() const {
    return std::max(kMinAimMs, kMargin * (frameMs_ - panelsMs_));
}

double QualityControl::medianCostMs() const {
    auto costs = costsMs_;
    const auto end = costs.begin() + static_cast<std::ptrdiff_t>(std::min(measured_, kRemembered));
    const auto middle = costs.begin() + (end - costs.begin()) / 2;
    std::nth_element(costs.begin(), middle, end);
    return *middle;
}

/// Approaches the aim step by step, and leaves a size that fits: one that goes to and fro flickers.
void QualityControl::aim(double work, double costMs) {
    const double ideal = aimMs() / costMs;
    if (ideal > kStayAbove * work && ideal < kStayBelow * work) return;
    motionShare_ = std::clamp(ideal, motionShare_ * 0.4, motionShare_ * 1.6);
    motionShare_ = std::clamp(motionShare_, kLeastShare, 1.0);
}

void QualityControl::measuredPanels(double milliseconds) {
    panelsMs_ += kSmoothing * (milliseconds - panelsMs_);
}

std::optional<Draft> nextDraft(const std::optional<Draft>& shown, const Draft& wanted,
                               bool averages) {
    if (!shown || wanted.step > shown->step) return wanted;
    if (!averages || shown->step < kFullStep || shown->sample + 1 >= kSamples) return {};
    Draft further = *shown;
    ++further.sample;
    return further;
}

std::optional<Draft> nextTraced(const std::optional<Draft>& shown, const Draft& moving,
                                glm::ivec2 windowPx, double restS, double fullMs, bool more,
                                int draftSamples) {
    if (!shown) return moving;
    Draft next = *shown;
    if (shown->step == kFullStep) {
        if (!more) return {};
        ++next.sample;
        return next;
    }
    if (restS < kRefinements.front().restS) return {};
    if (shown->sample + 1 < draftSamples) {
        ++next.sample;
        return next;
    }
    next = {kLarger * shown->sizePx, 1.0, 1};
    // An image that is nearly full is not worth its time.
    const bool large = kLarger * next.sizePx.x > windowPx.x || kLarger * next.sizePx.y > windowPx.y;
    if (large || fullMs <= kRefinements.front().fullMs) next = {windowPx, 1.0, kFullStep};
    return next;
}

std::array<QualityControl, kEngineCount> qualityOfEachEngine() {
    std::array<QualityControl, kEngineCount> qualities;
    for (const EngineTraits& engine : kEngines) {
        // A first frame of unknown cost is to be a small one.
        if (engine.refinement != Refinement::converges) continue;
        qualities[static_cast<std::size_t>(engine.engine)] = QualityControl(kLeastShare);
    }
    return qualities;
}

void thin(ParameterSet& values, const Draft& draft) {
    switch (traitsOf(values.look.engine).fineness) {
        case Fineness::none:
            return;
        case Fineness::stepsPerVoxel:
            values.sampling.quality *= static_cast<float>(draft.detail);
            return;
        case Fineness::planes:
            values.look.planes = planesOf(draft, values.look.planes);
            return;
    }
}

int planesOf(const Draft& draft, int planes) {
    return draft.detail < 1.0 ? scaled(planes, draft.detail, kMinPlanes) : planes;
}

}  // namespace neph::ui
