// fuzz_camera.cpp: any file is a camera, a preset with one, a camera path, or an Error. A path that
// was read can be written and read again, and has a valid pose at any time.
#include <cstdlib>

#include "core/base/error.h"
#include "core/camera/camera_format.h"
#include "core/preset/preset.h"
#include "tests/fuzz/scratch.h"

namespace {

void readPath(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    const neph::CameraPath path = neph::loadCameraPath(file, warnings);
    if (neph::parseCameraPath(neph::formatCameraPath(path), "again", warnings) != path) {
        std::abort();
    }
    const neph::RegularGrid grid{{8, 8, 4}, {0.0, 0.0, 0.0}, {1e3, 1e3, 500.0}};
    for (int i = 0; i < 8; ++i) {
        const neph::CameraPose pose = neph::poseAt(path, grid, neph::durationS(path) * i / 7.0);
        neph::parseCamera(neph::formatCamera(pose), "there", warnings);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    const auto file = scratch.write("camera.json", fuzz::asText({bytes, count}));
    try {
        std::vector<std::string> warnings;
        neph::loadCamera(file.string(), warnings);
    } catch (const neph::Error&) {  // expected for invalid input
    }
    try {
        readPath(file);
    } catch (const neph::Error&) {
    }
    return 0;
}
