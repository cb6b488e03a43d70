// frame_block.cpp: from inputs, plan and medium to the block.
#include "app/render/frame/frame_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/look/exposure.h"
#include "core/look/sun.h"

namespace neph::render {
namespace {

using glm::dvec3, glm::vec2, glm::vec3, glm::vec4;
static_assert(sizeof(FrameBlock) == 37 * 16 + block::kMaxClasses * 48, "std140 and C++ agree");

constexpr float kOpaque = 1e-4f;  // transmittance below which the slices' eye sees no further
constexpr double kRingShare = 3.0 / 8.0;  // of θ_f: the middle of the ring. docs/physics.md §3

vec4 v4(dvec3 v, double w = 0.0) {
    return {vec3(v), static_cast<float>(w)};
}

block::ClassBlock classBlock(const MediumClass& c) {
    const vec2 perTile = 1.0f / (glsl::kDetailFeaturesPerTile * c.noiseScaleM * c.noiseFit);
    const float character = c.noiseCharacter == NoiseCharacter::billow ? 0.0f : 1.0f;
    return {vec4(c.colour * c.albedo, c.albedo),
            vec4(c.noiseAmount, perTile.x, character, perTile.y), vec4(0.0f)};
}

/// Whole widths of a domain between an eye and the domain.
dvec3 widthsTo(dvec3 eyeM, const RegularGrid& grid) {
    const dvec3 widthM = grid.extentM();
    return {std::floor(eyeM.x / widthM.x) * widthM.x, std::floor(eyeM.y / widthM.y) * widthM.y,
            0.0};
}

void fillView(FrameBlock& block, const FrameInputs& inputs, const RegularGrid& grid,
              const SlicePlan& plan) {
    const Camera& camera = inputs.camera;
    dvec3 eyeM = camera.eyeWorld - grid.originM;
    const dvec3 shiftedM = sidesRepeat(inputs.look) ? widthsTo(eyeM, grid) : dvec3(0.0);
    eyeM -= shiftedM;
    block.eyeM = v4(eyeM, grid.originM.z);
    block.shifted = v4(shiftedM);
    block.forward = v4(camera.forward, plan.frontToBack ? 1.0 : -1.0);
    block.right = v4(camera.right * camera.tanHalfFovY * camera.aspect);
    block.up = v4(camera.up * camera.tanHalfFovY);
}

void fillLight(FrameBlock& block, const Look& look, const SlicePlan& plan) {
    const ForwardShares shares = forwardShares(look);
    const double ringM =
        plan.lightStepM *
        std::tan(glm::radians(static_cast<double>(look.forwardAngleDeg)) * kRingShare);
    block.normal = v4(plan.normal, plan.firstM);
    block.towardsSun = v4(sunDirWorld(look), plan.lightStepM);
    block.lightU = v4(plan.lightU, plan.lightLowerM.x);
    block.lightV = v4(plan.lightV, plan.lightLowerM.y);
    block.lightScale = vec4(vec2(1.0 / plan.lightExtentM), plan.spacingM, ringM);
    block.forwardShare = {shares.inner, shares.outer, kOpaque, 0.0f};
}

void fillAtmosphere(FrameBlock& block, const Look& look, double eyeAltitudeM,
                    const SkyTextures& sky) {
    const auto altitudeM = static_cast<float>(eyeAltitudeM);
    const float intensity = shownIntensity(look);
    const vec4 sun(vec3(intensity), 0.0f);
    block.sky = {1.0f, glsl::horizonSine(altitudeM), glsl::bendPerM(altitudeM), intensity};
    block.sunRadiance = block.skyZenith = block.skyHorizon = sun;
    block.skyZenith.w = static_cast<float>(look.groundSurface);
    block.disc = v4(discDirWorld(look, eyeAltitudeM));
    if (look.sunDisc) block.discLight = v4(discIrradiance(look, eyeAltitudeM));
    const bool moon = showsMoon(look);
    block.moon = v4(moon ? sunOfMoonWorld(look) : dvec3(0.0), moon ? 1.0 : 0.0);
    // Full light, an irradiance of 4 pi, makes a radiance of 1.
    const vec3 onGround(sky.tables().skyOnGround);
    block.ambient = vec4(4.0f * look.skylight * intensity * onGround, 0.0f);
}

void fillGradient(FrameBlock& block, const Look& look) {
    const vec3 zenith = look.skyZenith * look.skyIntensity;
    const vec3 horizon = look.skyHorizon * look.skyIntensity;
    block.sunRadiance = vec4(look.sunColour * look.sunIntensity, 0.0f);
    block.skyZenith = vec4(zenith, 0.0f);
    block.skyHorizon = vec4(horizon, 0.0f);
    block.ambient = vec4(0.5f * (zenith + horizon) * look.skylight, 0.0f);
}

}  // namespace

FrameBlock makeFrameBlock(const FrameInputs& inputs, const RegularGrid& grid,
                          const BrickMap& bricks, const MediumPlan& medium, const SlicePlan& slices,
                          const SkyTextures& sky) {
    FrameBlock block{};
    fillView(block, inputs, grid, slices);
    fillLight(block, inputs.look, slices);
    if (sky.hasAir()) {
        fillAtmosphere(block, inputs.look, inputs.camera.eyeWorld.z, sky);
    } else {
        fillGradient(block, inputs.look);
    }
    const float visible = inputs.look.groundVisible ? 1.0f : 0.0f;
    block.ground = vec4(shownGroundColour(inputs.look), visible);
    block.moved = v4({grid.movedM, 0.0});
    block.boxLowerM = v4(bricks.occupied.lowerM);
    block.boxUpperM = v4(bricks.occupied.upperM);
    block.gridExtentM = v4(grid.extentM());
    block.mixtureExtentM = v4(dvec3(2 * ((grid.size + 1) / 2)) * grid.spacingM);
    if (medium.repeats) {
        block.mixtureExtentM.x = block.gridExtentM.x;
        block.mixtureExtentM.y = block.gridExtentM.y;
    }
    block.brickM = v4(bricks.brickM);
    block.slices = {slices.count, 0, 0, static_cast<int>(medium.classes.size())};
    block.sampling = {0, inputs.backdrop ? 1 : 0, 0, 0};
    block.image = {inputs.sizePx, slices.lightSizePx};
    const ImagePart part = inputs.part.value_or(ImagePart{inputs.sizePx, {0, 0}});
    block.whole = {part.wholePx, part.lowerPx};
    for (std::size_t i = 0; i < medium.classes.size(); ++i) {
        block.classes[i] = classBlock(medium.classes[i]);
    }
    return block;
}

bool isNoisy(const MediumPlan& medium) {
    return std::any_of(medium.classes.begin(), medium.classes.end(),
                       [](const MediumClass& c) { return c.noiseAmount > 0.0f; });
}

std::vector<std::string> lightDefines(const Look& look, const MediumPlan& medium, bool consistent) {
    // An array has at least one element.
    return {fmt::format("CLASSES {}", std::max<std::size_t>(medium.classes.size(), 1)),
            fmt::format("NOISE {}", isNoisy(medium) ? 1 : 0),
            fmt::format("TRANSLUCENT {}", look.transport == Transport::lowAlbedo ? 0 : 1),
            fmt::format("CONSISTENT {}", consistent ? 1 : 0)};
}

}  // namespace neph::render
