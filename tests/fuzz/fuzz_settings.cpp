// fuzz_settings.cpp: any settings file is read or causes a warning. Settings that were read can be
// saved and read again, and their memory setting is a size or an Error.
#include <cstdlib>

#include "core/base/error.h"
#include "core/session/settings.h"
#include "core/volume/memory_setting.h"
#include "tests/fuzz/scratch.h"

namespace {

void setUp(const fuzz::Scratch& scratch) {
    std::filesystem::create_directories(scratch.folder() / "nephoscope");
    setenv("XDG_CONFIG_HOME", scratch.folder().c_str(), 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    static const bool ready = (setUp(scratch), true);
    scratch.write("nephoscope/settings.json", fuzz::asText({bytes, count}));
    std::vector<std::string> warnings;
    const neph::Settings settings = neph::loadSettings(warnings);
    if (!ready || !warnings.empty()) return 0;
    neph::saveSettings(settings);
    if (neph::loadSettings(warnings) != settings || !warnings.empty()) std::abort();
    try {
        neph::parseMemory(settings.memory, 1U << 30U);
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
