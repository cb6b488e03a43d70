// compare_errors.cpp: when figures are computed, and from what.
#include "app/ui/compare/compare_errors.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/image/flip.h"

namespace neph::ui {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kEvery{2.0};         // while images get better
constexpr double kShareOfTime = 0.25;  // that figures may take of it: images come first

SampledImage sampled(const ImageF& image, const LinearHalves& halves) {
    if (halves[0].pixels.empty()) return {image};
    return {image, halves.data(), &halves[1]};
}

}  // namespace

PairFigures figuresOf(const LinearPair& pair, const Progress& progress) {
    PairFigures made;
    made.errors = imageErrors(sampled(pair.a, pair.halvesA), sampled(pair.b, pair.halvesB));
    const std::vector<float> errors = relativeErrors(pair.a, pair.b);
    made.scale = {.most = roundEnd(errors), .bothSigns = true, .title = "(A-B)/B"};
    made.colours = errorColours(pair.a.size, errors, made.scale);
    const FlipMap flip =
        hdrFlip(pair.a, pair.b, flipExposures(pair.b), kFlipPixelsPerDegree, progress);
    made.flip = flip.mean();
    made.flipP95 = flip.p95();
    return made;
}

bool CompareErrors::wants(const PairState& now, Clock::time_point at) {
    seen_ = now;
    if (!now.whole || now.shows(started_)) return false;
    if (now.settled) return true;
    if (busy()) return false;
    // The halves of an odd number of paths are not equally good.
    if (now.traced && now.traced->samples % 2 != 0) return false;
    const Seconds took = ended_ - begun_;
    return !figures_ || at - ended_ >= std::max(kEvery, took * (1.0 / kShareOfTime - 1.0));
}

void CompareErrors::start(LinearPair pair, Clock::time_point at) {
    if (!jobs_) jobs_ = std::make_unique<Jobs>();
    started_ = seen_;
    begun_ = at;
    auto shared = std::make_shared<const LinearPair>(std::move(pair));
    jobs_->start(
        "Figures",
        [this, shared, of = seen_](const Progress& progress) -> Jobs::Finish {
            auto made = std::make_shared<PairFigures>(figuresOf(*shared, progress));
            return [this, made, of] {
                figures_ = std::move(*made);
                figured_ = of;
                fault_.clear();
                fresh_ = true;
            };
        },
        [this](const Error& error) {
            figures_.reset();
            fault_ = error.message();
            fresh_ = true;
        });
}

bool CompareErrors::poll(Clock::time_point at) {
    if (!jobs_) return false;
    jobs_->poll();
    if (fresh_) ended_ = at;
    return std::exchange(fresh_, false);
}

}  // namespace neph::ui
