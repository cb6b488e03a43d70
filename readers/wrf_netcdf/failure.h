// failure.h: bad input, in the parts that the ABI carries to the host. Thrown inside this reader,
// never through its door.
#pragma once
#include <string>

namespace wrf {

struct Failure {
    std::string what, found, expected, hint;
};

/// Thrown when the host's progress callback asks to stop.
struct Cancelled {};

}  // namespace wrf
