// proj_map.h: a map projection of PROJ.
#pragma once
#include <array>
#include <optional>
#include <string>

struct pj_ctx;
struct PJconsts;

namespace grib {

/// Used by one thread at a time.
class ProjectedMap {
  public:
    /// Throws Failure if PROJ does not take the text.
    explicit ProjectedMap(const std::string& projection);
    ~ProjectedMap();
    ProjectedMap(const ProjectedMap&) = delete;
    ProjectedMap& operator=(const ProjectedMap&) = delete;

    /// Metres on the map of a place in degrees. Throws Failure off the map.
    std::array<double, 2> metres(double latitude, double longitude) const;
    /// Metres on the map per metre on the earth, the mean of both directions; nothing off the map.
    std::optional<double> factor(const std::array<double, 2>& metres) const;

  private:
    pj_ctx* context_;
    PJconsts* map_ = nullptr;
};

}  // namespace grib
