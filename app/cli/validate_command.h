// validate_command.h: `nephoscope validate`: proof that the path tracer is right, or what it says
// of a scene of the user's.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace neph {

struct ValidateRequest {
    std::vector<std::string> files;  ///< none: all that is bundled and built in
    std::string only;                ///< part of the names of what is to be run
    bool quick = false, json = false;
    std::uint64_t samples = 0;  ///< paths per detector, at least; 0: as many as are needed
};

/// Prints a table, or JSON; 0 when all is as expected, else 1. Throws Error.
int runValidate(const ValidateRequest& request);

}  // namespace neph
