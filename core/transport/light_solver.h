// light_solver.h: solves multiple scattering in a medium of light classes.
//
// Units: irradiance of the sun 1 across the beam, or radiance of the sky 1; radiance follows. The
// beam is not part of the field: the field is what has been scattered or reflected, and skylight.
// Moments: radiance in the direction `travel`, in which light travels, is the sum over q of
// moments[q] * harmonicsAt(travel, -towardsSun)[q]. docs/transport.md
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/transport/directions.h"
#include "core/transport/multigrid.h"
#include "core/transport/sweep.h"
#include "core/transport/transport_level.h"

namespace neph {

/// What reaches a level straight from the sun; empty without a sun.
struct LevelBeam {
    /// Across the beam with scaled extinction, of active nodes and on the ground. Where nodes are
    /// balanced, that which would bring in what the beam loses around them.
    std::vector<float> atNodes;
    /// The same of the ground, everywhere what the beam has left; x fastest.
    std::vector<float> onGround;
    /// Which part of the sunlight that the medium catches it catches between nodes further apart
    /// than a scaled optical depth of 4, 0 ... 1.
    double underResolved = 0.0;
};

class LightSolver {
  public:
    /// The medium is not needed afterwards. Its nodes are at least 2 on each axis.
    LightSolver(const LightMedium& medium, const LightScene& scene, const LightSettings& settings);

    /// Of the same medium and number of moments as `other`, which is quicker.
    LightSolver(const LightSolver& other, const LightScene& scene, const LightSettings& settings);

    /// Another sun or ground; the field is kept as a start. Source and sides are as before.
    void restart(const LightScene& scene);

    /// Starts from the field of another solver of the same source, between whose nodes it is
    /// interpolated; node 0 is at the same place.
    void startFrom(const LightSolver& other);

    /// One sweep along new directions, corrected by multigrid. The first cycles replace the field,
    /// those after them are averaged.
    void cycle();

    int cyclesDone() const { return cycles_; }
    /// kBroadMoments, or kAlignedMoments for the sun with `aligned`.
    int momentCount() const { return levels_->front().momentCount; }
    const TransportLevel& level() const { return levels_->front(); }
    /// The grids of the multigrid, the finest first.
    const std::vector<TransportLevel>& levels() const { return *levels_; }
    const LightScene& scene() const { return scene_; }
    const LightSettings& settings() const { return settings_; }

    /// Moments of the active nodes, momentCount() side by side; level().place leads to them.
    const LightField& field() const { return field_; }
    /// Those of a node; empty where it is not active.
    std::span<const float> momentsAt(std::size_t node) const;
    /// Of all nodes, x fastest, momentCount() side by side, 0 where not active.
    std::vector<float> momentsOfAllNodes() const;
    const std::vector<float>& beam() const { return beam_.atNodes; }
    const std::vector<float>& groundBeam() const { return beam_.onGround; }
    /// Of another level of the same medium.
    LevelBeam beamOn(const TransportLevel& level) const;
    /// What a sweep of a level is given, of which field and beam are.
    SweepInput sweepInput(const TransportLevel& level, const LightField& field,
                          const LevelBeam& beam) const;
    /// How optically thick every node is, 0 ... 2 (`lightThickness`); where the medium is thick, of
    /// the mean around it.
    const std::vector<float>& thickness() const { return level().thickness; }
    /// Of every node: the share of l = 0 that follows from its energy balance, 0 ... 1; empty
    /// unless the medium is thick.
    const std::vector<float>& balanced() const { return level().balanced; }
    double underResolved() const { return beam_.underResolved; }
    /// Downward irradiance at the ground without the beam, x fastest.
    const std::vector<float>& groundFlux() const { return field_.groundFlux; }

    /// Of the last cycle: the correction on the coarsest grid relative to the field.
    double remaining() const { return remaining_; }
    /// Chance in the average, relative: half the difference between the averages of odd and of even
    /// cycles, root mean square of l = 0. Negative until there is one cycle of each.
    double chance() const;

    std::size_t bytes() const;

  private:
    LightSolver(std::shared_ptr<const std::vector<TransportLevel>> levels, const LightScene& scene,
                const LightSettings& settings);
    Swept sweepFine(const LightField& field, const LightDirections& directions) const;
    LightField thickCycle(const LightDirections& directions, const MultigridPass& pass);
    void average(const LightField& next);
    bool hasBeam() const { return !beam_.atNodes.empty(); }

    LightScene scene_;
    LightSettings settings_;
    std::shared_ptr<const std::vector<TransportLevel>> levels_;
    LightField field_;
    LevelBeam beam_;
    DirectionSource directions_;
    std::array<std::vector<float>, 2> halves_;  ///< averages of l = 0 over every other cycle
    std::array<int, 2> halfCycles_{};
    int cycles_ = 0;
    int replacing_ = 0;  ///< cycles before averaging starts
    double remaining_ = 1.0;
};

}  // namespace neph
