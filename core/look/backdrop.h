// backdrop.h: sky and ground without cloud, as an image of a look shows them: for what stands in
// for an image. Colours are encoded sRGB, 0 to 1, without haze between the eye and what is near.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "core/look/exposure.h"
#include "core/look/look.h"
#include "core/sky/atmosphere.h"

namespace neph {

class Backdrop {
  public:
    /// Of a look whose sun stands by angles (`withSun`), from an eye at an altitude; below the
    /// ground, on it.
    Backdrop(const Look& look, double eyeAltitudeM);

    /// Sine of the elevation below which the ground is seen, where it is shown.
    double horizonUp() const { return horizonUp_; }
    /// The sky in a unit direction of the world; from below the horizon, the horizon's.
    glm::vec3 sky(const glm::dvec3& direction) const;
    /// The ground in such a direction, through the air before it; from above the horizon, the
    /// horizon's. None where the look hides it.
    std::optional<glm::vec3> ground(const glm::dvec3& direction) const;

  private:
    SkyRay rayIn(const glm::dvec3& direction) const;
    glm::vec3 shown(const glm::dvec3& radiance) const;

    Look look_;
    double altitudeM_ = 0.0;
    glm::dvec3 towardsSun_{0.0};
    std::shared_ptr<const Atmosphere> air_;  ///< null: two colours
    double horizonUp_ = 0.0;
    glm::dvec3 groundRadiance_{0.0};
    DisplayTones tones_;
};

}  // namespace neph
