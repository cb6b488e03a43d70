// compare_errors.h: how far slot A's image is from slot B's, live: figures and colours.
//
// The window hands over both images in linear light when there are newer ones; a worker computes
// with copies, so that nothing waits for it. What there was stays until there is something newer.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/jobs.h"
#include "core/image/error_image.h"
#include "core/image/image.h"
#include "core/image/image_error.h"
#include "core/image/reference_progress.h"

namespace neph::ui {

/// Which images the slots have, and how good they are.
struct PairState {
    std::uint64_t a = 0, b = 0;               ///< count the images that a slot has drawn
    bool whole = false;                       ///< both in full and of the same size
    bool settled = false;                     ///< and neither gets better by itself
    std::optional<ReferenceProgress> traced;  ///< of B, where the reference draws it
    bool shows(const PairState& other) const { return a == other.a && b == other.b; }
};

/// Of the engine `reference`: independent halves. Empty: there are none.
using LinearHalves = std::array<ImageF, 2>;

struct LinearPair {
    ImageF a, b;
    LinearHalves halvesA, halvesB;
};

/// Of A against B.
struct PairFigures {
    ImageErrors errors;
    double flip = 0.0, flipP95 = 0.0;  ///< HDR-FLIP
    ErrorScale scale;                  ///< of the colours: (A-B)/B of the luminance
    Image8 colours;                    ///< of the images' size
};

/// Throws Error as imageErrors, or Cancelled.
PairFigures figuresOf(const LinearPair& pair, const Progress& progress = {});

class CompareErrors {
  public:
    using Clock = std::chrono::steady_clock;

    /// Tells what there is now. True when it is to be handed over: at once where it is settled,
    /// else every two seconds, or less often where figures take long.
    bool wants(const PairState& now, Clock::time_point at);
    void start(LinearPair pair, Clock::time_point at);

    /// Takes over what has been computed; true when there is something new.
    bool poll(Clock::time_point at);
    bool busy() const { return jobs_ && jobs_->busy(); }

    const std::optional<PairFigures>& figures() const { return figures_; }
    /// Whether they are of the images that there are, or of the same with fewer paths.
    bool current() const { return figures_ && seen_.whole && seen_.a == figured_.a; }
    const PairState& seen() const { return seen_; }
    const std::string& fault() const { return fault_; }

    unsigned texture = 0;  ///< of the colours; whoever draws them makes it

  private:
    std::unique_ptr<Jobs> jobs_;  // once there is something to compute
    std::optional<PairFigures> figures_;
    PairState seen_, started_, figured_;
    Clock::time_point begun_, ended_;
    std::string fault_;
    bool fresh_ = false;
};

}  // namespace neph::ui
