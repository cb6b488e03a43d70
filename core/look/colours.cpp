// colours.cpp: two sets of six colours, and the transfer function of sRGB.
#include "core/look/colours.h"

#include <array>
#include <cmath>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

/// sRGB of 8 bits, in the order of Species. [OkabeIto08]: vermillion for red, reddish purple for
/// magenta, blue, yellow, bluish green for green, sky blue for cyan.
constexpr std::array<glm::ivec3, kSpeciesCount> kOkabeIto{
    {{213, 94, 0}, {204, 121, 167}, {0, 114, 178}, {240, 228, 66}, {0, 158, 115}, {86, 180, 233}}};

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
    const auto& table2 = info(species).colour;
    if (colours == FieldColours::table2) return {table2[0], table2[1], table2[2]};
    return linearFromSrgb(glm::vec3(kOkabeIto[static_cast<std::size_t>(species)]) / 255.0f);
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
