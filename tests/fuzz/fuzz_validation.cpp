// fuzz_validation.cpp: any text is a scene to measure or an Error. Detectors are within its grid.
#include <cstdlib>

#include "app/validate/scene_file.h"
#include "core/base/error.h"
#include "tests/fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const fuzz::Scratch scratch;
    try {
        const auto file =
            neph::validate::parseSceneFile(fuzz::asText({bytes, count}), "fuzz", scratch.folder());
        for (const neph::validate::Trial& trial : neph::validate::trialsOf(file, "fuzz")) {
            const glm::dvec3 extentM = glm::dvec3(trial.scene.size) * trial.scene.spacingM;
            for (const auto& detector : trial.detectors) {
                const glm::bvec3 inside =
                    glm::lessThanEqual(detector.box.upperM, extentM * 1.000001);
                if (!glm::all(inside)) std::abort();
            }
            for (const neph::validate::Quantity& quantity : trial.quantities) {
                for (const neph::validate::Term& term : quantity.terms) {
                    if (term.detector >= trial.detectors.size()) std::abort();
                }
            }
        }
    } catch (const neph::Error&) {  // expected for invalid input
    }
    return 0;
}
