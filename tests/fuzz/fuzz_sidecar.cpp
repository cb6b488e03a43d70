// fuzz_sidecar.cpp: any text is a sidecar with consistent numbers, or an Error.
#include <cmath>
#include <cstdlib>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/sidecar.h"
#include "tests/fuzz/scratch.h"

namespace {

/// What the rest of the reader relies on.
bool fits(const les::Sidecar& sidecar) {
    bool good = sidecar.interfacesM.size() == sidecar.shape[2] + 1 && !sidecar.times.empty();
    for (const double spacing : sidecar.spacingM) good = good && std::isfinite(spacing);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::vector<double>& edges = sidecar.edgesM[axis];
        if (edges.empty()) continue;
        good = good && edges.size() == sidecar.shape[axis] + 1 && edges.front() == 0.0;
        good = good && std::isfinite(edges.back());
    }
    for (const les::BrickVariable& variable : sidecar.variables) {
        const std::size_t files = variable.files.size();
        good = good && (files <= 1 || files == sidecar.times.size());
        good = good && std::isfinite(variable.scale) && std::isfinite(variable.offset);
    }
    return good;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = fuzz::asText({bytes, count});
    les::looksLikeSidecar(text);
    try {
        if (!fits(les::parseSidecar(text))) std::abort();
    } catch (const neph::plugin::Error&) {  // expected for invalid input
    }
    return 0;
}
