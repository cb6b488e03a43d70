// measured_error.cpp: the mean of two halves as the reference, and what its noise may explain.
#include "core/image/measured_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

constexpr double kShareKnown = 0.1, kLeastKnown = 0.003;
constexpr int kReach = 2;            // pixels around one whose noise is taken together
constexpr double kDeviations = 2.0;  // that noise may well explain

ImageF meanOf(const std::array<ImageF, 2>& halves) {
    ImageF mean = halves[0];
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        mean.pixels[i] = 0.5f * (halves[0].pixels[i] + halves[1].pixels[i]);
    }
    return mean;
}

/// Decimals that show one digit of a standard error in percent.
int decimalsFor(double sigmaPercent) {
    if (!(sigmaPercent > 0.0)) return 2;
    return std::clamp(-static_cast<int>(std::floor(std::log10(sigmaPercent))), 0, 2);
}

/// Squared standard error of the luminance of the mean of both halves, of each pixel alone.
std::vector<double> noiseOf(const std::array<ImageF, 2>& halves) {
    std::vector<double> noise;
    noise.reserve(halves[0].pixels.size());
    for (std::size_t i = 0; i < halves[0].pixels.size(); ++i) {
        const float apart = luminance(halves[0].pixels[i]) - luminance(halves[1].pixels[i]);
        noise.push_back(0.25 * static_cast<double>(apart) * static_cast<double>(apart));
    }
    return noise;
}

/// The mean over the pixels within kReach.
double aroundOf(const std::vector<double>& values, glm::ivec2 size, glm::ivec2 at) {
    const glm::ivec2 from = glm::max(at - kReach, glm::ivec2(0));
    const glm::ivec2 to = glm::min(at + kReach, size - 1);
    double sum = 0.0;
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            sum += values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                          static_cast<std::size_t>(x)];
        }
    }
    const glm::ivec2 count = to - from + 1;
    return sum / (count.x * count.y);
}

}  // namespace

MeasuredError measureError(const ImageF& image, const std::array<ImageF, 2>& halves, int paths) {
    const ImageF reference = meanOf(halves);
    return {.errors = imageErrors({image}, {reference, halves.data(), &halves[1]}),
            .sizePx = reference.size,
            .paths = paths};
}

bool isKnownWell(const MeasuredError& measured) {
    const ImageErrors& errors = measured.errors;
    return errors.relRmseSigma <= std::max(kShareKnown * errors.relRmse, kLeastKnown);
}

std::string errorText(const MeasuredError& measured) {
    const ImageErrors& errors = measured.errors;
    const double sigma = 100.0 * errors.relRmseSigma;
    const int decimals = decimalsFor(sigma);
    return fmt::format("{:.{}f} % ± {:.{}f} (bias {:+.{}f} %)", 100.0 * errors.relRmse, decimals,
                       sigma, decimals, 100.0 * errors.bias, decimalsFor(100.0 * errors.biasSigma));
}

std::string meaningOf(const MeasuredError& measured) {
    return fmt::format(
        "relRMSE of the linear radiance at {} x {} px against {} paths per pixel of the reference, "
        "its noise subtracted; the bias has a standard error of {:.{}f} %",
        measured.sizePx.x, measured.sizePx.y, measured.paths, 100.0 * measured.errors.biasSigma,
        decimalsFor(100.0 * measured.errors.biasSigma));
}

std::vector<float> errorsBeyondNoise(const ImageF& image, const std::array<ImageF, 2>& halves) {
    const ImageF reference = meanOf(halves);
    std::vector<float> errors = relativeErrors(image, reference);
    const std::vector<double> noise = noiseOf(halves);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const glm::ivec2 at(static_cast<int>(i) % image.size.x, static_cast<int>(i) / image.size.x);
        const auto difference =
            static_cast<double>(luminance(image.pixels[i]) - luminance(reference.pixels[i]));
        const double likely = kDeviations * kDeviations * aroundOf(noise, image.size, at);
        if (difference * difference < likely) errors[i] = 0.0f;
    }
    return errors;
}

}  // namespace neph
