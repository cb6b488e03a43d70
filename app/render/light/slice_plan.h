// slice_plan.h: the geometry of half-angle slicing for one camera and one sun. [Riley03] §4.4.1,
// [Kniss03]
//
// Slices have a normal halfway between the eye's and the light's direction, so that both see them
// well. They are ordered along the light; the eye meets them in the same order when the light comes
// from behind the viewer and in the opposite order when it comes from the front. Everything is in
// grid space: metres from the lower corner of the volume, world axes.
#pragma once
#include <glm/glm.hpp>

#include "core/camera/camera.h"
#include "core/grid/boxes.h"

namespace neph::render {

struct SlicePlan {
    glm::dvec3 normal{0.0, 0.0, -1.0};
    bool frontToBack = true;
    double firstM = 0.0;    ///< dot(normal, p) where slice 0 begins
    double spacingM = 1.0;  ///< between slices, along the normal
    int count = 0;
    double lightStepM = 1.0;  ///< length of a light ray between two slices
    glm::dvec3 lightU{1.0, 0.0, 0.0}, lightV{0.0, 1.0, 0.0};
    glm::dvec2 lightLowerM{0.0};   ///< of the light buffer, in the coordinates of lightU and lightV
    glm::dvec2 lightExtentM{1.0};  ///< of the light buffer
    glm::ivec2 lightSizePx{1};
    /// Slices are level, and lightU and lightV lead along the light to the place at height 0, of
    /// which the buffer covers one width of the domain: planRepeatedSlices().
    bool repeats = false;

    /// At most so many slices, further apart.
    void limit(int most);
};

/// Slices that face the sun, `stepM` apart, with light texels as large: for light alone, whatever
/// the camera. Count at least 1.
SlicePlan planSunSlices(glm::dvec3 towardsSun, const BoxM& box, double stepM);

/// The same between periodic sides: level slices, between which light goes no more than about
/// `stepM`, and a buffer as wide as the domain that repeats in x and y. Under a low sun there are
/// so many of them that at some point steps get longer. `extentM` is the domain's.
SlicePlan planRepeatedSlices(glm::dvec3 towardsSun, const BoxM& occupied, glm::dvec3 extentM,
                             double stepM);

/// `texelM`: wanted size of a light texel. The buffer covers the box as the sun sees it, 16 to 1024
/// texels per side.
SlicePlan planSlices(const Camera& camera, glm::dvec3 towardsSun, const BoxM& box, int planes,
                     double texelM);

}  // namespace neph::render
