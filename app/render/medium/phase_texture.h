// phase_texture.h: the phase functions of the classes, as displayed, on the GPU.
//
// For full transport each is followed by its forward peaks, kPhaseRows in all.
#pragma once
#include <utility>
#include <vector>

#include "app/gl/objects.h"
#include "core/look/medium.h"

namespace neph::render {

#include "shaders/shared/medium_layout.glsl"

class PhaseTexture {
  public:
    /// Makes the tables again where look or plan ask for others.
    void update(const Look& look, const MediumPlan& plan);
    void bind() const { tables_.bind(kPhasesUnit); }
    std::size_t bytes() const { return tables_.bytes(); }

  private:
    const std::vector<PhaseTable>& peaksOf(const PhaseTable& table);

    gl::Texture tables_;  ///< RGBA32F, a row or kPhaseRows per class
    Look look_;           ///< the look and plan that they were made of
    MediumPlan plan_;
    bool filled_ = false;
    std::vector<std::pair<PhaseTable, std::vector<PhaseTable>>> peaks_;  ///< that were met
};

}  // namespace neph::render
