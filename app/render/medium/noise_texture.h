// noise_texture.h: the detail noises of shaders/lib/noise.glsl as a texture; either repeats.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "core/grid/species.h"

namespace neph::render {

#include "shaders/shared/medium_layout.glsl"

/// Each is made when it is first wanted, as a pass of its own.
class NoiseTextures {
  public:
    /// RG16, filtered. r: billow, g: wisp.
    const gl::Texture& filtered(gl::ProgramCache& programs, gl::PassTimer& timer);

    /// R8, nearest, with levels of half the size each: a tile of billow and upon it one of wisp.
    /// Few bytes, so that more of it stays in caches. Kept as a file of the user's cache, by the
    /// text of its shader, since a processor takes half a second for it.
    const gl::Texture& stacked(gl::ProgramCache& programs, gl::PassTimer& timer);

    std::size_t bytes() const { return filtered_.bytes() + stacked_.bytes(); }

  private:
    gl::Texture filtered_, stacked_;
};

/// R32F: the pattern that spreads samples over pixels. core/optics/blue_noise.h
gl::Texture uploadBlueNoise();

}  // namespace neph::render
