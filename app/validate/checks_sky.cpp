// checks_sky.cpp: the clear sky, by the tables that images take it from, against published
// formulas and exact solutions. docs/validation.md says what they are and what they are worth.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/validate/checks.h"
#include "app/validate/sky_references.h"
#include "core/sky/air_columns.h"
#include "core/sky/sky_tables.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::validate {
namespace {

constexpr std::size_t k560Nm = 4, k680Nm = 7;  // of kSpectrumNm

double upOf(double elevationDeg) {
    return std::sin(glm::radians(elevationDeg));
}

/// A row that passes within `tolerance` of the expected value, absolute.
Row row(const std::string& quantity, double measured, double expected, double tolerance) {
    Row made;
    made.quantity = quantity;
    made.measured = measured;
    made.expected = expected;
    made.tolerance = tolerance;
    return made;
}

std::vector<Row> named(const std::string& trial, const std::string& source, std::vector<Row> rows) {
    for (Row& each : rows) {
        each.trial = trial;
        each.source = source;
    }
    return rows;
}

/// The tables of an eye at sea level, in kilolux and kcd/m².
class SeenSky {
  public:
    SeenSky(const Atmosphere& air, double sunDeg)
        : sun_(std::cos(glm::radians(sunDeg)), 0.0, upOf(sunDeg)),
          tables_(makeSkyTables(air, sun_, 0.0)) {}

    static double outsideKlx() { return 1e-3 * 683.0 * solarIrradianceWPerM2(); }
    double sunShare() const { return luminance(tables_.byAltitude.front()); }
    double diffuseKlx() const {
        return outsideKlx() * glm::dot(tables_.skyOnGround, glm::dvec3(glsl::kLuminance));
    }
    /// As shaders interpolate the table.
    double kcdPerM2(const glm::dvec3& towards) const {
        const glm::ivec2 count{glsl::kEyeSkyAzimuths, glsl::kEyeSkyElevations};
        const glm::vec2 share{
            glsl::azimuthShare(glm::vec3(towards), glm::vec3(sun_)),
            glsl::skyShare(static_cast<float>(towards.z), glsl::horizonSine(0.0f))};
        const glm::dvec2 place(share * glm::vec2(count - 1));
        const glm::ivec2 cell = glm::min(glm::ivec2(place), count - 2);
        const glm::dvec2 f = place - glm::dvec2(cell);
        const auto at = [&](int i, int j) {
            return luminance(
                tables_.eyeSky[static_cast<std::size_t>((cell.y + j) * count.x + cell.x + i)]);
        };
        const double between =
            std::lerp(std::lerp(at(0, 0), at(1, 0), f.x), std::lerp(at(0, 1), at(1, 1), f.x), f.y);
        return outsideKlx() * between / (4.0 * std::numbers::pi);
    }
    const glm::dvec3& sun() const { return sun_; }

