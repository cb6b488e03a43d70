// ask_run.h: the work of the commands that ask data. Each returns the exit status and throws Error
// or UsageError.
#pragma once
#include "app/cli/ask/ask_request.h"

namespace neph {

int runProbe(const ProbeRequest& request);
int runProfile(const ProfileRequest& request);
int runSection(const SectionRequest& request);
int runSeries(const SeriesRequest& request);

}  // namespace neph
