// checks.h: the built-in checks of the path tracer, beside the scenes in files: laws with closed
// forms, and invariance of the result to how a medium is described; and those of the sky.
// docs/validation.md lists them.
#pragma once
#include <cstdint>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// Beer-Lambert law: direct light through uniform and random media.
std::vector<Trial> transmissionTrials();
/// Light scattered once by a slab.
std::vector<Trial> singleScatteringTrials();
/// White furnace: in uniform surroundings a medium that does not absorb is invisible.
std::vector<Trial> furnaceTrials();
/// Energy that a sphere scatters into ten intervals of cos Θ.
std::vector<Trial> sphereTrials();
/// A mixture as one field, other majorants and voxel sizes, conservation of energy, Lambertian
/// ground.
std::vector<Trial> invarianceTrials();

/// The largest distance between the empirical distribution of sampled scattering angles and the
/// cumulative phase function, for every kind of phase function.
std::vector<Row> phaseRows(render::TraceMeter& meter, bool quick);

/// The clear sky of images against published formulas and exact solutions, a list for each
/// comparison. Needs no meter, and knows no noise.
std::vector<std::vector<Row>> skyRows();

/// Pseudo-random numbers in [0, 1), the same on every machine.
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint32_t seed) : state_(seed) {}
    double next();

  private:
    std::uint64_t state_;
};

/// Extinction of 0 to 2 `meanPerM`, independent in each voxel; a third of the voxels is empty.
Array3f randomExtinction(glm::ivec3 size, double meanPerM, std::uint32_t seed);

PhaseSpec henyeyGreenstein(double g);

/// Directions that sample the sun's disc: seven rings of equal solid angle, six points each.
std::vector<glm::dvec3> sunDisc(const render::MeterScene& scene);

}  // namespace neph::validate
