// fuzz_session.cpp: any text is a session or an Error. A session that was read can be written and
// read again.
#include <cstdlib>

#include "core/base/error.h"
#include "core/session/session_file.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::filesystem::path folder = "/nephoscope-fuzz/sessions";
    std::vector<std::string> warnings;
    neph::SessionState state;
    try {
        state = neph::parseSession(fuzz::asText({bytes, count}), "fuzz", folder, warnings);
    } catch (const neph::Error&) {  // expected for invalid input
        return 0;
    }
    const std::string text = neph::formatSession(state, folder);
    if (neph::parseSession(text, "again", folder, warnings) != state) std::abort();
    return 0;
}
