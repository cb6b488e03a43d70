// march_defines.h: the macros of the march's passes.
#pragma once
#include <string>
#include <vector>

#include "app/render/engines/march/packed_medium.h"
#include "app/render/frame/frame_inputs.h"

namespace neph::render {

/// Of all passes that read the medium.
std::vector<std::string> marchDefines(const Look& look, const PackedMedium& medium);

/// Of march/eye.comp. `balanced`: DiffuseLight::isBalanced; `floor`: it only repeats the samples of
/// an image.
std::vector<std::string> eyeDefines(const FrameInputs& inputs, const PackedMedium& medium,
                                    bool balanced, bool floor);

}  // namespace neph::render
