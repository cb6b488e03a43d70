// sky_tables.cpp: rays in all directions, shared out over threads.
#include "core/sky/sky_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/base/parallel.h"
#include "core/sky/air_columns.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;

constexpr std::size_t kMostThreads = 16;
static_assert(glsl::kAltitudeRows == glsl::kFirstPatternRow + static_cast<int>(kSkyPatterns));
/// Of the sky that the patterns are of: in the middle of deep clouds.
constexpr double kPatternAltitudeM = 5000.0;

constexpr std::size_t size(int n) {
    return static_cast<std::size_t>(n);
}

float shareOf(std::size_t i, int count) {
    return static_cast<float>(i) / static_cast<float>(count - 1);
}

vec4 colourOf(const Spectrum& radiance) {
    return {vec3(4.0 * std::numbers::pi * rgbOfSunlight(radiance)), 0.0f};
}

/// Of white light.
vec4 shareOfWhite(const Spectrum& share) {
    static const dvec3 white = rgbOfSunlight(Spectrum(1.0f));
    return {vec3(rgbOfSunlight(share) / white), 0.0f};
}

/// Tables of the sky, of one altitude.
void fillSky(const Atmosphere& air, double altitudeM, double sunUp, glm::ivec2 count,
             std::span<vec4> to) {
    const float horizon = glsl::horizonSine(static_cast<float>(altitudeM));
    const auto row = [&](std::size_t j, std::size_t, const Progress&) {
        // The horizon itself is not the ground.
        const double up = static_cast<double>(glsl::skyUpOfShare(shareOf(j, count.y), horizon));
        for (std::size_t i = 0; i < size(count.x); ++i) {
            const double azimuth = static_cast<double>(glsl::azimuthOfShare(shareOf(i, count.x)));
            const SkyRay ray{altitudeM, std::max(up, horizonUp(altitudeM) + 1e-9), azimuth, sunUp};
            to[j * size(count.x) + i] = colourOf(air.along(ray).radiance);
        }
    };
    shareOut(size(count.y), workerCount(kMostThreads), row);
}

void fillAir(const Atmosphere& air, double altitudeM, double sunUp, SkyTables& tables) {
    using namespace glsl;
    const float horizon = horizonSine(static_cast<float>(altitudeM));
    tables.air.resize(size(kAirAzimuths) * size(kAirElevations) * size(kAirDistances));
    tables.sunnyAir.resize(tables.air.size());
    tables.clear.resize(size(kAirElevations) * size(kAirDistances));
    tables.byMolecules.resize(tables.clear.size());
    tables.byHaze.resize(tables.clear.size());
    const auto row = [&](std::size_t j, std::size_t, const Progress&) {
        const float up = airUpOfShare(shareOf(j, kAirElevations), horizon);
        std::array<double, kAirDistances> distancesM{};
        std::array<AirLight, kAirDistances> light;
        const float fromM = thinAirM(static_cast<float>(altitudeM), up);
        for (std::size_t k = 0; k < distancesM.size(); ++k) {
            distancesM[k] =
                static_cast<double>(fromM + lengthOfShare(shareOf(k, kAirDistances), kAirRangeM));
        }
        for (std::size_t i = 0; i < size(kAirAzimuths); ++i) {
            const auto azimuth = static_cast<double>(azimuthOfShare(shareOf(i, kAirAzimuths)));
            air.along({altitudeM, static_cast<double>(up), azimuth, sunUp}, distancesM, light);
            for (std::size_t k = 0; k < distancesM.size(); ++k) {
                const std::size_t at = k * size(kAirElevations) + j;
                tables.air[at * size(kAirAzimuths) + i] = colourOf(light[k].radiance);
                tables.sunnyAir[at * size(kAirAzimuths) + i] = colourOf(light[k].once);
                if (i > 0) continue;
                tables.clear[at] = shareOfWhite(light[k].clear);
                tables.byMolecules[at] = shareOfWhite(light[k].byMolecules);
                tables.byHaze[at] = shareOfWhite(light[k].byHaze);
            }
        }
    };
    shareOut(size(kAirElevations), workerCount(kMostThreads), row);
}

/// The sky around one altitude, and the solid angle that each of its texels stands for.
struct Around {
    Around(const Atmosphere& air, double altitude, double sunUp)
        : altitudeM(altitude), radiance(size(kCount.x * kCount.y)) {
        fillSky(air, altitude, sunUp, kCount, radiance);
        const float horizon = glsl::horizonSine(static_cast<float>(altitude));
        const auto edge = [&](double place, int count) {
            return static_cast<float>(std::clamp(place / (count - 1), 0.0, 1.0));
        };
        const auto upAt = [&](double place) {
            return static_cast<double>(glsl::skyUpOfShare(edge(place, kCount.y), horizon));
        };
        const auto azimuthAt = [&](double place) {
            return static_cast<double>(glsl::azimuthOfShare(edge(place, kCount.x)));
        };
        for (int j = 0; j < kCount.y; ++j) {
            ups.push_back(upAt(j));
            for (int i = 0; i < kCount.x; ++i) {
                solidAngle.push_back(2.0 * (upAt(j + 0.5) - upAt(j - 0.5)) *
                                     (azimuthAt(i + 0.5) - azimuthAt(i - 0.5)));
            }
        }
    }
    static constexpr glm::ivec2 kCount{glsl::kAroundAzimuths, glsl::kAroundElevations};

