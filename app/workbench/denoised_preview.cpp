// denoised_preview.cpp: the clock that decides, and the job.
#include "app/workbench/denoised_preview.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/image/denoise.h"

namespace neph {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kBetweenPreviews{0.5};  // between two, at least: what changes faster flickers
constexpr double kDenoisingShare = 1.0 / 3.0;  // that denoising may take of it
constexpr double kWorthAnother = 2.0;          // times as many paths

double pathsOf(const TracedImage& image) {
    return static_cast<double>(image.samples) * image.sizePx.x * image.sizePx.y;
}

}  // namespace

bool DenoisedPreview::wants(const TracedImage& now, Clock::time_point at) const {
    if (now.samples < 2 || busy()) return false;
    const double more = last_ ? pathsOf(now) / pathsOf(*last_) : kWorthAnother;
    if (more <= 1.0) return false;  // the same, or it has been begun again
    if (now.last) return true;
    if (now.samples % 2 != 0) return false;  // its halves are not equally good
    const bool again = last_ && last_->sizePx == now.sizePx;
    if (again && more < kWorthAnother) return false;
    const Seconds took = ended_ - begun_;
    const Seconds others = took * (1.0 / kDenoisingShare - 1.0);
    return !last_ || at - ended_ >= (again ? std::max(kBetweenPreviews, others) : others);
}

void DenoisedPreview::start(std::array<ImageF, 2> halves, const TracedImage& of,
                            Clock::time_point at) {
    if (!jobs_) jobs_ = std::make_unique<Jobs>(wake_);
    last_ = of;
    begun_ = ended_ = at;
    auto shared = std::make_shared<const std::array<ImageF, 2>>(std::move(halves));
    jobs_->start(
        "Denoising",
        [this, shared, of](const Progress& progress) -> Jobs::Finish {
            auto image = std::make_shared<ImageF>(
                denoised((*shared)[0], (*shared)[1], workerCount(kMostDenoisers), progress));
            return [this, image, of] { made_ = {std::move(*image), of}; };
        },
        [this](const Error& error) { fault_ = error; });
}

std::optional<DenoisedPreview::Made> DenoisedPreview::take(Clock::time_point at) {
    if (!jobs_ || !jobs_->poll()) return {};
    ended_ = at;
    if (const auto fault = std::exchange(fault_, {})) throw Error(*fault);
    return std::exchange(made_, {});
}

void DenoisedPreview::forget() {
    if (jobs_) jobs_->cancel();
    made_.reset();
    last_.reset();
}

}  // namespace neph
