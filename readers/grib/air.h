// air.h: heights, pressure, temperature, vapour and density on the levels of a file.
#pragma once
#include "readers/grib/contents.h"
#include "readers/grib/field_reader.h"

namespace grib {

/// One level, at one time, of some columns. Values are x fastest.
struct Layer {
    std::size_t time = 0, level = 0;  ///< indices into Contents, from the ground up
    Columns columns;
};

class Air {
  public:
    Air(FieldReader& reader, const Contents& contents) : reader_(reader), contents_(contents) {}

    using Values = std::vector<float>;
    /// A stored parameter; NaN where the file lacks the level.
    Values stored(const Parameter& parameter, const Layer& layer) const;
    Values heightOfCentre(const Layer& layer) const;  ///< m above sea level
    Values pressure(const Layer& layer) const;        ///< Pa
    Values temperature(const Layer& layer) const;     ///< K
    /// kg per kg of dry air, not below zero, NaN where it is impossible; empty if the file has
    /// none.
    Values vapour(const Layer& layer) const;
    Values density(const Layer& layer) const;  ///< of dry air, kg/m³; NaN where air is impossible
    /// Interface `layer.level` of one more than there are levels: halfway between centres; the
    /// lowest is the ground where the file has it and it lies below the lowest centre.
    Values interface(const Layer& layer) const;
    /// Height of the ground, m; empty if the file has none.
    Values ground(const Layer& layer) const;
    /// Sets values to NaN in cells whose centre is below the ground, or without height, on isobaric
    /// levels.
    void clearBelowGround(const Layer& layer, std::span<float> values) const;

  private:
    /// Cells of an isobaric level that the model masked because they are below the ground: those
    /// without height. Empty where there are none.
    std::vector<bool> maskedCells(const Layer& layer) const;
    void fillMasked(const Layer& layer, std::span<float> values, float with) const;
    Values outermost(const Layer& layer, std::size_t end, std::size_t next) const;

    FieldReader& reader_;
    const Contents& contents_;
};

}  // namespace grib
