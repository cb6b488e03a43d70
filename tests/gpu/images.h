// images.h: the one renderer that tests of images share, and how images are compared.
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/render/renderer.h"
#include "tests/gpu/context.h"

namespace neph::test {

inline render::Renderer& renderer() {
    needContext();
    static render::Renderer instance{NEPH_TEST_SOURCE_DIR "/shaders"};
    return instance;
}

inline ImageF renderOn(const SpeciesVolume& volume, const render::FrameInputs& inputs) {
    renderer().setVolume(volume);
    renderer().render(inputs);
    return renderer().readLinear();
}

/// The mean of `samples` images of the march.
inline ImageF averageOn(const SpeciesVolume& volume, const render::FrameInputs& inputs,
                        int samples) {
    renderer().setVolume(volume);
    render::Accumulation image;
    while (image.samples() < samples) renderer().render(inputs, image);
    return renderer().readLinear();
}

/// As a renderer shows it that has shown nothing before.
inline ImageF renderAfresh(const SpeciesVolume& volume, const render::FrameInputs& inputs) {
    needContext();
    render::Renderer fresh{NEPH_TEST_SOURCE_DIR "/shaders"};
    fresh.setVolume(volume);
    fresh.render(inputs);
    return fresh.readLinear();
}

/// Infinite where a pixel is not finite.
inline float worstDifference(const ImageF& a, const ImageF& b) {
    REQUIRE(a.size == b.size);
    float worst = 0.0f;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec4 d = glm::abs(a.pixels[i] - b.pixels[i]);
        if (!std::isfinite(d.x + d.y + d.z + d.w)) return INFINITY;
        worst = std::max({worst, d.x, d.y, d.z, d.w});
    }
    return worst;
}

/// Root of the mean square difference of luminance, as a share of the reference's mean luminance.
/// Weights of Rec. ITU-R BT.709.
inline double luminanceError(const ImageF& seen, const ImageF& reference) {
    REQUIRE(seen.size == reference.size);
    const auto luminance = [](glm::vec4 p) {
        return glm::dot(glm::dvec3(p), glm::dvec3(0.2126, 0.7152, 0.0722));
    };
    double square = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const double d = luminance(seen.pixels[i]) - luminance(reference.pixels[i]);
        square += d * d;
        sum += luminance(reference.pixels[i]);
    }
    const auto count = static_cast<double>(seen.pixels.size());
    return std::sqrt(square / count) / (sum / count);
}

inline bool allFinite(const ImageF& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](glm::vec4 p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
    });
}

}  // namespace neph::test
