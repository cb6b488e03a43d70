// light_medium.h: what the solver of multiple scattering is asked: medium, sources of light, and
// how finely.
//
// Space: metres; node (i, j, k) lies at (i, j, k) * spacingM, k = 0 on the ground, z up. Between
// nodes extinction is trilinear. Outside the nodes there is nothing, or with periodic sides node
// nodes.x is node 0 again and likewise in y. docs/transport.md
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/grid/grid.h"
#include "core/sky/sky_tables.h"
#include "core/transport/harmonics.h"
#include "core/transport/phase_moments.h"

namespace neph {

/// Particles that scatter alike.
struct LightClass {
    Array3f extinctionPerM;         ///< at nodes, not scaled
    double singleScattering = 1.0;  ///< albedo of single scattering
    PhaseMoments moments{};
    bool operator==(const LightClass&) const = default;
};

struct LightMedium {
    glm::ivec3 nodes{0};  ///< at least 2 each
    glm::dvec3 spacingM{0.0};
    std::vector<LightClass> classes;
    bool operator==(const LightMedium&) const = default;
};

/// At half the resolution: node n is node 2 n, with the mean around it. Axes of fewer than 5 nodes
/// stay as they are, and so do periodic ones whose number of nodes is odd.
LightMedium halved(const LightMedium& medium, bool periodicSides);

/// Light comes from one source at a time; the answers to both add up.
enum class LightSource : int {
    sun,  ///< irradiance 1 on a plane across the beam; the sky is dark
    sky   ///< the sky above the horizon; the sun is dark
};

/// Radiance of a sky: from zenith to horizon as shaders/lib/sky.glsl has it, or a pattern of the
/// atmosphere.
struct SkyLight {
    double zenith = 1.0, horizon = 1.0;
    std::shared_ptr<const SkyDome> dome = {};
    std::size_t pattern = 0;  ///< of the dome
    bool isDark() const { return !dome && zenith == 0.0 && horizon == 0.0; }
    /// `towards` is a unit vector above the horizon.
    double radianceAt(const glm::dvec3& towards) const;
    /// On a level surface.
    double irradiance() const;
    bool operator==(const SkyLight&) const = default;
};

struct LightScene {
    LightSource source = LightSource::sun;
    glm::dvec3 towardsSun{0.0, 0.0,
                          1.0};  ///< unit vector; below the horizon it still lights what is high
    SkyLight sky;                ///< if it is the source
    /// If it is the source, how bright the sun is at the height of each layer of nodes: 1 if empty.
    std::vector<float> sunByLayer;
    double groundAlbedo = 0.0;    ///< Lambert, also of the ground beyond open sides
    double groundRadiance = 0.0;  ///< comes up from below besides
    bool periodicSides = false;
};

struct LightSettings {
    /// Also zonal harmonics of l = 3 and 4 about the sun, and rings of directions, for light of the
    /// sun; needed where an eye looks towards it.
    bool aligned = false;
    int levels = 4;          ///< grids of the multigrid, the finest included
    int sweepsPerLevel = 2;  ///< on coarse grids, before each correction
    int coldCycles = 4;      ///< before averaging starts
    int warmCycles = 2;      ///< the same after `restart`
    int threads = 2;
    std::uint64_t seed = 1;
};

/// The distance between nodes by which they are called thin or thick: the horizontal one, or 2.5
/// times the vertical one where nodes are flatter than that.
double thicknessLengthM(const glm::dvec3& spacingM);

/// How optically thick a node is, 0 ... 2: 0 up to a depth of 1 between nodes, 1 from 4 to 10, 2
/// from 30 on, linear between. `extinctionPerM` is the sum of all classes, not scaled.
double lightThickness(const LightMedium& medium, double extinctionPerM);

/// Delta-M: which share of the scattered light of a class counts as not scattered.
/// `thickness` is `lightThickness` at the same place. At 0 what is kept of the phase function ends
/// at l = 4 with `aligned` and at l = 2 without, at 1 at l = 2; at 2 the rest is isotropic.
double forwardShare(const LightClass& light, bool aligned, double thickness);

/// Extinction and scattering of degree l = 0 ... 8, of one class at one place, scaled by delta-M.
struct ScaledOptics {
    double extinctionPerM = 0.0;
    double absorptionPerM = 0.0;
    std::array<double, kAlignedDegrees> scatteringPerM{};  ///< times chi'_l
};

ScaledOptics scaledOptics(const LightClass& light, double extinctionPerM, bool aligned,
                          double thickness);

}  // namespace neph
