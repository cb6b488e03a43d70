// species.cpp: how a volume holds its species, and how much memory that takes.
#include "core/grid/species.h"

namespace neph {

std::array<Holding, kSpeciesCount> SpeciesVolume::holdings() const {
    std::array<Holding, kSpeciesCount> all{};
    for (std::size_t s = 0; s < all.size(); ++s) all[s] = holding(static_cast<Species>(s));
    return all;
}

std::size_t SpeciesVolume::bytes() const {
    std::size_t values = 0;
    for (const auto* arrays : {&contentKgPerM3, &extinctionPerM}) {
        for (const Array3f& array : *arrays) values += array.values.size();
    }
    return values * sizeof(float);
}

}  // namespace neph
