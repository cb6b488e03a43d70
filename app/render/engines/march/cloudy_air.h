// cloudy_air.h: what clouds change of the light that air sends to the eye: their shadows on it, and
// their own light. docs/sky.md
#pragma once
#include <glm/glm.hpp>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/frame/frame_block.h"
#include "app/render/light/light_layers.h"
#include "app/render/light/slice_plan.h"

namespace neph::render {

class CloudyAir {
  public:
    /// For light that is carried through slices from the first on.
    void open(const SlicePlan& plan);
    /// Keeps sunlight behind some slices, whose layers of light are held and bound as is the block
    /// of their batch; `program`: march/sun_through.comp.
    void keep(const SlicePlan& plan, int first, int slices, const gl::Program& program);
    /// Where on the rays of an image there may be a change, and how densely they are looked at:
    /// fills in what the block has of it.
    static void fill(FrameBlock& block, bool repeats);
    /// Follows the rays of the image that is bound; `program`: march/cloudy_air.comp.
    void look(const FrameBlock& block, const gl::Program& program);

    std::size_t bytes() const { return through_.bytes() + change_.bytes(); }

  private:
    bool repeats_ = false;  ///< beyond each edge across the light is the opposite one
    gl::Texture through_;   ///< R16: share of sunlight by place across the light, and slice
    gl::Texture change_;    ///< RGBA16F: by place in the image and distance
};

}  // namespace neph::render
