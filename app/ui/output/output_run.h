// output_run.h: starting an export in the background, and looking after it.
#pragma once
#include "app/ui/output/output_plan.h"
#include "app/ui/panel/panel_context.h"

namespace neph::ui {

/// Whether one runs; there is one at a time.
bool exports(const OutputState& output);

/// Starts what the settings say, under a name that is free. Faults become messages.
void startExport(const PanelContext& context, OutputState& output, const ExportSettings& settings,
                 const ExportScene& scene);

/// The image of the window, with what else was set last.
void exportImage(const PanelContext& context, OutputState& output, const ExportScene& scene);

/// Takes in what it said, and tells its end. To be called in every frame.
void updateExport(const PanelContext& context, OutputState& output);

/// Whether the window may close: no export runs, or it was said what is to become of it. Asks
/// otherwise.
bool mayQuit(OutputState& output);

/// Answers to that: the window closes in any case, unless a fault is to be told.
void quitAfterExport(const PanelContext& context, OutputState& output);
void quitAndStopExport(const PanelContext& context, OutputState& output);
void quitAndLeaveExport(const PanelContext& context, OutputState& output);

/// What is left of one that was stopped.
std::string stoppedText(const ExportJob& job);

}  // namespace neph::ui
