// column_depth.cpp: sums over levels, in double precision.
#include "core/volume/column_depth.h"

namespace neph {

std::vector<float> columnDepths(const SpeciesVolume& volume, const MediumPlan& plan) {
    const glm::ivec3 size = volume.grid.size;
    const auto columns = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<double> sums(columns, 0.0);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const double perHeld =
            static_cast<double>(plan.extinctionPerHeld[s]) * volume.grid.spacingM.z;
        if (perHeld <= 0.0) continue;
        const bool sized = volume.holdsExtinction(static_cast<Species>(s));
        const Array3f& field = sized ? volume.extinctionPerM[s] : volume.contentKgPerM3[s];
        std::size_t at = 0;
        for (int z = 0; z < size.z; ++z) {
            for (std::size_t i = 0; i < columns; ++i, ++at) {
                sums[i] += perHeld * static_cast<double>(field.values[at]);
            }
        }
    }
    return {sums.begin(), sums.end()};
}

}  // namespace neph
