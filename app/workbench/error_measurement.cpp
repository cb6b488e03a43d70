// error_measurement.cpp: the reference of the same view with few pixels, and figures as paths
// become more.
#include "app/workbench/error_measurement.h"

#include <array>
#include <utility>

#include "app/gl/context.h"
#include "core/image/box_average.h"

namespace neph {
namespace {

// Two cores trace a path per pixel in some seconds, a GPU in milliseconds.
constexpr int kPixelsInSoftware = 64 * 36, kPixelsOnGpu = 192 * 108;
// The spread of fewer says too little of the noise.
constexpr int kFewestPaths = 4;
constexpr int kFewestToEnd = 16;    // and too little to be sure of it
constexpr double kMorePaths = 1.1;  // times as many give a new figure

}  // namespace

glm::ivec2 ErrorMeasurement::sizeFor(glm::ivec2 sizePx) {
    return coarserSize(sizePx, gl::deviceMemory().software ? kPixelsInSoftware : kPixelsOnGpu);
}

ErrorMeasurement::ErrorMeasurement(const render::Renderer& of, const render::FrameInputs& drawn,
                                   ImageF averaged, double seconds)
    : reference_(of.beside()), inputs_(drawn), image_(std::move(averaged)), seconds_(seconds) {
    inputs_.look.engine = groundTruth();
    inputs_.sizePx = image_.size;
    inputs_.part.reset();
    inputs_.supersample = 1;  // its paths are spread over the pixel
    inputs_.planes = 0;
    inputs_.draftLight = inputs_.profile = false;
}

bool ErrorMeasurement::trace(const Progress& progress) {
    if (finished()) return false;
    const render::FrameStats stats = reference_->render(inputs_, paths_, progress);
    const int paths = paths_.samples();
    if (paths < kFewestPaths || paths % 2 != 0) return false;  // the halves differ
    const bool last = stats.reference.seconds >= seconds_;
    if (result_ && !last && paths < kMorePaths * result_->paths) return false;
    const std::array<ImageF, 2> halves = reference_->readHalves();
    result_ = measureError(image_, halves, paths);
    map_ = errorsBeyondNoise(image_, halves);
    if ((paths >= kFewestToEnd && isKnownWell(*result_)) || last) reference_.reset();
    return true;
}

}  // namespace neph
