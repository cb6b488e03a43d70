// progress.h: how long work says how far it is, and how it is told to stop.
#pragma once
#include <functional>

namespace neph {

/// Called with a fraction in [0, 1]; returns false to cancel. May be empty.
using Progress = std::function<bool(double)>;

/// Reports and says whether to go on.
inline bool goOn(const Progress& progress, double fraction) {
    return !progress || progress(fraction);
}

/// Thrown out of work whose progress callback returned false.
struct Cancelled {};

}  // namespace neph
