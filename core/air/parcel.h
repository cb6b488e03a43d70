// parcel.h: a parcel of air lifted through a sounding: condensation, free convection, and the
// energy that buoyancy gives.
//
// Ascent is pseudoadiabatic over water, and buoyancy that of virtual temperature [Doswell94].
#pragma once
#include <optional>
#include <vector>

#include "core/air/sounding.h"

namespace neph {

/// Which air is lifted.
enum class ParcelSource : int {
    surface,      ///< of the lowest level
    mixedLayer,   ///< mean potential temperature and vapour of the lowest 100 hPa
    mostUnstable  ///< of the largest equivalent potential temperature in the lowest 300 hPa
};

/// The air that is lifted, where it starts.
struct Parcel {
    double pressurePa = 0.0;
    double temperatureK = 0.0;
    double vapourRatio = 0.0;
};

/// A place on the parcel's way.
struct ParcelPoint {
    double pressurePa = 0.0;
    double heightM = 0.0;       ///< above the ground
    double temperatureK = 0.0;  ///< of the parcel
};

/// The way of a parcel up to the top of the sounding.
struct Ascent {
    Parcel parcel;
    std::vector<ParcelPoint> way;  ///< from the start up, every 5 hPa or finer
    double capeJPerKg = 0.0;       ///< all that is positive above the level of free convection
    double cinJPerKg = 0.0;        ///< all that is negative below it; 0 or less
    std::optional<ParcelPoint> condensation;    ///< LCL; none below the top of the sounding
    std::optional<ParcelPoint> freeConvection;  ///< LFC; none where the parcel is never buoyant
    std::optional<ParcelPoint> equilibrium;     ///< EL: the highest, of positive energy
};

Parcel parcelOf(const Sounding& sounding, ParcelSource source);

/// The sounding has two levels at least, and the parcel starts within it.
Ascent ascentOf(const Sounding& sounding, const Parcel& parcel);

}  // namespace neph
