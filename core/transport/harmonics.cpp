// harmonics.cpp: the basis, as the shaders have it.
#include "core/transport/harmonics.h"

#include <algorithm>

#include "shaders/lib/glsl_cpp.h"

namespace neph {

Harmonics harmonicsAt(const glm::dvec3& travel, const glm::dvec3& sunTravel) {
    const auto y = glsl::directionHarmonics(glm::vec3(travel), glm::vec3(sunTravel));
    Harmonics value{};
    std::copy_n(y.value, value.size(), value.begin());
    return value;
}

}  // namespace neph
