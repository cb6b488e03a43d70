// les_maker.h: writes small NetCDF files as LES models do, valid or invalid on purpose.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Value at an index along each axis, in the order of the variable's axes.
using IndexedValue = std::function<double(std::span<const std::size_t> at)>;

struct LesVariable {
    std::string name;
    std::vector<std::string> axes;
    std::string units{};  ///< empty: without the attribute
    IndexedValue value{};
    std::map<std::string, std::string> texts{};            ///< further attributes
    std::map<std::string, std::vector<double>> numbers{};  ///< the same, of numbers
    int type = 5;                                          ///< nc_type; NC_FLOAT
    std::string characters{};                              ///< of a variable of type NC_CHAR
};

struct LesFile {
    std::vector<std::pair<std::string, std::size_t>> dimensions;
    std::vector<LesVariable> variables;
    std::map<std::string, std::string> texts{};  ///< global attributes
    std::map<std::string, double> numbers{};     ///< the same, of numbers
    bool netcdf4 = false;

    LesVariable& variable(const std::string& name);
    void drop(const std::string& name);
    void resize(const std::string& dimension, std::size_t length);
};

void writeLes(const std::filesystem::path& path, const LesFile& file);

/// Numbers along one axis.
LesVariable along(const std::string& axis, std::vector<double> values, const std::string& units);
/// A field on (time, z, y, x), or another order of axes.
LesVariable field(const std::string& name, std::vector<std::string> axes, const std::string& units,
                  IndexedValue value);
IndexedValue constant(double value);

/// The grid of all samples: 4 x 3 cells of 100 x 200 m, and five layers with these interfaces.
inline const std::vector<double> kSampleFacesM{0.0, 40.0, 100.0, 180.0, 280.0, 400.0};
inline const std::vector<double> kSampleCentresM{20.0, 70.0, 140.0, 230.0, 340.0};
inline const std::vector<double> kSampleXM{50.0, 150.0, 250.0, 350.0};
inline const std::vector<double> kSampleYM{100.0, 300.0, 500.0};

/// A number that identifies time, level, row and column.
double numbered(std::size_t t, std::size_t z, std::size_t y, std::size_t x);
/// numbered() of a variable on (time, z, y, x).
IndexedValue numberedField();

/// Output of each model, with cloud water numbered() kg/kg at one time of 600 s or two.
LesFile cm1Sample();
LesFile samSample();
LesFile dalesSample();
LesFile palmSample();
LesFile moncSample();
LesFile uclalesSample();
LesFile microhhSample(const std::string& variable);
LesFile mesoNhSample();
LesFile cfSample();
