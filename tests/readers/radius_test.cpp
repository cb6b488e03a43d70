// radius_test.cpp: effective radii computed from masses, numbers and temperatures of a real run
// with the Thompson scheme, against the radii that the run itself wrote.
//
// In the bundled files masses have 3 digits, numbers and radii 2. So a radius of 10.5 µm may be off
// by 5 % (half of the last digit), and by another 1.7 % if it is computed from a number that is off
// by 5 %. Rounding has no bias, so the median shows the accuracy of the formulas.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/volume/radius_scheme.h"
#include "core/volume/resample.h"
#include "tests/readers/reader_host.h"

using namespace neph;

namespace {

const std::filesystem::path kStorm = std::filesystem::path(NEPH_TEST_SOURCE_DIR) /
                                     "samples/supercell/wrfout_d01_0001-01-01_01:00:00";

/// Ratios of our radius to the radius in the file, sorted, for all cells with more than 10 mg/m³ in
/// which the latter is within WRF's bounds.
std::vector<double> ratiosOf(Dataset& dataset, Species s) {
    const DatasetInfo& info = dataset.info();
    const auto read = [&](VariableRole role, std::optional<Species> species) {
        const VariableInfo* variable = info.find(role, species);
        return variable == nullptr ? Array3f() : dataset.read(variable->name, 0);
    };
    const Array3f ratio = read(VariableRole::mixingRatio, s);
    const Array3f density = read(VariableRole::dryAirDensity, {});
    const Array3f temperature = read(VariableRole::airTemperature, {});
    const Array3f number = read(VariableRole::numberConcentration, s);
    const Array3f radius = read(VariableRole::effectiveRadius, s);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ratio.values.size(); ++i) {
        const double rho = static_cast<double>(density.values[i]);
        CellState cell;
        cell.contentKgPerM3 = static_cast<double>(ratio.values[i]) * rho;
        cell.temperatureK = static_cast<double>(temperature.values[i]);
        if (!number.empty()) cell.numberPerM3 = static_cast<double>(number.values[i]) * rho;
        const double fileM = static_cast<double>(radius.values[i]);
        if (cell.contentKgPerM3 < 1e-5 || isBackgroundRadius(s, fileM)) continue;
        const ParticleSize size =
            sizeFromScheme(Microphysics::thompson, s, RadiationOptics::wrfRrtmg, cell);
        ratios.push_back(size.radiusM / fileM);
    }
    std::ranges::sort(ratios);
    return ratios;
}

}  // namespace

TEST_CASE("Radii diagnosed for the Thompson scheme are those that the model wrote") {
    const auto dataset = openFiles({kStorm});
    for (const Species s : {Species::cloud, Species::ice, Species::snow}) {
        CAPTURE(info(s).id);
        const std::vector<double> ratios = ratiosOf(*dataset, s);
        REQUIRE(ratios.size() > 9000);
        CHECK(ratios[ratios.size() / 2] == doctest::Approx(1.0).epsilon(1e-3));
        CHECK(ratios.front() > 1.0 - 0.068);
        CHECK(ratios.back() < 1.0 + 0.068);
    }
}
