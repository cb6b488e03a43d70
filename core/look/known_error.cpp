// known_error.cpp: the least and the largest bias in the views of docs/accuracy.md.
#include "core/look/known_error.h"

#include <fmt/format.h>

namespace neph {

namespace {

std::string ofScattering(const Look& look) {
    const EngineTraits& engine = traitsOf(look.engine);
    if (!engine.singleScattering || scattersOften(look)) return {};
    if (look.phaseDisplay != PhaseDisplay::physical) return "phase for display: not a radiance";
    if (look.transport == Transport::lowAlbedo) return "light scattered once: 17 to 72 % too dark";
    return "forward scattering alone: 70 % too dark to 54 % too bright";
}

}  // namespace

std::string knownErrorText(const Look& look) {
    std::string text = ofScattering(look);
    if (look.domainSides == DomainSides::open || sidesRepeat(look)) return text;
    return fmt::format("{}{}sides are open", text, text.empty() ? "" : "; ");
}

}  // namespace neph
