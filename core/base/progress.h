// progress.h: how long-running work reports progress and is cancelled.
#pragma once
#include <functional>

namespace neph {

/// Called with a fraction in [0, 1]; returns false to cancel. May be empty.
using Progress = std::function<bool(double)>;

/// Reports progress; false if the work should stop.
inline bool goOn(const Progress& progress, double fraction) {
    return !progress || progress(fraction);
}

/// Thrown by work whose progress callback returned false.
struct Cancelled {};

}  // namespace neph
