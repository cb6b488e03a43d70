// quality.h: how finely to draw while the user is at work, so that the image follows the mouse.
//
// In motion a frame is to take no longer than it may, panels and window included. At rest the
// image is refined, in steps where the machine is slow, so that it shows a better one soon;
// an engine that averages then adds up to kSamples frames, and one that converges as many as it
// needs. Work is the share of pixels x steps of the full image.
#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "core/look/parameter.h"

namespace neph::ui {

struct RefinementStep {
    double restS;    ///< at rest for so long
    double draftMs;  ///< an image that is expected to take so long,
    double fullMs;   ///< or the full one, when that takes no longer than this
};
/// An image that takes up to 0.85 s is there in full a second after the user rests.
inline constexpr std::array kRefinements{RefinementStep{0.1, 250.0, 850.0},
                                         RefinementStep{0.4, 1500.0, 1500.0}};
inline constexpr int kFullStep = static_cast<int>(kRefinements.size()) + 1;
inline constexpr double kFullS = 2.0;  // at rest for so long: in full, whatever it takes
// Of the full work: a sixth of each direction with steps to thin; coarser shows nothing useful.
inline constexpr double kLeastShare = 0.004;
inline constexpr int kSamples = 16;  // averaged at rest; more show no difference

/// One image to draw.
struct Draft {
    glm::ivec2 sizePx{0};
    double detail = 1.0;  ///< share of the look's planes, or of its steps
    int step = 0;         ///< 0 in motion, then as kRefinements, kFullStep in full
    int sample = 0;       ///< frames of the same image before it
    bool operator==(const Draft&) const = default;
};

class QualityControl {
  public:
    /// `firstShare`: of the full work, for the first image.
    explicit QualityControl(double firstShare = 0.02) : motionShare_(firstShare) {}

    /// What to draw when nothing has changed for `restS` seconds; of the planes or steps at least a
    /// share of `leastDetail`.
    Draft draft(double restS, glm::ivec2 windowPx, double leastDetail = 0.0) const;

    /// Tells how long a draft of a full image of `windowPx` took; without preparation, which a
    /// coarser image needs as well and a refinement does not repeat.
    void measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx);

    /// Of a full image, as far as is known.
    double fullMs() const { return fullMs_; }

    /// For a whole frame in motion, from now on.
    void setFrameMs(double milliseconds) { frameMs_ = milliseconds; }

    /// Tells how long panels and window took in a frame.
    void measuredPanels(double milliseconds);

  private:
    static constexpr std::size_t kRemembered = 5;  // images in motion; one slow one is no reason
    double aimMs() const;
    double medianCostMs() const;
    void aim(double work, double costMs);

    double frameMs_ = 1000.0 / 30.0;
    double motionShare_;      // of the full work
    double fullMs_ = 2000.0;  // of a full image, from the last measurement; a guess
    double coarseMs_ = 0.0;   // of as much work as a full image, in small ones; 0: unknown
    double ratio_ = 1.0;      // of what work costs in large images and in small ones
    double panelsMs_ = 10.0;  // of panels and window; likewise
    std::array<double, kRemembered> costsMs_{};  // of as much work as a full image, in motion
    std::size_t measured_ = 0;                   // of them, since the start
};

/// What to draw, if anything, while nothing changes: `wanted` where it is finer than what is shown;
/// then, where the engine `averages`, further samples of the full image.
std::optional<Draft> nextDraft(const std::optional<Draft>& shown, const Draft& wanted,
                               bool averages);

/// The same for an engine that converges, `restS` after the last change, where a full image takes
/// `fullMs`: as in motion, then four times the pixels each, so that there is soon something to see
/// however slow paths are; in full one path per pixel after the other, as long as there is to be
/// `more`. Of the smaller images as many paths as `draftSamples`.
std::optional<Draft> nextTraced(const std::optional<Draft>& shown, const Draft& moving,
                                glm::ivec2 windowPx, double restS, double fullMs, bool more,
                                int draftSamples = 1);

/// One per engine: what they cost differs a thousandfold.
std::array<QualityControl, kEngineCount> qualityOfEachEngine();

/// Lowers whichever parameter says how finely the engine draws to the detail of the draft.
void thin(ParameterSet& values, const Draft& draft);

/// Slices of a draft, of `planes` in full. Odd, as sizes are: software drivers compile shaders
/// again for textures whose sides are powers of two.
int planesOf(const Draft& draft, int planes);

}  // namespace neph::ui
