// wrf_file.h: one WRF output file: what is in it, and its fields in SI.
//
// Opening reads the header and Times alone. Boxes are x, y, z, half-open; values come x fastest.
// Everything fails by throwing Failure or Cancelled.
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

/// How the values of a variable come about.
enum class Source { stored, interfaceHeight, airPressure, airTemperature, dryAirDensity };

struct Variable : neph::plugin::Variable {
    Source source = Source::stored;
    const NcVariable* stored = nullptr;
};

using neph::plugin::Time;

struct Box {
    std::array<std::size_t, 3> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t layer() const { return length(0) * length(1); }
};

/// Called between slabs with a fraction; throws Cancelled to stop.
using Tick = std::function<void(double)>;

/// Whether a NetCDF file has the dimensions of WRF output.
bool looksLikeWrf(const NcFile& file);

class WrfFile {
  public:
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

    /// Reads a box of a variable at a time into `values`, slab by slab.
    void read(const Variable& variable, std::size_t time, const Box& box, std::span<float> values,
              const Tick& tick) const;

  private:
    void describeGrid();
    void requireFields() const;
    void describeTimes();
    void describeModel();
    void addDerived();
    void addStored();
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
