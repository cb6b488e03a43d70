// phase_buffer.h: the phase functions of the classes, as displayed, on the GPU.
#pragma once
#include "app/gl/objects.h"
#include "core/medium.h"

namespace neph::render {

class PhaseBuffer {
  public:
    /// Makes the tables anew where look or plan ask for others.
    void update(const Look& look, const MediumPlan& plan);
    void bind(GLuint unit) const { tables_.bind(GL_SHADER_STORAGE_BUFFER, unit); }
    std::size_t bytes() const { return tables_.bytes(); }

  private:
    gl::Buffer tables_;
    Look look_;  ///< the look and plan that they were made of
    MediumPlan plan_;
    bool filled_ = false;
};

}  // namespace neph::render