    /// On a level surface, by channel.
    dvec3 irradiance() const {
        dvec3 sum(0.0);
        for (std::size_t t = 0; t < radiance.size(); ++t) {
            sum += solidAngle[t] * std::max(ups[t / size(kCount.x)], 0.0) * dvec3(radiance[t]);
        }
        return sum;
    }

    double altitudeM;
    std::vector<vec4> radiance;
    std::vector<double> solidAngle, ups;
};

/// Red and blue of one sky: any other sky of the same sun is nearly a sum of both.
std::array<SkyPattern, kSkyPatterns> patternsOf(const Around& around) {
    std::array<SkyPattern, kSkyPatterns> patterns;
    const dvec3 irradiance = around.irradiance();
    for (std::size_t p = 0; p < kSkyPatterns; ++p) {
        const auto channel = static_cast<glm::length_t>(p == 0 ? 0 : 2);
        const double scale =
            irradiance[channel] > 0.0 ? std::numbers::pi / irradiance[channel] : 0.0;
        for (const vec4& texel : around.radiance) {
            patterns[p].radiance.push_back(static_cast<float>(scale) * texel[channel]);
        }
    }
    return patterns;
}

/// Colours by which the patterns add up to the sky around an altitude: least squares of what it is
/// off by relative to them, and then exactly its light on a level surface.
std::array<dvec3, kSkyPatterns> coloursOf(const Around& around,
                                          const std::array<SkyPattern, kSkyPatterns>& patterns) {
    constexpr double kRidge = 1e-6;  // where both patterns are the same
    double aa = 0.0, ab = 0.0, bb = 0.0;
    dvec3 ac(0.0), bc(0.0);
    for (std::size_t t = 0; t < around.radiance.size(); ++t) {
        const auto a = static_cast<double>(patterns[0].radiance[t]);
        const auto b = static_cast<double>(patterns[1].radiance[t]);
        const double weight = around.solidAngle[t] / (a + b + 1e-3);
        aa += weight * a * a;
        ab += weight * a * b;
        bb += weight * b * b;
        ac += weight * a * dvec3(around.radiance[t]);
        bc += weight * b * dvec3(around.radiance[t]);
    }
    aa *= 1.0 + kRidge;
    bb *= 1.0 + kRidge;
    const double determinant = aa * bb - ab * ab;
    if (determinant <= 0.0) return {};
    const dvec3 ofA = (bb * ac - ab * bc) / determinant, ofB = (aa * bc - ab * ac) / determinant;
    // Patterns have irradiance pi.
    const dvec3 made = std::numbers::pi * (ofA + ofB), wanted = around.irradiance();
    dvec3 scale(1.0);
    for (int c = 0; c < 3; ++c) {
        if (made[c] > 0.5 * wanted[c] && wanted[c] > 0.0) scale[c] = wanted[c] / made[c];
    }
    return {scale * ofA, scale * ofB};
}

void fillAltitudes(const Atmosphere& air, double sunUp, const std::vector<Around>& levels,
                   SkyTables& tables) {
    std::vector<std::array<dvec3, kSkyPatterns>> colours;
    for (const Around& level : levels) colours.push_back(coloursOf(level, tables.dome->patterns));
    const auto count = size(glsl::kAltitudes);
    tables.byAltitude.resize(size(glsl::kAltitudeRows) * count);
    for (std::size_t i = 0; i < count; ++i) {
        const float altitudeM = glsl::lengthOfShare(shareOf(i, glsl::kAltitudes), glsl::kHighestM);
        const Spectrum sun = air.sunlight(static_cast<double>(altitudeM), sunUp);
        tables.byAltitude[i] = {vec3(rgbOfSunlight(sun)), 0.0f};
        const double at = static_cast<double>(glsl::lengthShare(altitudeM, glsl::kHighestAroundM)) *
                          static_cast<double>(levels.size() - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(at), levels.size() - 2);
        for (std::size_t p = 0; p < kSkyPatterns; ++p) {
            const dvec3 between =
                glm::mix(colours[below][p], colours[below + 1][p], at - static_cast<double>(below));
            tables.byAltitude[(1 + p) * count + i] = {vec3(between), 0.0f};
        }
    }
}

