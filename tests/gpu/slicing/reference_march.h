// reference_march.h: the equations of the slicing engine once more, in double precision, one plain
// loop at a time.
//
// Shares with the engine what is geometry (planSlices) and what is a table (phase, noise); every
// equation is its own.
#pragma once
#include "app/render/frame/frame_inputs.h"
#include "core/grid/species.h"
#include "core/image/image.h"

namespace neph::test {

/// The linear image that Renderer::readLinear gives.
ImageF referenceMarch(const SpeciesVolume& volume, const render::FrameInputs& inputs);

}  // namespace neph::test
