// sky_textures.h: the tables of sky and air on the GPU, for the look and the eye of a frame.
// core/sky/sky_tables.h
#pragma once
#include <glm/glm.hpp>
#include <memory>

#include "app/gl/objects.h"
#include "core/look/look.h"
#include "core/sky/sky_tables.h"

namespace neph::render {

class SkyTextures {
  public:
    /// Makes anew what the change since the last call touches.
    void update(const Look& look, double eyeAltitudeM);
    /// Whether there is an atmosphere; else a gradient, for which the textures are empty.
    bool hasAir() const { return air_ != nullptr; }
    const Atmosphere& air() const { return *air_; }  ///< where there is one
    void bind() const;

    const SkyTables& tables() const { return tables_; }
    /// Rows of SkyTables::byAltitude at an altitude of 0.
    glm::vec3 sunOnGround() const;
    glm::vec3 patternOnGround(std::size_t pattern) const;

    std::size_t bytes() const;

  private:
    void uploadSky();
    void uploadEye();

    std::shared_ptr<const Atmosphere> air_;
    SkyTables tables_;
    glm::dvec3 towardsSun_{0.0};
    double eyeAltitudeM_ = -1.0;
    gl::Texture eyeSky_, airLight_, sunnyAir_, clear_, byMolecules_, byHaze_, around_, byAltitude_;
};

}  // namespace neph::render
