// box.h: a part of a field, and what is told between its pieces.
#pragma once
#include <functional>

#include "readers/shared/box.h"

namespace les {

/// Called between pieces with the fraction done, 0 to 1; throws Cancelled to stop.
using Tick = std::function<void(double)>;

using shared::Box;

}  // namespace les