  private:
    static double luminance(const glm::vec4& rgb) {
        return static_cast<double>(glm::dot(glm::vec3(rgb), glsl::kLuminance));
    }
    glm::dvec3 sun_;
    SkyTables tables_;
};

/// Air masses, and light of the sun that pure air leaves.
std::vector<Row> sunRows() {
    const Atmosphere pure({.visibilityM = 1e9, .ozoneDobson = 0.0});
    const auto depth = [&](double elevationDeg) {
        return -std::log(static_cast<double>(pure.sunlight(0.0, upOf(elevationDeg)).at[k680Nm]));
    };
    std::vector<Row> rows;
    for (const DirectSun& sun : kDirectSun) {
        const auto name = [&](std::string_view what) {
            return fmt::format("{}, sun at {:g}°", what, sun.elevationDeg);
        };
        const double share = SeenSky(pure, sun.elevationDeg).sunShare();
        rows.push_back(row(name("air mass"), depth(sun.elevationDeg) / depth(90.0), sun.airMass,
                           0.01 * sun.airMass));
        rows.push_back(
            row(name("illuminance, share"), share, sun.luminousShare, 0.02 * sun.luminousShare));
        const double coefficient = luminousExtinction(sun.airMass);
        rows.push_back(row(name("extinction coefficient"), -std::log(share) / sun.airMass,
                           coefficient, 0.05 * coefficient));
    }
    return named("Clear sky: direct sunlight through pure air",
                 "[KastenYoung89]; spectrum in steps of 1 nm; [DarulaKittler02] eq. 17", rows);
}

/// Directions that sky scanners look in: centres of the patches of [Tregenza87].
std::vector<glm::dvec3> patches() {
    constexpr std::array<int, 8> kPerRow{30, 30, 24, 24, 18, 12, 6, 1};
    std::vector<glm::dvec3> all;
    for (std::size_t i = 0; i < kPerRow.size(); ++i) {
        const double up = upOf(6.0 + 12.0 * static_cast<double>(i));
        const double across = std::sqrt(1.0 - up * up);
        for (int k = 0; k < kPerRow[i]; ++k) {
            const double azimuth = 2.0 * std::numbers::pi * k / kPerRow[i];
            all.emplace_back(across * std::cos(azimuth), across * std::sin(azimuth), up);
        }
    }
    return all;
}

/// Root mean square of the logarithms of the ratio of two skies, each relative to its zenith, over
/// the patches that are farther from the sun than scanners look.
template <typename A, typename B>
double apart(const A& a, const B& b, const glm::dvec3& sun) {
    constexpr double kSkippedDeg = 12.0;  // the width of a patch
    const glm::dvec3 zenith(0.0, 0.0, 1.0);
    double sum = 0.0, count = 0.0;
    for (const glm::dvec3& dir : patches()) {
        if (glm::dot(dir, sun) > std::cos(glm::radians(kSkippedDeg))) continue;
        const double ratio = std::log(a(dir) / a(zenith) * b(zenith) / b(dir));
        sum += ratio * ratio;
        count += 1.0;
    }
    return std::sqrt(sum / count);
}

/// Air whose luminous turbidity is typical of a standard sky.
struct TypicalAir {
    std::size_t type;  ///< index in kStandardSkies, with neighbours
    double visibilityM, turbidity;
};
constexpr std::array kTypicalAir{TypicalAir{1, 33e3, 2.5}, TypicalAir{2, 13.7e3, 4.5}};

/// One place of the sun. A tolerance is the distance of the standard sky to the farther of the
/// types beside it: beyond that, another type would describe ours better. That of the zenith has
/// half of what the two formulas for it differ by in addition.
void addStandardSky(const TypicalAir& typical, double sunDeg, std::vector<Row>& rows) {
    const Atmosphere air({.visibilityM = typical.visibilityM, .groundAlbedo = 0.2});
    const SeenSky sky(air, sunDeg);
    const auto name = [&](std::string_view what) {
        return fmt::format("{}, sun at {:g}°", what, sunDeg);
    };
    const double mass = relativeAirMass(sunDeg);
    const double turbidity = -std::log(sky.sunShare()) / mass / luminousExtinction(mass);
    rows.push_back(row(name("turbidity"), turbidity, typical.turbidity, 0.1 * typical.turbidity));

    const auto seen = [&](const glm::dvec3& dir) { return sky.kcdPerM2(dir); };
    const auto standard = [&](int step) {
        const auto at = static_cast<std::size_t>(static_cast<int>(typical.type) + step);
        return [&type = kStandardSkies[at], sun = sky.sun()](const glm::dvec3& dir) {
            return relativeLuminance(type, dir, sun);
        };
    };
    const auto toNeighbours = [&](const auto& distance) {
        return std::max(distance(-1), distance(1));
    };
    rows.push_back(
        row(name("distribution, ln ratio"), apart(seen, standard(0), sky.sun()), 0.0,
            toNeighbours([&](int step) { return apart(standard(0), standard(step), sky.sun()); })));

    const auto zeniths = [&](int step) {
        const auto at = static_cast<std::size_t>(static_cast<int>(typical.type) + step);
        return zenithOf(kStandardSkies[at], sunDeg, sky.diffuseKlx(), turbidity);
    };
    const auto zenith = [&](int step) { return zeniths(step).mean(); };
    const double formulasApart = 0.5 * std::abs(zeniths(0).fromDiffuse - zeniths(0).fromTurbidity);
    rows.push_back(row(name("zenith, kcd/m²"), sky.kcdPerM2({0.0, 0.0, 1.0}), zenith(0),
                       formulasApart + toNeighbours([&](int step) {
                           return std::abs(zenith(step) - zenith(0));
                       })));
    for (const double azimuthDeg : {90.0, 180.0}) {
        const double azimuth = glm::radians(azimuthDeg), across = std::cos(glm::radians(6.0));
        const glm::dvec3 low{across * std::cos(azimuth), across * std::sin(azimuth), upOf(6.0)};
        const auto expected = [&](int step) { return zenith(step) * standard(step)(low); };
        rows.push_back(row(name(fmt::format("6° high, {:g}° aside, kcd/m²", azimuthDeg)),
                           sky.kcdPerM2(low), expected(0), toNeighbours([&](int step) {
                               return std::abs(expected(step) - expected(0));
                           })));
    }
}

std::vector<Row> standardRows(const TypicalAir& typical) {
    std::vector<Row> rows;
    for (const double sunDeg : {10.0, 20.0, 40.0, 60.0}) addStandardSky(typical, sunDeg, rows);
    const StandardSky& type = kStandardSkies[typical.type];
    return named(fmt::format("Clear sky: CIE type {}, visibility {:g} km", type.number,
                             1e-3 * typical.visibilityM),
                 "ISO 15469 [CIES011]; [DarulaKittler02] eq. 12 and 13", rows);
}

/// At 560 nm, against light that is scattered exactly as often as it is.
std::vector<Row> exactRows(const ExactSky& exact) {
    constexpr double kTolerance = 0.10;  // relative; of scatter that is isotropic after the first
    const Atmosphere air({.visibilityM = exact.visibilityM, .groundAlbedo = 0.2});
    std::vector<Row> rows;
    for (const ExactRadiance& at : exact.radiances) {
        const SkyRay ray{0.0, upOf(at.elevationDeg), glm::radians(at.azimuthDeg), upOf(at.sunDeg)};
        rows.push_back(row(fmt::format("sun at {:g}°, {:g}° high, {:g}° aside", at.sunDeg,
                                       at.elevationDeg, at.azimuthDeg),
                           static_cast<double>(air.along(ray).radiance.at[k560Nm]), at.radiance,
                           kTolerance * at.radiance));
    }
    return named(
        fmt::format("Clear sky: radiance at 560 nm, visibility {:g} km", 1e-3 * exact.visibilityM),
        "adding-doubling, 22 level layers of the same air", rows);
}

std::vector<Row> horizonRows() {
    std::vector<Row> rows;
    for (const double altitudeM : {10.0, 100.0, 1e3, 12e3, 400e3}) {
        const double dip = std::acos(kEarthRadiusM / (kEarthRadiusM + altitudeM));
        const auto seen = static_cast<double>(glsl::horizonSine(static_cast<float>(altitudeM)));
        rows.push_back(row(fmt::format("dip from {:g} m, °", altitudeM),
                           -glm::degrees(std::asin(seen)), glm::degrees(dip),
                           1e-3 * glm::degrees(dip)));
    }
    for (const double altitudeM : {10.0, 100.0}) {
        const double dip = kAlmanacDipDeg * std::sqrt(altitudeM);
        rows.push_back(row(fmt::format("dip of sunlight from {:g} m, °", altitudeM),
                           -glm::degrees(std::asin(apparentHorizonUp(altitudeM))), dip,
                           0.01 * dip));
    }
    return named("Clear sky: the horizon", "acos R / (R + h); Nautical Almanac, 1.76' √h", rows);
}

}  // namespace

std::vector<std::vector<Row>> skyRows() {
    std::vector<std::vector<Row>> all;
    all.push_back(sunRows());
    for (const TypicalAir& typical : kTypicalAir) all.push_back(standardRows(typical));
    for (const ExactSky& exact : exactSkies()) all.push_back(exactRows(exact));
    all.push_back(horizonRows());
    return all;
}

}  // namespace neph::validate
