// accumulation.h: an image that gets better with every frame that is added to it.
#pragma once
#include <cstdint>

namespace neph::render {

/// A handle to an image that Renderer::render makes of several frames, one sample per pixel each.
/// The image itself is in the renderer, which has one: a frame that is not added to it takes its
/// place, and so does one of another accumulation.
class Accumulation {
  public:
    /// Frames that were added; a cancelled one does not count.
    int samples() const { return samples_; }

  private:
    friend class Renderer;
    std::uint64_t image_ = 0;  // which of the renderer's images it is
    int samples_ = 0;
};

}  // namespace neph::render
