// section.h: cuts through the model's own grid: vertical ones along a line, horizontal ones at a
// height above sea level.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/quantity.h"
#include "core/base/progress.h"
#include "core/dataset/dataset.h"

namespace neph {

/// The values of one quantity on a section, x fastest; NaN below the ground, above the model's top
/// and where the data have none.
struct SectionField {
    Quantity quantity = Quantity::cloud;
    std::vector<float> values;
};

/// A cut. Positions are of the middles of what the values stand for.
struct CrossSection {
    bool vertical = true;
    /// Vertical: metres along the line. Horizontal: metres along the grid's x.
    std::vector<double> acrossM;
    /// Vertical: heights above sea level. Horizontal: metres along the grid's y.
    std::vector<double> upM;
    glm::dvec2 fromM{0.0}, toM{0.0};  ///< ends of the line
    double heightM = 0.0;             ///< of a horizontal section
    std::vector<double> groundM;      ///< along a vertical one: height of the ground
    std::vector<double> tropopauseM;  ///< the same, NaN where there is none; empty if not asked
    std::vector<SectionField> fields;
    /// The last field is temperature, of which 0 and -20 °C alone are drawn.
    bool temperatureLast = false;

    float at(std::size_t field, std::size_t across, std::size_t up) const {
        return fields[field].values[up * acrossM.size() + across];
    }
};

/// From `fromM` to `toM`, which lie in the domain and differ: bilinear between columns, linear in
/// height. Two points a cell and 800 at most; heights in steps of 100 m, or 250 of them where that
/// would be more. `tropopause` needs temperature. Throws Error or Cancelled.
CrossSection verticalSection(Dataset& dataset, int time, glm::dvec2 fromM, glm::dvec2 toM,
                             std::span<const Quantity> quantities, bool tropopause = false,
                             const Progress& progress = {});

/// Of all native columns. Throws Error (no column reaches the height) or Cancelled.
CrossSection horizontalSection(Dataset& dataset, int time, double heightM,
                               std::span<const Quantity> quantities, const Progress& progress = {});

/// What is cut, and what of it is shown.
struct SectionCut {
    bool vertical = true;
    glm::dvec2 fromM{0.0}, toM{0.0};  ///< ends of a vertical one, in the domain
    double heightM = 0.0;             ///< of a horizontal one, above sea level
    Quantity shown = Quantity::condensate;
    std::vector<Quantity> contours;
    bool operator==(const SectionCut&) const = default;
};

/// The section, a vertical one with temperature and tropopause where the data have them. Throws
/// Error or Cancelled.
CrossSection readSection(Dataset& dataset, int time, const SectionCut& cut,
                         const Progress& progress = {});

/// The lowest height from which temperature falls by less than 2 K/km over the next 2 km [WMO57],
/// above 500 hPa's usual 5 km; `heightsM` increase. Nothing where there is none.
std::optional<double> tropopauseOf(std::span<const double> heightsM,
                                   std::span<const double> temperaturesK);

}  // namespace neph
