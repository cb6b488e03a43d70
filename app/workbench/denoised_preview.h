// denoised_preview.h: when an image of paths is denoised for the screen, which takes seconds and is
// done on a thread of its own.
//
// After 2, 4, 8 ... paths per pixel, so that each preview has half the noise of the one before the
// last; after that only as often as leaves most of the time to paths; and once more at the end.
#pragma once
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/jobs.h"
#include "core/image/image.h"

namespace neph {

/// An image that gets better by paths.
struct TracedImage {
    glm::ivec2 sizePx{0};
    int samples = 0;    ///< paths per pixel
    bool last = false;  ///< there will be no more
};

class DenoisedPreview {
  public:
    using Clock = std::chrono::steady_clock;
    struct Made {
        ImageF image;
        TracedImage of;
    };

    /// `wake` is called, from another thread, when there is something to take().
    explicit DenoisedPreview(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

    /// Whether the image as it is now is to be denoised.
    bool wants(const TracedImage& now, Clock::time_point at) const;
    /// `halves`: of all that `of` has.
    void start(std::array<ImageF, 2> halves, const TracedImage& of, Clock::time_point at);
    /// What has been made since the last call. Throws Error where that failed.
    std::optional<Made> take(Clock::time_point at);
    /// What there was is of something else, and so is what is being made.
    void forget();
    bool busy() const { return jobs_ && jobs_->busy(); }

  private:
    std::function<void()> wake_;
    std::unique_ptr<Jobs> jobs_;  // once there is something to denoise
    std::optional<Made> made_;
    std::optional<Error> fault_;
    std::optional<TracedImage> last_;  // that was denoised, or is about to be
    Clock::time_point begun_, ended_;
};

}  // namespace neph
