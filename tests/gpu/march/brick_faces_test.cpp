// brick_faces_test.cpp: a cloud whose bricks are moved voxel by voxel, seen from above and below.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr int kFaceEvery = 4;  // voxels
constexpr int kVoxelPx = 4;    // of the image
constexpr glm::ivec3 kSize{32, 32, 24};
constexpr glm::dvec3 kVoxelM{500.0, 500.0, 250.0};
constexpr glm::ivec2 kImagePx{kVoxelPx * kSize.x, kVoxelPx* kSize.y};

/// Optical depth of a vertical voxel: a thick tower under a thin veil. Smooth, and nothing within
/// four voxels of the sides.
double depthAt(glm::dvec3 voxel) {
    const auto bell = [&](glm::dvec3 centre, glm::dvec3 width) {
        const glm::dvec3 d = (voxel - centre) / width;
        return std::exp(-glm::dot(d, d));
    };
    const double tower = 60.0 * bell({14.3, 17.1, 8.6}, {3.1, 2.7, 2.5});
    const double veil = 0.2 * bell({16.4, 15.2, 15.7}, {4.2, 4.4, 2.1});
    return tower + veil > 1e-3 ? tower + veil : 0.0;
}

/// The same cloud at the same voxels of the world; faces of bricks are `shift` voxels to the west,
/// to the south and below.
SpeciesVolume cloud(int shift) {
    SpeciesVolume volume;
    volume.grid = {kSize + kFaceEvery, -static_cast<double>(shift) * kVoxelM, kVoxelM};
    Array3f content(volume.grid.size);
    for (int z = 0; z < content.size.z; ++z)
        for (int y = 0; y < content.size.y; ++y)
            for (int x = 0; x < content.size.x; ++x) {
                // 150 m²/kg for droplets of 10 µm.
                const glm::dvec3 voxel = glm::dvec3(x, y, z) - static_cast<double>(shift);
                content.at(x, y, z) = static_cast<float>(depthAt(voxel) / kVoxelM.z / 150.0);
            }
    volume.contentKgPerM3[0] = content;
    return volume;
}

/// From so far that the faces of bricks are seen edge-on; a voxel is kVoxelPx pixels wide.
Camera far(bool above) {
    const glm::dvec3 middleM = 0.5 * glm::dvec3(kSize) * kVoxelM;
    const double distanceM = 2000e3;
    Camera camera;
    camera.eyeWorld = middleM + glm::dvec3(0.0, 0.0, above ? distanceM : -distanceM);
    camera.forward = {0.0, 0.0, above ? -1.0 : 1.0};
    camera.right = {1.0, 0.0, 0.0};
    camera.up = {0.0, above ? 1.0 : -1.0, 0.0};
    camera.tanHalfFovY = middleM.y / distanceM;
    camera.aspect = 1.0;
    return camera;
}

struct Gradients {
    double onFaces = 0.0, off = 0.0;  ///< summed over the same places
};

double luminance(glm::vec4 p) {
    return glm::dot(glm::dvec3(p), glm::dvec3(0.2126, 0.7152, 0.0722));
}

/// Of columns of pixels at walls of voxels, the difference from one pixel to the next: each wall is
/// on a face of a brick for one of the shifts and off for the others.
Gradients gradientsIn(const std::array<ImageF, kFaceEvery>& images) {
    Gradients sum;
    for (int voxel = 1; voxel < kSize.x; ++voxel) {
        for (int shift = 0; shift < kFaceEvery; ++shift) {
            const ImageF& image = images[static_cast<std::size_t>(shift)];
            double difference = 0.0;
            for (int y = 0; y < image.size.y; ++y) {
                const auto right = static_cast<std::size_t>(y * image.size.x + voxel * kVoxelPx);
                difference +=
                    std::abs(luminance(image.pixels[right]) - luminance(image.pixels[right - 1]));
            }
            const bool face = (voxel + shift) % kFaceEvery == 0;
            (face ? sum.onFaces : sum.off) += face ? difference : difference / (kFaceEvery - 1);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("An image has no more of a gradient on faces of bricks than off them") {
    for (const bool above : {true, false}) {
        for (const float quality : {0.5f, 1.0f}) {
            CAPTURE(above);
            CAPTURE(quality);
            std::array<ImageF, kFaceEvery> images;
            for (int shift = 0; shift < kFaceEvery; ++shift) {
                const SpeciesVolume volume = cloud(shift);
                render::FrameInputs inputs;
                inputs.look = plainLook();
                inputs.look.groundVisible = false;
                inputs.look.engine = Engine::march;
                inputs.sizePx = kImagePx;
                inputs.sampling.quality = quality;
                inputs.camera = far(above);
                images[static_cast<std::size_t>(shift)] = averageOn(volume, inputs, 4);
            }
            const Gradients gradients = gradientsIn(images);
            REQUIRE(gradients.off > 1.0);  // there is something to see
            CHECK(gradients.onFaces < 1.02 * gradients.off);
        }
    }
}
