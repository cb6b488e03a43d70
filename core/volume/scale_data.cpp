// scale_data.cpp: what there is from the volume, sizes of particles from its description.
#include "core/volume/scale_data.h"

#include "core/volume/radius_plan.h"
#include "core/volume/radius_scheme.h"

namespace neph {

ScaleData scaleDataOf(const DatasetInfo& info, const VolumeSummary& shown) {
    ScaleData data;
    data.cellM = shown.cellM > 0.0 ? shown.cellM : meanCellM(info.spacingM);
    for (std::size_t s = 0; s < data.fields.size(); ++s) {
        if (!shown.anything[s]) continue;
        const auto species = static_cast<Species>(s);
        const RadiusBounds bounds = radiationBounds(species);
        data.fields[s] = {true, statesSize(info, species), bounds.lowerM, bounds.upperM};
    }
    return data;
}

}  // namespace neph
