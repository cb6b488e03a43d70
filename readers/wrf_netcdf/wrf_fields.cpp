// wrf_fields.cpp: reads the fields of a WRF file, stored and derived, in slabs of levels.
//
// Equations of docs/physics.md §7: z = (PH+PHB)/9.81, p = P+PB, theta = T+300, T_K = theta
// (p/1e5)^(2/7), rho_d = p / (R_d T_K (1 + 1.6084 q_v)) with R_d = 287 J/(kg K). These are WRF's
// own constants.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/wrf_netcdf/wrf_file.h"

namespace wrf {
namespace {

constexpr float kGravity = 9.81f;                // m/s², WRF share/module_model_constants.F
constexpr float kBaseTheta = 300.0f;             // K, t0 there
constexpr float kReferencePressure = 1.0e5f;     // Pa, p1000mb there
constexpr float kDryGasConstant = 287.0f;        // J/(kg K), r_d there
constexpr float kKappa = 2.0f / 7.0f;            // r_d / cp with cp = 7/2 r_d there
constexpr float kVapourRatio = 461.6f / 287.0f;  // r_v / r_d there

// Slabs have at most this many values, so that cancelling takes effect soon, unless the chunks of
// the file are larger.
constexpr std::size_t kSlabValues = 1U << 18U;

/// Level at which the slab that starts at `z` ends: a boundary of chunks, so that none is
/// decompressed twice.
std::size_t slabEnd(const NcVariable& variable, std::size_t z, const Box& box) {
    const std::size_t rank = variable.axes.size();
    const std::size_t levels = std::max<std::size_t>(1, kSlabValues / box.layer());
    std::size_t end = z + levels;
    if (variable.chunk.size() == rank && rank >= 3) {
        const std::size_t chunk = std::max<std::size_t>(1, variable.chunk[rank - 3]);
        end = std::max(end / chunk, z / chunk + 1) * chunk;
    }
    return std::min(end, box.upper[2]);
}

/// Temperature, K, from WRF's T, the perturbation potential temperature in K, and pressure in Pa.
float temperatureK(float thetaPerturbation, float pressurePa) {
    return (thetaPerturbation + kBaseTheta) * std::pow(pressurePa / kReferencePressure, kKappa);
}

}  // namespace

const NcVariable& WrfFile::stored(const char* name) const {
    const NcVariable* variable = file_.variable(name);
    if (variable == nullptr) throw Failure{fmt::format("variable {} is missing", name), {}, {}, {}};
    return *variable;
}

void WrfFile::read(const Variable& variable, std::size_t time, const Box& box,
                   std::span<float> values, const Tick& tick) const {
    // A derived field is cut into slabs at the chunks of the first variable that it is made from.
    const char* leading = variable.source == Source::interfaceHeight ? "PH" : "P";
    const NcVariable& shape =
        variable.source == Source::stored ? *variable.stored : stored(leading);
    for (std::size_t z = box.lower[2]; z < box.upper[2];) {
        tick(static_cast<double>(z - box.lower[2]) / static_cast<double>(box.length(2)));
        Box slab = box;
        slab.lower[2] = z;
        slab.upper[2] = slabEnd(shape, z, box);
        readSlab(variable, time, slab,
                 values.subspan((z - box.lower[2]) * box.layer(), slab.layer() * slab.length(2)));
        z = slab.upper[2];
    }
    tick(1.0);
}

void WrfFile::readSlab(const Variable& variable, std::size_t time, const Box& box,
                       std::span<float> values) const {
    switch (variable.source) {
        case Source::stored:
            return readStored(*variable.stored, time, box, values);
        case Source::interfaceHeight:
            readSum("PH", "PHB", time, box, values);
            for (float& value : values) value /= kGravity;
            return;
        case Source::airPressure:
            return readSum("P", "PB", time, box, values);
        case Source::airTemperature:
            readSum("P", "PB", time, box, values);
            return readTemperature(time, box, values);
        case Source::dryAirDensity:
            readSum("P", "PB", time, box, values);
            return readDensity(time, box, values);
    }
}

/// Sum of a perturbation and its base state.
void WrfFile::readSum(const char* perturbation, const char* baseState, std::size_t time,
                      const Box& box, std::span<float> values) const {
    std::vector<float> base(values.size());
    readStored(stored(perturbation), time, box, values);
    readStored(stored(baseState), time, box, base);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += base[i];
}

/// Replaces pressure by temperature in place.
void WrfFile::readTemperature(std::size_t time, const Box& box, std::span<float> pressure) const {
    std::vector<float> theta(pressure.size());
    readStored(stored("T"), time, box, theta);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        pressure[i] = temperatureK(theta[i], pressure[i]);
    }
}

/// Replaces pressure by the density of dry air in place.
void WrfFile::readDensity(std::size_t time, const Box& box, std::span<float> pressure) const {
    std::vector<float> other(pressure.size());
    readStored(stored("T"), time, box, other);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        pressure[i] /= kDryGasConstant * temperatureK(other[i], pressure[i]);
    }
    const NcVariable* vapour = file_.variable("QVAPOR");
    if (vapour == nullptr) return;
    readStored(*vapour, time, box, other);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        pressure[i] /= 1.0f + kVapourRatio * std::max(other[i], 0.0f);
    }
}

/// Converts the box to starts and counts in file order: time, z, y, x.
void WrfFile::readStored(const NcVariable& variable, std::size_t time, const Box& box,
                         std::span<float> values) const {
    std::vector<std::size_t> start;
    std::vector<std::size_t> count;
    if (variable.axes.front().name == "Time") {
        start.push_back(time);
        count.push_back(1);
    }
    const bool flat = variable.axes.size() - start.size() == 2;
    for (std::size_t axis = flat ? 2 : 3; axis-- > 0;) {
        start.push_back(box.lower[axis]);
        count.push_back(box.length(axis));
    }
    file_.read(variable, start, count, values);
}

}  // namespace wrf
