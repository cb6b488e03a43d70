// march_defines.cpp: from look and medium to macros.
#include "app/render/engines/march/march_defines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/render/frame/frame_block.h"
#include "app/render/medium/detail_kinds.h"

namespace neph::render {
namespace {

DetailKinds kindsOf(const MediumPlan& plan) {
    std::vector<Detail> details;
    for (const MediumClass& c : plan.classes) {
        details.push_back({c.noiseAmount, c.noiseScaleM, c.noiseFit, c.noiseCharacter});
    }
    return render::kindsOf(details);
}

}  // namespace

std::vector<std::string> marchDefines(const Look& look, const PackedMedium& medium) {
    Look carried = look;  // what reaches a place straight from the sun is solved no further
    if (scattersOften(look)) carried.transport = Transport::lowAlbedo;
    std::vector<std::string> names = lightDefines(carried, medium.plan, true);
    names.push_back("PACKED 1");
    if (scattersOften(look)) names.push_back("FULL 1");
    if (sidesRepeat(look)) names.push_back("PERIODIC 1");
    names.push_back("LIGHT_FORMAT r16");
    names.push_back(fmt::format("MIXTURE_TEXTURES {}", medium.mixtureCount()));
    return names;
}

std::vector<std::string> eyeDefines(const FrameInputs& inputs, const PackedMedium& medium,
                                    bool balanced, bool floor) {
    std::vector<std::string> names = marchDefines(inputs.look, medium);
    names.push_back(fmt::format("BALANCED {}", balanced ? 1 : 0));
    names.push_back(fmt::format("PROFILE {}", inputs.profile && !floor ? 1 : 0));
    names.push_back(fmt::format("FLOOR {}", floor ? 1 : 0));
    names.push_back(fmt::format("ADAPTIVE {}", inputs.planes > 0 ? 0 : 1));
    if (!isNoisy(medium.plan)) return names;
    const DetailKinds kinds = kindsOf(medium.plan);
    names.push_back(fmt::format("KINDS {}", kinds.first.size()));
    names.push_back(fmt::format("KIND_OF_CLASS int[]({})", fmt::join(kinds.of, ", ")));
    names.push_back(fmt::format("CLASS_OF_KIND int[]({})", fmt::join(kinds.first, ", ")));
    return names;
}

}  // namespace neph::render
