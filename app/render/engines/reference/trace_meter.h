// trace_meter.h: what an instrument would read in a small scene: radiances, fluxes and absorbed
// power, by the path tracer that draws the engine `reference`.
//
// The same shader carries the paths; only where they start and what is kept of them differs. Grid
// space: metres from the grid's lower corner, z up. Values are grey.
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/render/engines/reference/path_tracer.h"
#include "core/base/progress.h"
#include "core/grid/boxes.h"
#include "core/grid/grid.h"
#include "core/optics/phase.h"

namespace neph::render {

enum class DetectorKind : int {
    radiance = block::kRadianceDetector,        ///< that arrives at the detector's points from
                                                ///< `direction`; no direct sunlight
    flux = block::kFluxDetector,                ///< irradiance of a plane that faces `direction`
    diffuseFlux = block::kDiffuseFluxDetector,  ///< the same without direct sunlight
    absorption = block::kAbsorptionDetector     ///< power that is absorbed in a unit of volume: 4π
                                                ///< β_abs times mean radiance
};

/// Reads the mean over points that are spread evenly in a box, which may be a plane, a line or a
/// point.
struct Detector {
    DetectorKind kind = DetectorKind::radiance;
    BoxM box;
    glm::dvec3 direction{0.0, 0.0, 1.0};  ///< unit
};

struct Measured {
    double mean = 0.0;
    double sigma = 0.0;  ///< standard error of the mean
    std::uint64_t samples = 0;
};

struct MeterField {
    Array3f extinctionPerM;  ///< of the scene's size
    double albedo = 1.0;     ///< single-scattering
    PhaseSpec phase;
};

struct MeterScene {
    glm::ivec3 size{1};
    glm::dvec3 spacingM{1.0};
    bool trilinear = false;          ///< between voxel centres; else constant in each voxel
    bool periodic = true;            ///< in x and y; else nothing is around the grid
    std::vector<MeterField> fields;  ///< at most kSpeciesCount
    glm::dvec3 towardsSun{0.0, 0.0, 1.0};
    double sunIrradiance = 1.0;  ///< across the beam
    double sunRadiusRad = kSunRadiusRad;
    double skyRadiance = 0.0;             ///< the same from everywhere
    std::optional<double> surfaceAlbedo;  ///< of a Lambert plane at z = 0; none: open
    std::optional<AirBands> air;  ///< above sea level at z = 0, within the grid; it does not dim
                                  ///< the sun, whose irradiance at a point tables have elsewhere
};

struct MeterSettings {
    std::uint64_t samples = 100'000;  ///< paths per detector, at least
    std::uint32_t seed = 0;
    int maxScatterings = 0;      ///< light scattered more often is not seen; 0: no limit
    double majorantScale = 1.0;  ///< on the bound of extinction, at least 1: results do not change
    int brickVoxels = 4;         ///< side of the bricks that bounds are kept for: likewise
};

class TraceMeter {
  public:
    /// Needs a current GL context for its whole life. Throws Error when a shader fails.
    explicit TraceMeter(const std::filesystem::path& shaderDir);
    ~TraceMeter();
    TraceMeter(const TraceMeter&) = delete;
    TraceMeter& operator=(const TraceMeter&) = delete;

    /// One result a detector. `progress` is asked every few milliseconds; throws Cancelled.
    std::vector<Measured> measure(const MeterScene& scene, std::span<const Detector> detectors,
                                  const MeterSettings& settings, const Progress& progress = {});

    /// Cosines of `count` scattering angles as the paths draw them, at 550 nm.
    std::vector<float> sampledCosines(const PhaseSpec& phase, int count, std::uint32_t seed);

    /// GL renderer string.
    std::string deviceName() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace neph::render
