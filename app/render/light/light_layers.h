// light_layers.h: the light buffer of [Riley03] §4.4.1, every layer kept: layer k is what meets
// slice k.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/light/light_tiles.h"
#include "app/render/light/slice_plan.h"
#include "core/base/progress.h"

namespace neph::render {

class LightLayers {
  public:
    /// `format`: GL_R32F, or GL_R16 in which a step of 1.5e-5 is the darkest.
    /// `repeats`: beyond each edge is the opposite one.
    void resize(glm::ivec2 sizePx, int layers, GLenum format, bool repeats = false);
    /// Layer 0 takes over from another layer, or full light (-1).
    void open(int fromLayer);
    /// Fills the layers after the first, one for each slice of `tiles`. Throws Cancelled.
    void march(const gl::Program& program, const LightTiles& tiles, const Progress& progress);

    void bind(GLuint unit) const { layers_.bind(unit); }
    glm::ivec3 size() const { return layers_.size(); }
    std::size_t bytes() const { return layers_.bytes() + tiles_.bytes(); }

  private:
    void copy(int from, int to);

    gl::Texture layers_;
    gl::Buffer tiles_;
    GLenum format_ = 0;
    bool repeats_ = false;
};

/// Layers that the driver and `mostBytes` allow, at least 2.
int layersThatFit(glm::ivec2 sizePx, std::size_t bytesPerTexel, std::size_t mostBytes);

}  // namespace neph::render
