// scattering_tables.cpp: integrals of tables, in double precision, and their inverse.
#include "app/render/engines/reference/scattering_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/sky/atmosphere.h"

namespace neph::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kParts = 32;  // of an interval of the phase table; the integral is good to 1e-8
constexpr std::size_t kSteps = static_cast<std::size_t>(kPhaseTableSize - 1) * kParts;

/// Versine of the angle that belongs to an index of the table. shaders/lib/phase_table.glsl
double versineAt(double index) {
    const double x = index / (kPhaseTableSize - 1);
    const double sine = std::sin(0.5 * kPi * x * x);
    return 2.0 * sine * sine;
}

/// Share of the light within each of the steps, which are even in the index: the integral of a
/// linear function over the step, exact but for the curvature of the versine.
std::vector<double> lightOfSteps(const PhaseTable& table, int wavelength) {
    std::vector<double> light(kSteps);
    double before = 0.0;
    for (std::size_t i = 0; i < kSteps; ++i) {
        const double index = static_cast<double>(i) / kParts;
        const double after = versineAt(index + 1.0 / kParts);
        const auto entry = i / kParts;
        const double f = index - static_cast<double>(entry) + 0.5 / kParts;
        const auto lower = static_cast<double>(table[entry][wavelength]);
        const auto upper = static_cast<double>(table[entry + 1][wavelength]);
        light[i] = 2.0 * kPi * (lower + f * (upper - lower)) * (after - before);
        before = after;
    }
    return light;
}

double sumOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

}  // namespace

PhaseTable normalised(const PhaseTable& table) {
    PhaseTable out = table;
    for (int wavelength = 0; wavelength < 3; ++wavelength) {
        const double scale = 1.0 / sumOf(lightOfSteps(table, wavelength));
        for (glm::vec3& value : out) {
            value[wavelength] = static_cast<float>(static_cast<double>(value[wavelength]) * scale);
        }
    }
    return out;
}

std::vector<float> scatteringVersines(const PhaseTable& table, int wavelength) {
    const std::vector<double> light = lightOfSteps(table, wavelength);
    const double total = sumOf(light);
    std::vector<float> versines{0.0f};
    versines.reserve(kScatteringIntervals + 1);
    double sum = 0.0;
    std::size_t step = 0;
    for (int i = 1; i < kScatteringIntervals; ++i) {
        const double wanted = total * i / kScatteringIntervals;
        while (step + 1 < kSteps && sum + light[step] < wanted) sum += light[step++];
        const double f = light[step] > 0.0 ? std::min(1.0, (wanted - sum) / light[step]) : 0.0;
        const double lower = versineAt(static_cast<double>(step) / kParts);
        const double upper = versineAt(static_cast<double>(step + 1) / kParts);
        versines.push_back(static_cast<float>(lower + f * (upper - lower)));
    }
    versines.push_back(2.0f);
    return versines;
}

ScatteringTables makeScatteringTables(std::span<const PhaseSpec> phases) {
    std::vector<PhaseSpec> all(phases.begin(), phases.end());
    if (all.empty()) all.emplace_back();  // shaders have at least one class
    all.push_back({.kind = PhaseKind::rayleigh});
    all.push_back({.kind = PhaseKind::cornetteShanks, .g = static_cast<float>(kHazeG)});
    std::vector<glm::vec4> values;
    std::vector<float> versines;
    for (const PhaseSpec& spec : all) {
        const PhaseTable table = normalised(makePhaseTable(spec));
        for (const glm::vec3& value : table) values.emplace_back(value, 0.0f);
        for (int wavelength = 0; wavelength < 3; ++wavelength) {
            const std::vector<float> row = scatteringVersines(table, wavelength);
            versines.insert(versines.end(), row.begin(), row.end());
        }
    }
    const int rows = static_cast<int>(all.size());
    ScatteringTables tables;
    tables.phases = gl::Texture::make2D(GL_RGBA32F, {kPhaseTableSize, rows});
    tables.phases.upload(GL_RGBA, GL_FLOAT, values.data());
    tables.scattering = gl::Texture::make2D(GL_R32F, {kScatteringIntervals + 1, 3 * rows});
    tables.scattering.upload(GL_RED, GL_FLOAT, versines.data());
    return tables;
}

}  // namespace neph::render
