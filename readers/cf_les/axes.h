// axes.h: which dimensions of a file are x, y, z and time: by the names of the model's row, then by
// the attributes of CF.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "readers/cf_les/models.h"
#include "readers/netcdf/nc_file.h"

namespace cf {

inline constexpr std::size_t kMostCells = 1U << 20U;  // along one axis; no model comes near

/// Where a dimension belongs.
struct Place {
    static constexpr std::size_t kTime = 3;
    std::size_t axis = 0;  ///< x, y, z or kTime
    bool face = false;
};

/// How a variable lies in its file: the position of each axis among its dimensions.
struct Layout {
    std::optional<std::size_t> time;
    std::array<std::optional<std::size_t>, 3> axis;
    std::array<bool, 3> face{};

    bool isField() const { return axis[0] && axis[1] && axis[2]; }
    bool onCells() const { return isField() && !face[0] && !face[1] && !face[2]; }
    bool isProfile() const { return !axis[0] && !axis[1] && axis[2] && !face[2]; }
    bool isPlane() const { return axis[0] && axis[1] && !axis[2] && !face[0] && !face[1]; }
};

class Axes {
  public:
    Axes(const nc::NcFile& file, const Model& model);

    /// Nothing for a variable with a dimension that is none of these and longer than 1, or with two
    /// of one axis.
    std::optional<Layout> layoutOf(const nc::NcVariable& variable) const;

    /// The variable of positions along a dimension of cells; null if there is none.
    static const nc::NcVariable* positions(const nc::NcFile& file, const Model& model,
                                           std::size_t axis, const std::string& dimension);
    /// The variable of positions of faces along an axis; null if there is none.
    static const nc::NcVariable* faces(const nc::NcFile& file, const Model& model,
                                       std::size_t axis);

  private:
    std::map<std::string, Place> places_;
};

/// Whether a file has the marks of a model.
bool isOf(const nc::NcFile& file, const Model& model);

/// The variable with exactly this name; null if there is none.
const nc::NcVariable* named(const nc::NcFile& file, std::string_view name);

/// What a variable is: by its standard name, else by its name in the row; null if neither is known.
const Name* nameOf(const nc::NcFile& file, const nc::NcVariable& variable, const Model& model);

/// Whether a variable is an amount of hydrometeors on the cells.
bool isWater(const nc::NcFile& file, const nc::NcVariable& variable, const Model& model,
             const Axes& axes);

}  // namespace cf
