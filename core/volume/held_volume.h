// held_volume.h: one time's volume as a picture needs it, with how it was read and what is in it.
//
// Made by one function for the workbench and the command line, so that both show the same.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/volume/radius_plan.h"
#include "core/volume/read_plan.h"

namespace neph {

/// What is asked of a time besides the time itself.
struct VolumeRequest {
    std::optional<Region> region;  ///< none: the whole domain
    MemoryBudget budget;
    RadiusPlan radii;  ///< as the look asks for it
    bool operator==(const VolumeRequest&) const = default;
};

/// How many cells of a volume hold how much of a species, in bins of equal width in the logarithm.
/// Values are as they are held: kg/m³, or 1/m where the radii of the model made them extinction.
struct FieldHistogram {
    static constexpr int kBinsPerDecade = 8, kDecades = 8, kBins = kBinsPerDecade * kDecades;
    Holding holding = Holding::absent;
    float least = 0.0f, most = 0.0f;  ///< of the values above zero; 0 where there is none
    std::array<std::uint64_t, kBins> cells{};
    std::uint64_t below = 0, above = 0;  ///< above zero, but outside of the bins
    std::uint64_t filled() const;        ///< cells above zero

    /// Lower bound of a bin; that of kBins is the upper one of the last.
    static double lowerBound(Holding holding, int bin);
    void add(float value);
};

/// What is known of a volume without looking into it again.
struct VolumeSummary {
    RegularGrid grid;
    ReadPlan plan;
    glm::dvec2 domainHeightsM{0.0};              ///< lowest and highest level of the whole domain
    std::array<bool, kSpeciesCount> present{};   ///< the model has the species
    std::array<bool, kSpeciesCount> anything{};  ///< ... and some of it is not zero
    std::array<FieldHistogram, kSpeciesCount> histograms{};
    std::optional<Region> clouds;  ///< where it is dense enough to be seen
    std::string timeLabel;
    bool empty() const;  ///< no hydrometeor anywhere
};

struct HeldVolume {
    SpeciesVolume volume;
    VolumeSummary summary;
};

VolumeSummary summarise(const SpeciesVolume& volume);

/// Plans, reads and summarises. Throws Error or Cancelled.
HeldVolume readVolume(Dataset& dataset, int time, const VolumeRequest& request,
                      const Progress& progress = {});

/// `region` with a margin of a tenth of its extent on every side.
Region withMargin(const Region& region);

}  // namespace neph
