// wrf_file.h: one WRF output file: its description, and its fields in SI.
//
// Opening reads only the header and Times. Boxes are x, y, z, half-open; values are x fastest.
// Failures are thrown as Failure or Cancelled.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/nc_file.h"

namespace wrf {

/// Whether values are stored, or which quantity is computed from stored variables.
enum class Source { stored, interfaceHeight, airPressure, airTemperature, dryAirDensity };

struct Variable : neph::plugin::Variable {
    Source source = Source::stored;
    const NcVariable* stored = nullptr;  ///< null for computed quantities
};

using neph::plugin::Time;

/// Cells [lower, upper) of a field.
struct Box {
    std::array<std::size_t, 3> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t layer() const { return length(0) * length(1); }
};

/// Called between slabs with the fraction done, 0 to 1; throws Cancelled to stop.
using Tick = std::function<void(double)>;

/// Whether a NetCDF file has the dimensions of WRF output.
bool looksLikeWrf(const NcFile& file);

/// An open WRF output file.
class WrfFile {
  public:
    /// Throws Failure if it is not WRF output, or lacks a field that is required.
    explicit WrfFile(const std::string& path);

    const std::vector<Variable>& variables() const { return variables_; }
    const std::vector<Time>& times() const { return times_; }
    const std::vector<std::string>& notes() const { return notes_; }
    const std::vector<std::pair<std::string, std::string>>& attributes() const {
        return attributes_;
    }
    const std::string& model() const { return model_; }
    const std::string& scheme() const { return scheme_; }
    NephMicrophysics microphysics() const { return microphysics_; }
    std::array<int, 3> size() const { return size_; }
    std::array<double, 2> spacingM() const { return spacingM_; }

    /// Reads a box of `variable` at time `time` into `values`, slab by slab.
    void read(const Variable& variable, std::size_t time, const Box& box, std::span<float> values,
              const Tick& tick) const;

  private:
    void describeGrid();
    void requireFields() const;
    void describeTimes();
    void describeModel();
    void addDerived();
    void addStored();
    /// The stored variable of this name. Throws Failure if it is missing.
    const NcVariable& stored(const char* name) const;
    void readSlab(const Variable& variable, std::size_t time, const Box& box,
                  std::span<float> values) const;
    void readStored(const NcVariable& variable, std::size_t time, const Box& box,
                    std::span<float> values) const;
    void readSum(const char* perturbation, const char* baseState, std::size_t time, const Box& box,
                 std::span<float> values) const;
    void readTemperature(std::size_t time, const Box& box, std::span<float> pressure) const;
    void readDensity(std::size_t time, const Box& box, std::span<float> pressure) const;

    NcFile file_;
    std::array<int, 3> size_{};
    std::array<double, 2> spacingM_{};
    std::string model_, scheme_;
    NephMicrophysics microphysics_ = NEPH_MICROPHYSICS_UNKNOWN;
    std::vector<Time> times_;
    std::vector<Variable> variables_;
    std::vector<std::string> notes_;
    std::vector<std::pair<std::string, std::string>> attributes_;
};

}  // namespace wrf
