// fuzz_preset.cpp: any text is a preset or an Error. A preset that was read can be written and read
// again.
#include <cstdlib>

#include "core/base/error.h"
#include "core/preset/preset.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    try {
        const neph::Preset preset = neph::parsePreset(fuzz::asText({bytes, count}), "fuzz").preset;
        if (neph::parsePreset(neph::formatPreset(preset), "again").preset != preset) std::abort();
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
