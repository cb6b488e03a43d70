// species.cpp: what a volume holds.
#include "core/species.h"

namespace neph {

std::size_t SpeciesVolume::bytes() const {
    std::size_t values = 0;
    for (const auto* arrays : {&contentKgPerM3, &extinctionPerM}) {
        for (const Array3f& array : *arrays) values += array.values.size();
    }
    return values * sizeof(float);
}

}  // namespace neph
