// checks.h: what is proved besides the cases in files: laws that have closed forms, and that the
// same light comes out of the same medium however it is described.
#pragma once
#include <cstdint>
#include <vector>

#include "app/validate/trial.h"

namespace neph::validate {

/// Beer-Lambert: direct light through uniform and random media.
std::vector<Trial> transmissionTrials();
/// Light that is scattered once by a slab.
std::vector<Trial> singleScatteringTrials();
/// In uniform surroundings a medium that absorbs nothing cannot be seen.
std::vector<Trial> furnaceTrials();
/// The energy that a sphere scatters into ten intervals of cos Theta.
std::vector<Trial> sphereTrials();
/// Mixtures as one field, other majorants, other voxels, the balance of energy, Lambert ground.
std::vector<Trial> invarianceTrials();

/// The largest distance between the cumulative of drawn scattering angles and that of the phase
/// function, for every kind.
std::vector<Row> phaseRows(render::TraceMeter& meter, bool quick);

/// Values in [0, 1) that are the same everywhere.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : state_(seed) {}
    double next();

  private:
    std::uint64_t state_;
};

/// Extinction of 0 to 2 `meanPerM`, independent in each voxel; a third of them is empty.
Array3f randomExtinction(glm::ivec3 size, double meanPerM, std::uint32_t seed);

PhaseSpec henyeyGreenstein(double g);

/// Directions that stand for the sun's disc: seven rings of equal solid angle.
std::vector<glm::dvec3> sunDisc(const render::MeterScene& scene);

}  // namespace neph::validate
