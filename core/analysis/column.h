// column.h: one native column: the profile of everything in it, and its air as a sounding.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/air/hodograph.h"
#include "core/air/parcel.h"
#include "core/air/sounding.h"
#include "core/analysis/quantity.h"
#include "core/dataset/dataset.h"

namespace neph {

/// One quantity from the ground up.
struct Profile {
    Quantity quantity = Quantity::cloud;
    std::vector<double> values;
};

/// What instability and shear there are.
struct ConvectionIndices {
    Ascent surface, mixedLayer, mostUnstable;
};
/// Each where the wind is known up to the height that it needs.
struct WindIndices {
    std::optional<glm::dvec2> shear1MPerS, shear6MPerS;  ///< from the ground to 1 and 6 km
    std::optional<StormMotion> motion;  ///< relative to what the wind is relative to; to 6 km
    /// Of a storm that moves right, to 1 and 3 km, m²/s²; they need its motion.
    std::optional<double> helicity1, helicity3;
};

struct ColumnReport {
    int time = 0;
    glm::ivec2 column{0};
    glm::dvec2 positionM{0.0};  ///< centre of the column
    std::optional<GeoPoint> geo;
    double groundM = 0.0;
    std::vector<double> heightsM;      ///< centres of cells, above sea level
    std::vector<Profile> profiles;     ///< of every quantity that the data have
    std::vector<std::string> lacks;    ///< "wind_speed: they have no wind along x"
    std::optional<Sounding> sounding;  ///< where pressure, temperature and vapour are known
    std::optional<ConvectionIndices> convection;
    std::optional<WindIndices> wind;  ///< where the wind is known as well
    std::optional<double> tropopauseM;
    std::vector<double> freezingM;  ///< heights at which temperature passes 0 °C

    const Profile* find(Quantity quantity) const;
};

/// Reads the column that `positionM` lies in. Throws Error or Cancelled.
ColumnReport readColumn(Dataset& dataset, int time, glm::dvec2 positionM);

}  // namespace neph
