// wrf_file.h: one WRF output file, or the tiles of one: its description, and its fields in SI.
//
// Opening reads the header, Times, map scale factors, latitudes and longitudes. Boxes are x, y, z,
// half-open; values are x fastest. Failures are thrown as Failure or Cancelled.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/air.h"
#include "readers/wrf_netcdf/fields.h"
#include "readers/wrf_netcdf/wrf_times.h"

namespace wrf {

/// Called between slabs with the fraction done, 0 to 1; throws Cancelled to stop.
using Tick = std::function<void(double)>;

/// Whether a NetCDF file has fields on the grid of WRF output.
bool looksLikeWrf(const NcFile& file);

/// An open WRF output file.
class WrfFile {
  public:
    /// Throws Failure if it is not WRF output, or lacks a field that is required.
    explicit WrfFile(const std::string& path);

    const neph::plugin::Description& description() const { return description_; }

    /// Reads a box of a variable of the description at a time of it, slab by slab.
    void read(std::size_t variable, std::size_t time, const Box& box, std::span<float> values,
              const Tick& tick) const;

  private:
    void requireCells() const;
    void describeGrid();
    void describePlaceAndDate();
    void describeModel();
    void addFields();
    void requireUpward() const;
    void dropUnfinished();
    bool isFinished(const NcVariable& variable, std::size_t record) const;
    /// The variable whose chunks decide how a field is cut into slabs.
    const NcVariable& leadingVariable(const Field& field) const;
    void readSlab(const Field& field, std::size_t record, const Box& box,
                  std::span<float> values) const;
    void readTerm(const Term& term, std::size_t record, const Box& box,
                  std::span<float> values) const;
    void readSum(std::span<const Term> terms, std::size_t record, const Box& box,
                 std::span<float> values) const;
    void readHeights(std::size_t record, const Box& box, std::span<float> values) const;
    void readHeightsOfCentres(std::size_t record, const Box& box, std::span<float> values) const;
    std::vector<float> readPressure(std::size_t record, const Box& box) const;
    std::vector<float> readVapour(std::size_t record, const Box& box) const;
    std::vector<float> readTemperature(std::size_t record, const Box& box,
                                       std::span<const float> pressure) const;
    void readDensity(std::size_t record, const Box& box, std::span<float> values) const;
    void readMeans(const Field& field, std::size_t record, const Box& box,
                   std::span<float> values) const;
    void readPhase(const Field& field, std::size_t record, const Box& box,
                   std::span<float> values) const;

    Tiles tiles_;
    FileTimes times_;
    AirSources air_;
    Scheme scheme_;
    std::vector<Field> fields_;  ///< parallel to the variables of the description
    neph::plugin::Description description_;
};

}  // namespace wrf
