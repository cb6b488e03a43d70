// held_volume.h: the volume of one time as the renderer needs it, with how it was read and what is
// in it.
//
// One function makes it for both the workbench and the command line, so that they show the same.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/geo/map_grid.h"
#include "core/grid/boxes.h"
#include "core/grid/species.h"
#include "core/volume/radius_plan.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Everything that determines a volume besides the time.
struct VolumeRequest {
    std::optional<BoxM> region;  ///< empty: the whole domain
    MemoryBudget budget;
    RadiusPlan radii;       ///< as the look requires
    bool humidity = false;  ///< of the lowest air, where the look asks for it
    int member = 0;         ///< of an ensemble, or kMeanMember
    bool operator==(const VolumeRequest&) const = default;
};

/// Thinner cloud is not seen even across a storm: a mean free path of 6.7 km.
inline constexpr float kVisibleExtinctionPerM = 1.5e-4f;

/// Number of cells by value of one species, in bins of equal width in the logarithm. Values are as
/// held: kg/m³, or 1/m where model radii turned content into extinction.
struct FieldHistogram {
    static constexpr int kBinsPerDecade = 8, kDecades = 8, kBins = kBinsPerDecade * kDecades;
    Holding holding = Holding::absent;
    float least = 0.0f, most = 0.0f;  ///< of the values above zero; 0 if there are none
    std::array<std::uint64_t, kBins> cells{};
    std::uint64_t below = 0, above = 0;  ///< above zero, but outside the bins
    std::uint64_t filled() const;        ///< cells above zero

    /// Lower edge of a bin; that of kBins is the upper edge of the last.
    static double lowerBound(Holding holding, int bin);
    void add(float value);
};

/// Bounding box of what can be seen of a species in one block of a volume: framing.h.
struct SeenPart {
    int block = 0;
    Species species{};
    BoxM box;
};

/// Facts about a volume that are computed once, when it is read.
struct VolumeSummary {
    RegularGrid grid;
    double cellM = 0.0;  ///< SpeciesVolume::cellM
    ReadPlan plan;
    glm::dvec2 domainHeightsM{0.0};              ///< lowest and highest level of the whole domain
    std::array<bool, kSpeciesCount> present{};   ///< the model has the species
    std::array<bool, kSpeciesCount> anything{};  ///< ... and some of it is not zero
    std::array<FieldHistogram, kSpeciesCount> histograms{};
    std::optional<BoxM> clouds;  ///< bounding box of what is dense enough to be seen
    std::vector<SeenPart> seen;  ///< as seenParts(); empty: nothing
    std::string timeLabel;
    Whereabouts where;       ///< the middle of the grid, at this time
    std::string noHumidity;  ///< why it is not known although it was asked for; or empty
    std::string noAerosol;   ///< the same of the aerosol
    bool empty() const;      ///< no hydrometeor anywhere
};

/// A volume with its summary, as the cache keeps it.
struct HeldVolume {
    std::shared_ptr<const SpeciesVolume> volume;
    VolumeSummary summary;
};

VolumeSummary summarise(const SpeciesVolume& volume);

/// Plans, reads and summarises. Throws Error or Cancelled.
HeldVolume readVolume(Dataset& dataset, int time, const VolumeRequest& request,
                      const Progress& progress = {});
/// Adds humidity and aerosol of the lowest air to what was read without. Of an ensemble: those of
/// `member`, or their means. Throws Cancelled.
void addHumidity(HeldVolume& held, Dataset& dataset, int time, int member = 0,
                 const Progress& progress = {});

/// `region` extended by a tenth of its extent on every side.
BoxM withMargin(const BoxM& region);

}  // namespace neph
