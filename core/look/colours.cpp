// colours.cpp: two sets of colours, and the transfer function of sRGB.
#include "core/look/colours.h"

#include <cmath>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

/// Inverse of srgbEncode; IEC 61966-2-1.
float srgbDecode(float x) {
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

glm::vec3 srgbFromLinear(const glm::vec3& linear) {
    return {glsl::srgbEncode(linear.r), glsl::srgbEncode(linear.g), glsl::srgbEncode(linear.b)};
}

glm::vec3 linearFromSrgb(const glm::vec3& srgb) {
    return {srgbDecode(srgb.r), srgbDecode(srgb.g), srgbDecode(srgb.b)};
}

glm::vec3 fieldColour(FieldColours colours, Species species) {
    const SpeciesInfo& known = info(species);
    if (colours == FieldColours::table2) {
        return {known.colour[0], known.colour[1], known.colour[2]};
    }
    const auto& srgb = known.accessibleColour;
    return linearFromSrgb(glm::vec3(srgb[0], srgb[1], srgb[2]) / 255.0f);
}

bool hasFieldColours(const Look& look, FieldColours colours) {
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        if (look.of(species).colour != fieldColour(colours, species)) return false;
    }
    return true;
}

void setFieldColours(Look& look, FieldColours colours) {
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        look.of(species).colour = fieldColour(colours, species);
    }
}

}  // namespace neph
