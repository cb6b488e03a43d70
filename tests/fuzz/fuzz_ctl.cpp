// fuzz_ctl.cpp: any text is a GrADS descriptor or an Error, and so are the cells of its axes.
#include <cmath>
#include <cstdlib>

#include "core/plugin/reader_plugin.h"
#include "readers/les/levels.h"
#include "readers/raw_les/grads_ctl.h"
#include "tests/fuzz/scratch.h"

namespace {

/// Aborts unless the faces of the cells of an axis increase from 0.
void makeCells(const les::CtlAxis& axis) {
    std::vector<double> centres;
    for (std::size_t i = 0; i < std::min<std::size_t>(axis.count, 1000); ++i) {
        centres.push_back(axis.at(i));
    }
    if (les::evenStep(centres)) return;
    const std::vector<double> faces = les::facesOf("axis", centres);
    if (faces.size() != centres.size() + 1 || faces.front() != 0.0) std::abort();
    for (std::size_t i = 1; i < faces.size(); ++i) {
        if (!(faces[i] > faces[i - 1]) || !std::isfinite(faces[i])) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    les::looksLikeCtl(text);
    try {
        const les::Ctl ctl = les::parseCtl(text);
        makeCells(ctl.x);
        makeCells(ctl.y);
    } catch (const neph::plugin::Error&) {  // expected for invalid input
    }
    return 0;
}
