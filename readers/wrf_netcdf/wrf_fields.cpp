// wrf_fields.cpp: reads the fields of a WRF file, stored and computed, in slabs of levels.
//
// Equations of docs/physics.md §7: z = (PH+PHB)/9.81, p = P+PB, theta = T+300, T_K = theta
// (p/1e5)^(2/7), rho_d = p / (R_d T_K (1 + 1.6084 q_v)) with R_d = 287 J/(kg K). These are WRF's
// own constants.
#include <algorithm>
#include <cmath>
#include <limits>

#include "readers/wrf_netcdf/winds.h"
#include "readers/wrf_netcdf/wrf_file.h"

namespace wrf {
namespace {

constexpr float kGravity = 9.81f;                // m/s², WRF share/module_model_constants.F
constexpr float kBaseTheta = 300.0f;             // K, t0 there
constexpr float kReferencePressure = 1.0e5f;     // Pa, p1000mb there
constexpr float kDryGasConstant = 287.0f;        // J/(kg K), r_d there
constexpr float kKappa = 2.0f / 7.0f;            // r_d / cp with cp = 7/2 r_d there
constexpr float kVapourRatio = 461.6f / 287.0f;  // r_v / r_d there
constexpr float kFreezing = 273.15f;             // K, svpt0 there

// Slabs have at most this many values, so that cancelling takes effect soon, unless the chunks of
// the file are larger.
constexpr std::size_t kSlabValues = 1U << 18U;

/// Level at which the slab that starts at `z` ends: a boundary of chunks, so that none is
/// decompressed twice.
std::size_t slabEnd(const NcVariable& variable, std::size_t z, const Box& box) {
    const std::size_t rank = variable.axes.size();
    const std::size_t levels = std::max<std::size_t>(1, kSlabValues / box.plane());
    std::size_t end = z + levels;
    if (variable.chunk.size() == rank && rank >= 3) {
        const std::size_t chunk = std::max<std::size_t>(1, variable.chunk[rank - 3]);
        end = std::max(end / chunk, z / chunk + 1) * chunk;
    }
    return std::min(end, box.upper[2]);
}

/// A box of levels [lower, upper) over the same columns.
Box withLevels(Box box, std::size_t lower, std::size_t upper) {
    box.lower[2] = lower;
    box.upper[2] = upper;
    return box;
}

/// NaN where pressure or temperature cannot be those of air, so that nothing is derived from them.
void requirePossible(float pressure, float temperature, float& value) {
    const bool possible = pressure >= static_cast<float>(NEPH_LEAST_PRESSURE_PA) &&
                          pressure <= static_cast<float>(NEPH_MOST_PRESSURE_PA) &&
                          temperature >= static_cast<float>(NEPH_LEAST_TEMPERATURE_K) &&
                          temperature <= static_cast<float>(NEPH_MOST_TEMPERATURE_K);
    if (!possible) value = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

const NcVariable& WrfFile::leadingVariable(const Field& field) const {
    switch (field.source) {
        case Source::sum:
        case Source::warmPart:
        case Source::coldPart:
        case Source::meanOfFaces:
            return *field.terms.front().variable;
        case Source::interfaceHeight:
            return *air_.height.front().variable;
        case Source::airPressure:
        case Source::airTemperature:
        case Source::dryAirDensity:
            break;
    }
    return *air_.pressure.front().variable;
}

void WrfFile::read(std::size_t variable, std::size_t time, const Box& box, std::span<float> values,
                   const Tick& tick) const {
    const Field& field = fields_.at(variable);
    const std::size_t record = times_.records.at(time);
    const NcVariable& leading = leadingVariable(field);
    for (std::size_t z = box.lower[2]; z < box.upper[2];) {
        tick(static_cast<double>(z - box.lower[2]) / static_cast<double>(box.length(2)));
        const Box slab = withLevels(box, z, slabEnd(leading, z, box));
        readSlab(field, record, slab,
                 values.subspan((z - box.lower[2]) * box.plane(), slab.count()));
        z = slab.upper[2];
    }
    tick(1.0);
}

void WrfFile::readSlab(const Field& field, std::size_t record, const Box& box,
                       std::span<float> values) const {
    switch (field.source) {
        case Source::sum:
            return readSum(field.terms, record, box, values);
        case Source::interfaceHeight:
            return readHeights(record, box, values);
        case Source::airPressure:
            return readSum(air_.pressure, record, box, values);
        case Source::airTemperature:
            std::ranges::copy(readTemperature(record, box, readPressure(record, box)),
                              values.begin());
            return;
        case Source::dryAirDensity:
            return readDensity(record, box, values);
        case Source::warmPart:
        case Source::coldPart:
            return readPhase(field, record, box, values);
        case Source::meanOfFaces:
            return readMeans(field, record, box, values);
    }
}

void WrfFile::readTerm(const Term& term, std::size_t record, const Box& box,
                       std::span<float> values) const {
    tiles_.read(*term.variable, record, box, values);
    if (term.toSi.isIdentity()) return;
    for (float& value : values) value = static_cast<float>(term.toSi(static_cast<double>(value)));
}

void WrfFile::readSum(std::span<const Term> terms, std::size_t record, const Box& box,
                      std::span<float> values) const {
    readTerm(terms.front(), record, box, values);
    std::vector<float> other(terms.size() > 1 ? values.size() : 0);
    for (const Term& term : terms.subspan(1)) {
        readTerm(term, record, box, other);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += other[i];
    }
}

void WrfFile::readHeights(std::size_t record, const Box& box, std::span<float> values) const {
    if (!air_.onInterfaces) return readHeightsOfCentres(record, box, values);
    readSum(air_.height, record, box, values);
    if (!air_.geopotential) return;
    for (float& value : values) value /= kGravity;
}

/// Interfaces halfway between centres; the lowest is the terrain or half a layer below the lowest
/// centre, the highest half a layer above the highest.
void WrfFile::readHeightsOfCentres(std::size_t record, const Box& box,
                                   std::span<float> values) const {
    const std::size_t levels = tiles_.axes().length[2];
    const std::size_t lower = std::min(box.lower[2] > 0 ? box.lower[2] - 1 : 0, levels - 1);
    // The outermost interfaces need two centres each.
    const std::size_t first = lower + 2 > levels && levels > 1 ? levels - 2 : lower;
    const std::size_t last = std::min(levels, std::max(box.upper[2], first + 2));
    const Box centres = withLevels(box, first, last);
    std::vector<float> height(centres.count());
    readSum(air_.height, record, centres, height);
    if (air_.geopotential) {
        for (float& value : height) value /= kGravity;
    }
    const std::size_t layer = box.plane();
    const auto centre = [&](std::size_t column, std::size_t level) {
        return height[(level - first) * layer + column];
    };
    std::vector<float> ground(layer);
    if (!air_.terrain.empty())
        readTerm(air_.terrain.front(), record, withLevels(box, 0, 1), ground);
    for (std::size_t k = box.lower[2]; k < box.upper[2]; ++k) {
        for (std::size_t c = 0; c < layer; ++c) {
            float& value = values[(k - box.lower[2]) * layer + c];
            if (levels == 1) {
                value = k == 0 ? ground[c] : 2.0f * centre(c, 0) - ground[c];
            } else if (k == 0) {
                value =
                    air_.terrain.empty() ? 1.5f * centre(c, 0) - 0.5f * centre(c, 1) : ground[c];
            } else if (k == levels) {
                value = 1.5f * centre(c, k - 1) - 0.5f * centre(c, k - 2);
            } else {
                value = 0.5f * (centre(c, k - 1) + centre(c, k));
            }
        }
    }
}

std::vector<float> WrfFile::readPressure(std::size_t record, const Box& box) const {
    std::vector<float> values(box.count());
    readSum(air_.pressure, record, box, values);
    return values;
}

/// Water vapour, not below zero and NaN where it is impossible; empty if the file has none.
std::vector<float> WrfFile::readVapour(std::size_t record, const Box& box) const {
    if (air_.vapour.empty()) return {};
    std::vector<float> values(box.count());
    readSum(air_.vapour, record, box, values);
    for (float& value : values) {
        const bool possible = value >= static_cast<float>(NEPH_LEAST_VAPOUR_KG_PER_KG) &&
                              value <= static_cast<float>(NEPH_MOST_VAPOUR_KG_PER_KG);
        value = possible ? std::max(value, 0.0f) : std::numeric_limits<float>::quiet_NaN();
    }
    return values;
}

/// Temperature, K, from whatever the file has as heat.
std::vector<float> WrfFile::readTemperature(std::size_t record, const Box& box,
                                            std::span<const float> pressure) const {
    std::vector<float> values(box.count());
    readSum(air_.heat, record, box, values);
    if (air_.kind == Heat::temperature) return values;
    const float base = air_.kind == Heat::theta ? 0.0f : kBaseTheta;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = (values[i] + base) * std::pow(pressure[i] / kReferencePressure, kKappa);
    }
    if (air_.kind != Heat::moistThetaMinus300) return values;
    const std::vector<float> vapour = readVapour(record, box);
    for (std::size_t i = 0; i < vapour.size(); ++i) values[i] /= 1.0f + kVapourRatio * vapour[i];
    return values;
}

void WrfFile::readDensity(std::size_t record, const Box& box, std::span<float> values) const {
    const std::vector<float> pressure = readPressure(record, box);
    const std::vector<float> temperature = readTemperature(record, box, pressure);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = pressure[i] / (kDryGasConstant * temperature[i]);
    }
    const std::vector<float> vapour = readVapour(record, box);
    for (std::size_t i = 0; i < vapour.size(); ++i) values[i] /= 1.0f + kVapourRatio * vapour[i];
    for (std::size_t i = 0; i < values.size(); ++i) {
        requirePossible(pressure[i], temperature[i], values[i]);
    }
}

/// Liquid where the air is not below 0 °C, ice elsewhere. Where the temperature is unknown the
/// value is too.
void WrfFile::readPhase(const Field& field, std::size_t record, const Box& box,
                        std::span<float> values) const {
    readSum(field.terms, record, box, values);
    const std::vector<float> temperature = readTemperature(record, box, readPressure(record, box));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(temperature[i])) {
            values[i] = std::numeric_limits<float>::quiet_NaN();
        } else if ((temperature[i] < kFreezing) != (field.source == Source::coldPart)) {
            values[i] = 0.0f;
        }
    }
}

void WrfFile::readMeans(const Field& field, std::size_t record, const Box& box,
                        std::span<float> values) const {
    const Term& term = field.terms.front();
    const int axis = facesAxisOf(tiles_, *term.variable);
    Box wider = box;
    ++wider.upper[static_cast<std::size_t>(axis)];
    std::vector<float> faces(wider.count());
    readTerm(term, record, wider, faces);
    meansOfFaces(faces, axis, box, values);
}

}  // namespace wrf
