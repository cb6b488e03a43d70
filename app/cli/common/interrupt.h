// interrupt.h: Ctrl+C and being told to end, as a question that long work asks.
#pragma once
#include "core/base/progress.h"

namespace neph {

/// From now on SIGINT, SIGTERM and SIGHUP are noted; a second SIGINT ends the program. Writing to a
/// pipe that nobody reads is no signal but a failed write.
void noteInterrupts();

/// The signal that was noted; 0 for none.
int interruptSignal();

/// Says whether to go on: until a signal is noted.
Progress untilInterrupted();

}  // namespace neph
