// quality.h: how finely to draw while the user is at work, so that the picture follows the hand.
//
// In motion a frame is to take at most kMotionMs; at rest the picture is refined, in two steps
// where the last one would be slow. Work is the share of pixels x planes of the full picture.
#pragma once
#include <glm/glm.hpp>

namespace neph::ui {

/// One picture to draw.
struct Draft {
    glm::ivec2 sizePx{0};
    int planes = 0;
    int step = 0;  ///< 0 in motion, 1 refined, kFullStep in full
    bool operator==(const Draft&) const = default;
};

inline constexpr int kFullStep = 2;
inline constexpr double kMotionMs = 100.0;    // a frame that still follows the hand
inline constexpr double kMotionAimMs = 80.0;  // aimed at, to stay below on average
inline constexpr double kSettleS = 0.25;      // at rest for so long: refine
inline constexpr double kRefineMs = 400.0;    // of the first refinement
inline constexpr double kFullS = 0.9;  // at rest for so long: draw in full, whatever it takes

class QualityControl {
  public:
    /// What to draw when nothing has changed for `restS` seconds.
    Draft draft(double restS, glm::ivec2 windowPx, int planes) const;

    /// Tells how long a draft took, of a full picture of `windowPx` and `planes`.
    void measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx, int planes);

  private:
    double motionShare_ = 0.05;  // of the full work; a guess for a slow machine
    double fullMs_ = 2000.0;     // of a full picture, from the last measurement; likewise
};

}  // namespace neph::ui