/// What a cloud sees of the air between it and the ground.
void fillAirBelow(const Atmosphere& air, double sunUp, const dvec3& irradiance, SkyDome& dome) {
    constexpr int kUps = 4, kAzimuths = 6;
    dvec3 flux(0.0), clear(0.0);
    for (int i = 0; i < kUps; ++i) {
        // Evenly in the square of the sine, so that each has the same part in the flux.
        const double up = -std::sqrt((i + 0.5) / kUps);
        for (int j = 0; j < kAzimuths; ++j) {
            const double azimuth = std::numbers::pi * (j + 0.5) / kAzimuths;
            const AirLight light = air.along({kPatternAltitudeM, up, azimuth, sunUp});
            flux += dvec3(colourOf(light.radiance));
            clear += dvec3(shareOfWhite(light.clear));
        }
    }
    const auto luminance = [](const dvec3& of) { return glm::dot(of, dvec3(glsl::kLuminance)); };
    constexpr double kMostAlbedo = 0.5;  // at night there is no telling
    const double perDirection = 1.0 / (kUps * kAzimuths);
    const double falls = luminance(irradiance);
    if (falls > 0.0) {
        dome.airAlbedo =
            std::min(std::numbers::pi * perDirection * luminance(flux) / falls, kMostAlbedo);
    }
    dome.airClear = perDirection * luminance(clear);
}

}  // namespace

double SkyPattern::at(const dvec3& towards, const dvec3& towardsSun) const {
    const glm::ivec2 count = Around::kCount;
    const float horizon = glsl::horizonSine(static_cast<float>(kPatternAltitudeM));
    const glm::vec2 share{glsl::azimuthShare(vec3(towards), vec3(towardsSun)),
                          glsl::skyShare(static_cast<float>(towards.z), horizon)};
    const glm::vec2 place = share * glm::vec2(count - 1);
    const glm::ivec2 cell = glm::min(glm::ivec2(place), count - 2);
    const glm::vec2 f = place - glm::vec2(cell);
    const float* row = &radiance[size(cell.y * count.x + cell.x)];
    const float* above = row + count.x;
    return static_cast<double>(
        glm::mix(glm::mix(row[0], row[1], f.x), glm::mix(above[0], above[1], f.x), f.y));
}

double SkyPattern::atHorizon() const {
    double sum = 0.0, share = 0.0;
    for (int i = 0; i < Around::kCount.x; ++i) {
        const auto weight = static_cast<double>(i);  // azimuths are the squares of shares
        sum += weight * static_cast<double>(radiance[size(i)]);
        share += weight;
    }
    return sum / share;
}

double SkyDome::sunAt(double altitudeM) const {
    const float place =
        glsl::lengthShare(static_cast<float>(altitudeM), glsl::kHighestM) * (glsl::kAltitudes - 1);
    const auto below = std::min(static_cast<std::size_t>(place), sunByAltitude.size() - 2);
    return static_cast<double>(glm::mix(sunByAltitude[below], sunByAltitude[below + 1],
                                        place - static_cast<float>(below)));
}

SkyTables makeSkyTables(const Atmosphere& air, const dvec3& towardsSun, double eyeAltitudeM) {
    const double sunUp = towardsSun.z;
    SkyTables tables;
    std::vector<Around> levels;
    for (std::size_t k = 0; k < size(glsl::kAroundAltitudes); ++k) {
        const float altitudeM =
            glsl::lengthOfShare(shareOf(k, glsl::kAroundAltitudes), glsl::kHighestAroundM);
        levels.emplace_back(air, static_cast<double>(altitudeM), sunUp);
        tables.around.insert(tables.around.end(), levels.back().radiance.begin(),
                             levels.back().radiance.end());
    }
    tables.skyOnGround = levels.front().irradiance() / (4.0 * std::numbers::pi);
    auto dome = std::make_shared<SkyDome>();
    dome->towardsSun = towardsSun;
    dome->patterns = patternsOf(Around(air, kPatternAltitudeM, sunUp));
    tables.dome = dome;
    fillAltitudes(air, sunUp, levels, tables);
    for (std::size_t i = 0; i < size(glsl::kAltitudes); ++i) {
        dome->sunByAltitude.push_back(glm::dot(vec3(tables.byAltitude[i]), glsl::kLuminance));
    }
    const dvec3 sun = 4.0 * std::numbers::pi * std::max(sunUp, 0.0) * dvec3(tables.byAltitude[0]);
    fillAirBelow(air, sunUp, sun + levels.front().irradiance(), *dome);
    fillEyeTables(eyeAltitudeM, air, towardsSun, tables);
    return tables;
}

void fillEyeTables(double eyeAltitudeM, const Atmosphere& air, const dvec3& towardsSun,
                   SkyTables& tables) {
    const double altitudeM = std::max(eyeAltitudeM, 0.0);
    const glm::ivec2 count{glsl::kEyeSkyAzimuths, glsl::kEyeSkyElevations};
    tables.eyeSky.resize(size(count.x * count.y));
    fillSky(air, altitudeM, towardsSun.z, count, tables.eyeSky);
    fillAir(air, altitudeM, towardsSun.z, tables);
}

}  // namespace neph
