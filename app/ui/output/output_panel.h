// output_panel.h: the export dialogue, and the export that runs.
#pragma once
#include "app/ui/output/output_plan.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// `scene`: what of the window an export depends on now.
void drawOutput(const PanelContext& context, OutputState& output, const ExportScene& scene);

}  // namespace neph::ui
