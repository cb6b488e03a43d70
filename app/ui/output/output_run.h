// output_run.h: starting an export beside the window, and looking after it.
#pragma once
#include "app/ui/output/output_plan.h"

namespace neph::ui {

/// Whether one runs; there is one at a time.
bool exports(const Ui& ui);

/// Starts what the settings say, under a name that is free. Faults become messages.
void startExport(Ui& ui, const ExportSettings& settings);

/// The picture of the window, with what else was set last.
void exportPicture(Ui& ui);

/// Takes in what it said, and tells its end. To be called in every frame.
void updateExport(Ui& ui);

/// What is left of one that was stopped.
std::string stoppedText(const ExportJob& job);

/// What an export of the window depends on.
ExportScene exportSceneOf(const Ui& ui);

}  // namespace neph::ui
