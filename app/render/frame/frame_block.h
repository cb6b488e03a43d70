// frame_block.h: the numbers of a frame as the shaders see them, for either engine.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/render/frame/frame_inputs.h"
#include "app/render/light/slice_plan.h"
#include "app/render/medium/brick_map.h"
#include "app/render/sky/sky_textures.h"
#include "core/grid/species.h"
#include "core/look/medium.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::render {
namespace block {
using namespace glm;
#include "shaders/shared/frame_block.glsl"
}  // namespace block
using block::FrameBlock;

/// All but what is an engine's own: `slices.yz`, `sampling.x`, `march`, what is known of voxels of
/// light, and `forward` of the classes.
FrameBlock makeFrameBlock(const FrameInputs& inputs, const RegularGrid& grid,
                          const BrickMap& bricks, const MediumPlan& medium, const SlicePlan& slices,
                          const SkyTextures& sky);

/// Whether any class has detail.
bool isNoisy(const MediumPlan& medium);

/// Macros of the light pass that do not depend on how the medium is stored.
std::vector<std::string> lightDefines(const Look& look, const MediumPlan& medium, bool consistent);

}  // namespace neph::render
