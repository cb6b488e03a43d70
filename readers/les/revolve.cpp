// revolve.cpp: reads the range of radii that a box needs and interpolates.
#include "readers/les/revolve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/les/levels.h"
#include "readers/les/text.h"

namespace les {
namespace {

namespace plugin = neph::plugin;

/// The file around the axis; reads from the one along the radius.
class RevolvedFile : public plugin::File {
  public:
    explicit RevolvedFile(std::unique_ptr<plugin::File> flat);
    const plugin::Description& description() const override { return description_; }
    void read(const plugin::Request& request) override;

  private:
    /// Position of a radius among the centres of cells: n - 1 at most; more beyond the last cell.
    double placeOf(double radiusM) const;
    double radiusOf(std::size_t x, std::size_t y) const;

    std::unique_ptr<plugin::File> flat_;
    plugin::Description description_;
    std::vector<double> facesM_, centresM_;  ///< along the radius, the first face on the axis
    bool even_ = true;
};

RevolvedFile::RevolvedFile(std::unique_ptr<plugin::File> flat)
    : flat_(std::move(flat)), description_(flat_->description()) {
    if (description_.size[1] != 1) {
        throw Error{
            "an axisymmetric run has more than one row",
            fmt::format("{} rows", description_.size[1]), "1 row: values along the radius",
            "set axisymm = 0 in the namelist.input beside it if the run is not axisymmetric"};
    }
    const int n = description_.size[0];
    facesM_ = description_.edgesM[0];
    even_ = facesM_.empty();
    for (int i = 0; even_ && i <= n; ++i) facesM_.push_back(description_.spacingM[0] * i);
    centresM_ = centresOf(facesM_);
    if (!even_) {
        std::vector<double> around;
        for (auto face = facesM_.rbegin(); face != facesM_.rend(); ++face) {
            around.push_back(facesM_.back() - *face);
        }
        for (std::size_t i = 1; i < facesM_.size(); ++i) {
            around.push_back(facesM_.back() + facesM_[i]);
        }
        description_.edgesM = {around, around};
    }
    description_.spacingM[1] = description_.spacingM[0];
    description_.size[0] = description_.size[1] = 2 * n;
    for (plugin::Variable& variable : description_.variables) {
        if (variable.size[0] == n) variable.size[0] = variable.size[1] = 2 * n;
    }
    description_.notes.push_back(fmt::format(
        "The run is axisymmetric (axisymm = 1): its {} x 1 columns are revolved around the axis to "
        "{} x {}, linear in the radius.",
        n, 2 * n, 2 * n));
}

double RevolvedFile::radiusOf(std::size_t x, std::size_t y) const {
    const std::size_t n = centresM_.size();
    const double east = centresM_[x < n ? n - 1 - x : x - n];
    const double north = centresM_[y < n ? n - 1 - y : y - n];
    return std::hypot(east, north);
}

double RevolvedFile::placeOf(double radiusM) const {
    const auto last = static_cast<double>(centresM_.size() - 1);
    if (radiusM > facesM_.back()) return last + 1.0;
    if (radiusM <= centresM_.front()) return 0.0;
    if (radiusM >= centresM_.back()) return last;
    const auto above = std::ranges::upper_bound(centresM_, radiusM);
    const auto below = above - 1;
    return static_cast<double>(below - centresM_.begin()) + (radiusM - *below) / (*above - *below);
}

void RevolvedFile::read(const plugin::Request& request) {
    const plugin::Variable& variable = description_.variables[request.variable];
    if (variable.size[0] == 1) return flat_->read(request);
    std::vector<double> places;
    for (std::size_t y = request.lower[1]; y < request.upper[1]; ++y) {
        for (std::size_t x = request.lower[0]; x < request.upper[0]; ++x) {
            places.push_back(placeOf(radiusOf(x, y)));
        }
    }
    const std::size_t last = centresM_.size() - 1;
    const auto [least, most] = std::ranges::minmax(places);
    const std::size_t from = std::min(static_cast<std::size_t>(least), last);
    const std::size_t to = std::min(static_cast<std::size_t>(most) + 1, last) + 1;
    plugin::Request row = request;
    row.lower = {from, 0, request.lower[2]};
    row.upper = {to, 1, request.upper[2]};
    std::vector<float> values(row.count());
    row.values = values.data();
    flat_->read(row);
    const bool amount =
        variable.role == NEPH_ROLE_MIXING_RATIO || variable.role == NEPH_ROLE_NUMBER_CONCENTRATION;
    for (std::size_t k = 0; k < request.length(2); ++k) {
        const float* level = values.data() + k * (to - from);
        float* target = request.values + k * places.size();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t below = std::min(static_cast<std::size_t>(places[i]), last);
            const std::size_t above = std::min(below + 1, last);
            const auto part = static_cast<float>(places[i] - static_cast<double>(below));
            const float low = level[below - from];
            const float value =
                below == above || part == 0.0f ? low : low + part * (level[above - from] - low);
            target[i] = amount && places[i] > static_cast<double>(last) ? 0.0f : value;
        }
    }
}

}  // namespace

std::unique_ptr<plugin::File> revolved(std::unique_ptr<plugin::File> flat) {
    return std::make_unique<RevolvedFile>(std::move(flat));
}

}  // namespace les
