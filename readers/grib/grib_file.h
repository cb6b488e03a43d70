// grib_file.h: one GRIB2 file as the host sees it: its description, and its fields in SI.
#pragma once
#include "core/plugin/reader_plugin.h"
#include "readers/grib/air.h"

namespace grib {

/// How the values of a variable are made.
enum class Source {
    stored,
    perMoistAir,  ///< stored per kg of moist air
    interfaceHeight,
    airPressure,
    airTemperature,
    dryAirDensity,
    vapour
};

struct Quantity : neph::plugin::Variable {
    Source source = Source::stored;
    Parameter parameter{};
};

/// An open file. Failures are thrown as Failure or Cancelled.
class GribFile : public neph::plugin::File {
  public:
    /// Reads the headers of all messages and two rows of heights. Throws Failure if the file has no
    /// levels that can be read.
    explicit GribFile(const char* path);

    const neph::plugin::Description& description() const override { return description_; }
    void read(const neph::plugin::Request& request) override;

  private:
    void turnUpward();
    void describeGrid();
    void describeTimes();
    void describeModel();
    void describeLevels();
    void noteEnd();
    void addAir();
    void addHydrometeors();
    void addOthers();
    void noteGaps(const Quantity& quantity);
    Quantity onCells(std::string name, std::string units, std::string description) const;
    std::vector<float> layerOf(const Quantity& quantity, const Layer& layer) const;

    InputFile file_;
    Inventory inventory_;
    Contents contents_;
    mutable FieldReader reader_;
    Air air_;
    std::size_t timeRead_ = 0;
    std::vector<Quantity> quantities_;  ///< parallel to the variables of the description
    neph::plugin::Description description_;
};

}  // namespace grib
