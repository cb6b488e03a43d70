// look.cpp: the defaults that follow from the species.
#include "core/look/look.h"

namespace neph {

Look::Look() {
    for (int i = 0; i < kSpeciesCount; ++i) {
        const auto s = static_cast<Species>(i);
        const SpeciesInfo& known = info(s);
        SpeciesLook& field = of(s);
        field.effectiveRadiusM = known.radiusM;
        field.densityKgPerM3 = known.densityKgPerM3;
        field.colour = {known.colour[0], known.colour[1], known.colour[2]};
        field.phase.kind = known.liquid ? PhaseKind::waterDroplets : PhaseKind::roughAggregate;
        field.phase.radiusM = known.phaseRadiusM;
        field.noiseCharacter = known.liquid ? NoiseCharacter::billow : NoiseCharacter::wisp;
        field.noiseAmount = 0.6f;  // tuned by eye
    }
}

bool scattersOften(const Look& look) {
    return look.transport == Transport::full && traitsOf(look.engine).scattersOften;
}

bool showsRadiance(const Look& look) {
    return scattersOften(look) || look.phaseDisplay == PhaseDisplay::physical;
}

glm::vec3 shownGroundColour(const Look& look) {
    // An albedo of 0.04, as of a high sun [Jin04], most of it in blue; four times as in
    // groundAlbedo.
    constexpr glm::vec3 kSea{0.12f, 0.16f, 0.24f};
    const bool sea =
        look.skyModel == SkyModel::atmosphere && look.groundSurface == GroundSurface::sea;
    return sea ? kSea : look.groundColour;
}

glm::vec3 groundAlbedo(const Look& look) {
    // Full light is an irradiance of 4 pi.
    return glm::clamp(0.25f * shownGroundColour(look), 0.0f, 1.0f);
}

bool sidesRepeat(const Look& look) {
    return look.domainSides == DomainSides::periodic && traitsOf(look.engine).periodicSides;
}

}  // namespace neph
