// cloudy_air.cpp: keeping what the light's slices leave, and where the eye may meet air that clouds
// shade or light.
#include "app/render/engines/march/cloudy_air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace neph::render {

#include "shaders/shared/march_layout.glsl"

namespace {

/// Of the table along a ray.
constexpr int kLayers = 48;
/// Rays are so many pixels apart where the image has 64 in between, up to a most.
constexpr int kNodesPerHeight = 64, kLeastPixels = 2, kMostPixels = 8;
/// Above, air is too thin to show a shadow.
constexpr double kHighestShadowM = 30e3;

int layersOf(const SlicePlan& plan) {
    return (plan.count + kSlicesPerSunThrough - 1) / kSlicesPerSunThrough + 1;
}

/// Nearest and farthest distance at which clouds matter to the air: around the box, and of its
/// shadow down to the ground, or up to where air ends.
glm::vec2 reachOf(const FrameBlock& block, bool repeats) {
    const double farthestM = static_cast<double>(glsl::kAirRangeM);
    const glm::dvec3 eye(block.eyeM), sun(block.towardsSun);
    if (repeats) return {0.0, farthestM};
    const glm::dvec3 boxLower(block.boxLowerM), boxUpper(block.boxUpperM);
    const glm::dvec3 around = 0.5 * (boxUpper - boxLower);
    glm::dvec3 lower(std::numeric_limits<double>::max()), upper(-lower);
    double farM = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 high(corner & 1, corner & 2, corner & 4);
        const glm::dvec3 at = glm::mix(boxLower - around, boxUpper + around, glm::dvec3(high));
        const double altitudeM = at.z + static_cast<double>(block.eyeM.w);
        const double fallM = sun.z > 0.0 ? altitudeM : altitudeM - kHighestShadowM;
        const double lengthM = sun.z == 0.0 ? farthestM : std::clamp(fallM / sun.z, 0.0, farthestM);
        for (const glm::dvec3& end : {at, at - lengthM * sun}) {
            lower = glm::min(lower, end);
            upper = glm::max(upper, end);
            farM = std::max(farM, glm::length(end - eye));
        }
    }
    const double nearM = glm::length(glm::max(glm::max(lower - eye, eye - upper), 0.0));
    return {static_cast<float>(std::min(nearM, farthestM)),
            static_cast<float>(std::min(farM, farthestM))};
}

glm::ivec3 sizeOf(const FrameBlock& block) {
    const int pixels = static_cast<int>(block.cloudyAir.z);
    const glm::ivec2 lower(block.whole.z, block.whole.w);
    const glm::ivec2 first = lower / pixels;
    const glm::ivec2 last = (lower + glm::ivec2(block.image) + pixels - 1) / pixels;
    return {last - first + 1, kLayers};
}

}  // namespace

void CloudyAir::open(const SlicePlan& plan) {
    const glm::ivec3 size{(plan.lightSizePx + 1) / 2, layersOf(plan)};
    if (through_.size() == size && repeats_ == plan.repeats) return;
    repeats_ = plan.repeats;
    through_ = gl::Texture::make3D(GL_R16, size);
    through_.setLinear();
    if (plan.repeats) through_.setRepeat();
}

void CloudyAir::keep(const SlicePlan& plan, int first, int slices, const gl::Program& program) {
    through_.bindImage(kSunThroughImage, GL_WRITE_ONLY);
    const glm::ivec3 size = through_.size();
    for (int layer = 0; layer < size.z; ++layer) {
        const int slice = std::min(kSlicesPerSunThrough * layer, plan.count);
        // The first layer of a batch is the last of the one before.
        if (slice < first || slice > first + slices) continue;
        program.setInt(kSunThroughLayerLocation, layer);
        program.dispatch({size.x, size.y, 1});
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void CloudyAir::fill(FrameBlock& block, bool repeats) {
    const glm::vec2 reachM = reachOf(block, repeats);
    const int pixels = std::clamp(block.whole.y / kNodesPerHeight, kLeastPixels, kMostPixels);
    block.cloudyAir = {reachM, static_cast<float>(pixels), reachM.x < reachM.y ? 1.0f : 0.0f};
}

void CloudyAir::look(const FrameBlock& block, const gl::Program& program) {
    const glm::ivec3 size = sizeOf(block);
    if (change_.size() != size) {
        change_ = gl::Texture::make3D(GL_RGBA16F, size);
        change_.setLinear();
    }
    through_.bind(kSunThroughUnit);
    change_.bindImage(kCloudyAirImage, GL_WRITE_ONLY);
    program.dispatch({size.x, size.y, 1});
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    change_.bind(kCloudyAirUnit);
}

}  // namespace neph::render
