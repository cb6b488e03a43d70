// info_shown.cpp: the plan that `render` and the workbench would make.
#include "app/cli/info/info_shown.h"

#include "app/cli/common/scene.h"
#include "app/gl/context.h"
#include "core/base/error.h"
#include "core/volume/nested_volume.h"

namespace neph {
namespace {

/// What the renderer of this machine may take; as much as there was where it has none.
void boundByRenderer(MemoryBudget& budget) {
    try {
        const gl::HeadlessContext context;
        budget.gpu = rendererBytes(gl::deviceMemory());
    } catch (const Error&) {  // images are then made elsewhere
    }
}

}  // namespace

std::string shownHere(Dataset& dataset, int time, MemoryBudget budget) {
    ReadPlan plan = planShown(dataset, time, {}, budget);
    if (plan.gpuBytes > kSoftwareGpuBytes) {
        boundByRenderer(budget);
        plan = planShown(dataset, time, {}, budget);
    }
    const std::string text = describe(plan, dataset.info());
    return text.empty() ? "at full resolution" : text;
}

}  // namespace neph
