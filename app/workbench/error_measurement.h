// error_measurement.h: measures how far an image is from the reference, in pieces of a few
// milliseconds, beside the renderer that drew it. For the window and for `render`.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/render/renderer.h"
#include "core/image/measured_error.h"

namespace neph {

class ErrorMeasurement {
  public:
    /// The size at which an image of `sizePx` is compared: as a processor or a GPU has time for.
    static glm::ivec2 sizeFor(glm::ivec2 sizePx);

    /// Of an image that `of` drew with `drawn`. `averaged`: that image, at sizeFor() it. Ends when
    /// the error is known well, or after `seconds` of tracing.
    ErrorMeasurement(const render::Renderer& of, const render::FrameInputs& drawn, ImageF averaged,
                     double seconds);

    /// Traces one more path per pixel, or goes on with one that `progress` had stopped. Whether
    /// result() is newer. Throws Cancelled, or Error where the reference is black.
    bool trace(const Progress& progress);

    /// Nothing is left to trace, and the memory for it has been given back.
    bool finished() const { return !reference_; }
    const std::optional<MeasuredError>& result() const { return result_; }
    /// errorsBeyondNoise() of result(), row 0 on top.
    const std::vector<float>& map() const { return map_; }
    /// Held on the GPU for it.
    std::size_t bytes() const { return reference_ ? reference_->gpuBytes() : 0; }

  private:
    std::unique_ptr<render::Renderer> reference_;
    render::FrameInputs inputs_;  // of the reference
    render::Accumulation paths_;
    ImageF image_;
    std::vector<std::size_t> disc_;  ///< pixels with the sun's disc, which is not measured
    double seconds_ = 0.0;
    std::optional<MeasuredError> result_;
    std::vector<float> map_;
};

}  // namespace neph
