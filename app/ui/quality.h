// quality.h: how finely to draw while the user is at work, so that the picture follows the hand.
//
// In motion a frame is to take at most kMotionMs. At rest the picture is refined in steps, so that
// a slow machine shows a better one soon. Work is the share of pixels x planes of the full picture.
#pragma once
#include <array>
#include <glm/glm.hpp>

namespace neph::ui {

struct Refinement {
    double restS;         ///< at rest for so long
    double milliseconds;  ///< a picture that is expected to take so long
};
inline constexpr std::array kRefinements{Refinement{0.2, 400.0}, Refinement{0.7, 1500.0}};
inline constexpr int kFullStep = static_cast<int>(kRefinements.size()) + 1;
inline constexpr double kFullS = 2.0;         // at rest for so long: in full, whatever it takes
inline constexpr double kMotionMs = 100.0;    // a frame that still follows the hand
inline constexpr double kMotionAimMs = 70.0;  // aimed at: panels and window take the rest

/// One picture to draw.
struct Draft {
    glm::ivec2 sizePx{0};
    int planes = 0;
    int step = 0;  ///< 0 in motion, then as kRefinements, kFullStep in full
    bool operator==(const Draft&) const = default;
};

class QualityControl {
  public:
    /// What to draw when nothing has changed for `restS` seconds.
    Draft draft(double restS, glm::ivec2 windowPx, int planes) const;

    /// Tells how long a draft took, of a full picture of `windowPx` and `planes`. `drawnAlone`: the
    /// time holds no preparation, which a refinement would not repeat.
    void measured(const Draft& draft, double milliseconds, glm::ivec2 windowPx, int planes,
                  bool drawnAlone = true);

  private:
    double motionShare_ = 0.05;  // of the full work; a guess for a slow machine
    double fullMs_ = 2000.0;     // of a full picture, from the last measurement; likewise
};

}  // namespace neph::ui
