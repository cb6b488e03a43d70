// known_error.cpp: the least and the largest bias in the views of docs/accuracy.md.
#include "core/look/known_error.h"

#include <fmt/format.h>

namespace neph {

std::string knownErrorText(const Look& look) {
    const EngineTraits& engine = traitsOf(look.engine);
    if (!engine.singleScattering || scattersOften(look)) return {};
    if (look.phaseDisplay != PhaseDisplay::physical) return "phase for display: not a radiance";
    if (look.transport == Transport::lowAlbedo) return "light scattered once: 17 to 72 % too dark";
    return "forward scattering alone: 70 % too dark to 54 % too bright";
}

}  // namespace neph
