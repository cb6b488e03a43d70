// error_measurement.cpp: the reference of the same view with few pixels, and figures as paths
// become more.
#include "app/workbench/error_measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/gl/context.h"
#include "core/image/box_average.h"
#include "core/look/sun.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

// Two cores trace a path per pixel in some seconds, a GPU in milliseconds.
constexpr int kPixelsInSoftware = 64 * 36, kPixelsOnGpu = 192 * 108;
// The spread of fewer says too little of the noise.
constexpr int kFewestPaths = 4;
constexpr int kFewestToEnd = 16;    // and too little to be sure of it
constexpr double kMorePaths = 1.1;  // times as many give a new figure

/// Pixels that may have some of the sun's disc: it outshines the image, and paths do not carry it.
std::vector<std::size_t> pixelsOfDisc(const render::FrameInputs& inputs) {
    std::vector<std::size_t> pixels;
    if (inputs.look.skyModel != SkyModel::atmosphere || !inputs.look.sunDisc) return pixels;
    const Camera& camera = inputs.camera;
    const glm::dvec3 towardsSun = discDirWorld(inputs.look, camera.eyeWorld.z);
    const glm::dvec2 size(inputs.sizePx);
    const double pixel = 2.0 * camera.tanHalfFovY * std::max(1.0 / size.y, camera.aspect / size.x);
    const double nearest = std::cos(static_cast<double>(glsl::kSunRadius) + 1.5 * pixel);
    for (int y = 0; y < inputs.sizePx.y; ++y) {
        for (int x = 0; x < inputs.sizePx.x; ++x) {
            const glm::dvec2 ndc(2.0 * (x + 0.5) / size.x - 1.0, 1.0 - 2.0 * (y + 0.5) / size.y);
            if (glm::dot(camera.rayDir(ndc), towardsSun) < nearest) continue;
            pixels.push_back(static_cast<std::size_t>(y) *
                                 static_cast<std::size_t>(inputs.sizePx.x) +
                             static_cast<std::size_t>(x));
        }
    }
    return pixels;
}

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
    disc_ = pixelsOfDisc(inputs_);
}

bool ErrorMeasurement::trace(const Progress& progress) {
    if (finished()) return false;
    const render::FrameStats stats = reference_->render(inputs_, paths_, progress);
    const int paths = paths_.samples();
    if (paths < kFewestPaths || paths % 2 != 0) return false;  // the halves differ
    const bool last = stats.reference.seconds >= seconds_;
    if (result_ && !last && paths < kMorePaths * result_->paths) return false;
    const std::array<ImageF, 2> halves = reference_->readHalves();
    for (const std::size_t i : disc_) {
        image_.pixels[i] = 0.5f * (halves[0].pixels[i] + halves[1].pixels[i]);
    }
    result_ = measureError(image_, halves, paths);
    map_ = errorsBeyondNoise(image_, halves);
    if ((paths >= kFewestToEnd && isKnownWell(*result_)) || last) reference_.reset();
    return true;
}

}  // namespace neph
