// measure_error.h: when the error of the image on screen is measured: on request, and at rest.
#pragma once
#include <functional>

#include "app/ui/shell/ui.h"
#include "app/workbench/slots.h"

namespace neph {

/// Goes on measuring for a moment, where it is wanted and `idle` says that there is nothing else to
/// do; `inputWaits` ends the moment. Whether there is more to be done at once.
bool measureError(ui::Ui& ui, Slots& slots, bool idle, const std::function<bool()>& inputWaits);

}  // namespace neph
