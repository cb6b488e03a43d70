// fuzz_camera.cpp: any file is a camera, a preset with one, or an Error.
#include "core/error.h"
#include "core/preset.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const auto file = scratch.write("camera.json", fuzz::asText({bytes, count}));
    try {
        std::vector<std::string> warnings;
        neph::loadCamera(file.string(), warnings);
    } catch (const neph::Error&) {  // the expected answer to nonsense
    }
    return 0;
}
