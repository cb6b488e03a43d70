// droplets.cpp: Mie scattering averaged over a size distribution.
//
// The angular sums dominate: for every size, order and angle four multiply-adds in single
// precision, eight angles at a time. The angles are dense near 0° and 180°, for the corona and the
// glory, and the result is interpolated to the angles of the table.
#include "core/optics/droplets.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <span>
#include <thread>

#include "core/optics/mie.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEffectiveVariance = 0.1;
/// Wavelength in m and refractive index of water. [HQ73]
struct Colour {
    double wavelengthM, index;
};
constexpr std::array<Colour, 3> kColours{{{650e-9, 1.331}, {550e-9, 1.333}, {450e-9, 1.337}}};
/// Refractive index at 400, 450, ... 1000 nm. [HQ73]
constexpr std::array kIndices{1.339, 1.337, 1.335, 1.333, 1.332, 1.331, 1.331,
                              1.330, 1.329, 1.329, 1.328, 1.327, 1.327};
constexpr double kFirstIndexM = 400e-9, kIndexStepM = 50e-9;

Colour colourOf(double wavelengthM) {
    const double last = static_cast<double>(kIndices.size() - 1);
    const double at = std::clamp((wavelengthM - kFirstIndexM) / kIndexStepM, 0.0, last);
    const auto i = std::min(static_cast<std::size_t>(at), kIndices.size() - 2);
    return {wavelengthM, std::lerp(kIndices[i], kIndices[i + 1], at - static_cast<double>(i))};
}

/// Range of sizes in effective radii; those outside add less than 1e-4 to the forward peak. They
/// are spaced evenly in the logarithm, so that the interference fringes of no angle stay in phase
/// with them, by kSizeStep in x at the effective radius. Compared with ten times as many sizes, the
/// table is within 1 % rms and, at single angles beyond 100°, within 10 % (docs/physics.md §6).
constexpr double kSmallestSize = 0.15, kLargestSize = 3.0;
constexpr double kSizeStep = 0.4;
constexpr int kMinSizes = 600, kMaxSizes = 1000;

constexpr int kHalfAngles = 192;  ///< in the forward hemisphere; as many in the backward one
constexpr int kAngles = 2 * kHalfAngles;
constexpr int kLanes = 8;  ///< angles computed together
constexpr int kTiles = kAngles / kLanes;
/// Number of parts that the sizes of one colour are divided into for summation; fixed, so that
/// results do not depend on the number of cores.
constexpr int kSlices = 4;

/// Angle of the coarse grid: quadratic from both ends; 90° occurs twice.
double gridTheta(int i) {
    const bool front = i < kHalfAngles;
    const double s = (front ? i : kAngles - 1 - i) / (kHalfAngles - 1.0);
    return front ? 0.5 * kPi * s * s : kPi - 0.5 * kPi * s * s;
}

using Lanes = std::array<float, kLanes>;

/// (2n+1)/(n(n+1)) (π_n ± τ_n) of [BH83] §4.3.1 at every angle of the grid, by tile, then order.
struct AngularFunctions {
    int terms;
    std::vector<Lanes> plus, minus;

    explicit AngularFunctions(int terms_);
    std::size_t row(int tile, int order) const {
        return static_cast<std::size_t>(tile) * static_cast<std::size_t>(terms) +
               static_cast<std::size_t>(order - 1);
    }
};

AngularFunctions::AngularFunctions(int terms_) : terms(terms_) {
    plus.resize(static_cast<std::size_t>(kTiles) * static_cast<std::size_t>(terms));
    minus.resize(plus.size());
    for (int i = 0; i < kAngles; ++i) {
        const double mu = std::cos(gridTheta(i));
        double before = 0.0, pi = 1.0;
        for (int n = 1; n <= terms; ++n) {
            const double tau = n * mu * pi - (n + 1) * before;
            const double scale = (2.0 * n + 1.0) / (n * (n + 1.0));
            const auto lane = static_cast<std::size_t>(i % kLanes);
            plus[row(i / kLanes, n)][lane] = static_cast<float>(scale * (pi + tau));
            minus[row(i / kLanes, n)][lane] = static_cast<float>(scale * (pi - tau));
            const double next = ((2 * n + 1) * mu * pi - (n + 1) * before) / n;
            before = pi, pi = next;
        }
    }
}

/// Sums over one part of the sizes of one colour.
struct Sums {
    std::array<double, kAngles> intensity{};  ///< (|S1|² + |S2|²) / 2
    double extinction = 0.0, scattering = 0.0, asymmetry = 0.0, area = 0.0;
};

/// The coefficients in the form that the angular sums need: a + b and a - b, single precision.
struct SumCoefficients {
    std::vector<std::array<float, 4>> rows;
    explicit SumCoefficients(const MieCoefficients& c) : rows(c.a.size()) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::complex<double> plus = c.a[i] + c.b[i], minus = c.a[i] - c.b[i];
            rows[i] = {static_cast<float>(plus.real()), static_cast<float>(plus.imag()),
                       static_cast<float>(minus.real()), static_cast<float>(minus.imag())};
        }
    }
};

/// (|S1|² + |S2|²) / 2 = (|S1 + S2|² + |S1 - S2|²) / 4 at the angles of a tile.
[[gnu::always_inline]] inline Lanes sumTile(const SumCoefficients& c, const Lanes* plus,
                                            const Lanes* minus) {
    Lanes plusRe{}, plusIm{}, minusRe{}, minusIm{};
    for (std::size_t n = 0; n < c.rows.size(); ++n) {
        const auto [pr, pi, mr, mi] = c.rows[n];
        const Lanes& p = plus[n];
        const Lanes& m = minus[n];
        for (std::size_t k = 0; k < kLanes; ++k) {
            plusRe[k] += pr * p[k];
            plusIm[k] += pi * p[k];
            minusRe[k] += mr * m[k];
            minusIm[k] += mi * m[k];
        }
    }
    Lanes intensity;
    for (std::size_t k = 0; k < kLanes; ++k) {
        intensity[k] = 0.25f * (plusRe[k] * plusRe[k] + plusIm[k] * plusIm[k] +
                                minusRe[k] * minusRe[k] + minusIm[k] * minusIm[k]);
    }
    return intensity;
}

Lanes tileIntensity(const SumCoefficients& c, const Lanes* plus, const Lanes* minus) {
    return sumTile(c, plus, minus);
}

#if defined(__x86_64__)
/// The same for processors with eight lanes and fused multiply-add: three times as fast.
[[gnu::target("avx2,fma")]] Lanes tileIntensityWide(const SumCoefficients& c, const Lanes* plus,
                                                    const Lanes* minus) {
    return sumTile(c, plus, minus);
}
#endif

using TileIntensity = Lanes (*)(const SumCoefficients&, const Lanes*, const Lanes*);

TileIntensity fastestTileIntensity() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return tileIntensityWide;
#endif
    return tileIntensity;
}

/// Adds one size with its weight in the population.
void addSize(Sums& sums, double x, double index, double weight, const AngularFunctions& angular) {
    const MieCoefficients coefficients = mieCoefficients(x, index);
    const MieEfficiencies q = mieEfficiencies(x, coefficients);
    const double area = weight * x * x;
    sums.area += area;
    sums.extinction += area * q.extinction;
    sums.scattering += area * q.scattering;
    sums.asymmetry += area * q.scattering * q.asymmetry;
    const SumCoefficients c(coefficients);
    static const TileIntensity intensityOf = fastestTileIntensity();
    for (int tile = 0; tile < kTiles; ++tile) {
        const std::size_t row = angular.row(tile, 1);
        const Lanes intensity = intensityOf(c, &angular.plus[row], &angular.minus[row]);
        double* out = &sums.intensity[static_cast<std::size_t>(tile) * kLanes];
        for (std::size_t k = 0; k < kLanes; ++k)
            out[k] += weight * static_cast<double>(intensity[k]);
    }
}

/// Sums every kSlices-th size of a colour.
Sums sumSlice(double radiusM, const Colour& colour, int slice, const AngularFunctions& angular) {
    const double xEffective = 2.0 * kPi * radiusM / colour.wavelengthM;
    const double span = std::log(kLargestSize / kSmallestSize);
    const int sizes =
        std::clamp(static_cast<int>(span * xEffective / kSizeStep), kMinSizes, kMaxSizes);
    Sums sums;
    for (int i = slice; i < sizes; i += kSlices) {
        const double u = kSmallestSize * std::exp(span * (i + 0.5) / sizes);
        // n(r) dr with dr ∝ r
        const double weight = std::pow(u, (1.0 - 2.0 * kEffectiveVariance) / kEffectiveVariance) *
                              std::exp(-u / kEffectiveVariance);
        addSize(sums, u * xEffective, colour.index, weight, angular);
    }
    return sums;
}

/// Computes all slices of all colours, on all cores; entry colour * kSlices + slice.
std::vector<Sums> sumAll(double radiusM, std::span<const Colour> colours) {
    const double xLargest = 2.0 * kPi * radiusM * kLargestSize / colours.back().wavelengthM;
    const AngularFunctions angular(static_cast<int>(xLargest + 4.0 * std::cbrt(xLargest) + 3.0));
    std::vector<Sums> parts(colours.size() * kSlices);
    std::atomic<std::size_t> next{0};
    auto work = [&] {
        for (std::size_t i = next++; i < parts.size(); i = next++) {
            parts[i] =
                sumSlice(radiusM, colours[i / kSlices], static_cast<int>(i % kSlices), angular);
        }
    };
    std::vector<std::jthread> helpers;
    const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    for (unsigned i = 1; i < cores; ++i) helpers.emplace_back(work);
    work();
    helpers.clear();  // joins
    return parts;
}

/// Logarithm of a positive function of the grid at `theta`, by cubic interpolation in the square
/// root of the angle from the nearer end, in which the function is even.
double interpolateLog(const std::array<double, kAngles>& logs, double theta) {
    const bool front = theta <= 0.5 * kPi;
    const double s = std::sqrt((front ? theta : kPi - theta) / (0.5 * kPi)) * (kHalfAngles - 1);
    const int i = std::min(static_cast<int>(s), kHalfAngles - 2);
    const double f = s - i;
    auto at = [&](int k) {  // beyond 90° the other half continues; its own 90° is skipped
        k = std::abs(k);
        if (k >= kHalfAngles) ++k;
        return logs[static_cast<std::size_t>(front ? k : kAngles - 1 - k)];
    };
    const double a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    return b +
           0.5 * f * (c - a + f * (2.0 * a - 5.0 * b + 4.0 * c - d + f * (3.0 * (b - c) + d - a)));
}

/// Cumulative of the middle colour of a table, by the trapezoidal rule in the cosine; also rescales
/// each colour so that the table integrates to exactly 1 when interpolated linearly in the cosine.
std::vector<float> normalise(PhaseTable& table) {
    std::vector<double> cumulative(table.size(), 0.0);
    glm::dvec3 total(0.0);
    for (std::size_t i = 1; i < table.size(); ++i) {
        auto mu = [](std::size_t k) {
            const double s = static_cast<double>(k) / (kPhaseTableSize - 1);
            return std::cos(kPi * s * s);
        };
        total += kPi * (mu(i - 1) - mu(i)) * (glm::dvec3(table[i - 1]) + glm::dvec3(table[i]));
        cumulative[i] = total.y;
    }
    for (glm::vec3& value : table) value = glm::vec3(glm::dvec3(value) / total);
    std::vector<float> result;
    result.reserve(table.size());
    for (double c : cumulative) result.push_back(static_cast<float>(c / total.y));
    return result;
}

}  // namespace

DropletOptics computeDroplets(float effectiveRadiusM, float wavelengthM) {
    const std::array one{colourOf(static_cast<double>(wavelengthM))};
    const auto colours =
        wavelengthM > 0.0f ? std::span<const Colour>(one) : std::span<const Colour>(kColours);
    DropletOptics optics;
    optics.effectiveRadiusM = std::clamp(effectiveRadiusM, kSmallestDropletM, kLargestDropletM);
    optics.phase.resize(kPhaseTableSize);
    const std::vector<Sums> parts = sumAll(static_cast<double>(optics.effectiveRadiusM), colours);
    for (int colour = 0; colour < 3; ++colour) {
        Sums sums;
        for (int slice = 0; slice < kSlices; ++slice) {
            const std::size_t of = std::min(static_cast<std::size_t>(colour), colours.size() - 1);
            const Sums& part = parts[of * kSlices + static_cast<std::size_t>(slice)];
            for (std::size_t i = 0; i < kAngles; ++i) sums.intensity[i] += part.intensity[i];
            sums.area += part.area;
            sums.extinction += part.extinction;
            sums.scattering += part.scattering;
            sums.asymmetry += part.asymmetry;
        }
        optics.extinctionEfficiency[colour] = static_cast<float>(sums.extinction / sums.area);
        optics.asymmetry[colour] = static_cast<float>(sums.asymmetry / sums.scattering);
        std::array<double, kAngles> logs;
        for (std::size_t i = 0; i < kAngles; ++i) {
            logs[i] = std::log(sums.intensity[i] / (kPi * sums.scattering));
        }
        for (int i = 0; i < kPhaseTableSize; ++i) {
            const auto theta = static_cast<double>(glsl::phaseTableTheta(i, kPhaseTableSize));
            optics.phase[static_cast<std::size_t>(i)][colour] =
                static_cast<float>(std::exp(interpolateLog(logs, std::min(theta, kPi))));
        }
    }
    optics.cumulative = normalise(optics.phase);
    return optics;
}

float dropletCumulative(const DropletOptics& droplets, float theta) {
    const float index = glsl::phaseTableIndex(std::cos(theta), kPhaseTableSize);
    const int i = std::min(static_cast<int>(index), kPhaseTableSize - 2);
    const float lower = std::cos(glsl::phaseTableTheta(i, kPhaseTableSize));
    const float upper = std::cos(glsl::phaseTableTheta(i + 1, kPhaseTableSize));
    const float share = lower == upper ? 0.0f : (lower - std::cos(theta)) / (lower - upper);
    const auto at = static_cast<std::size_t>(i);
    return std::lerp(droplets.cumulative[at], droplets.cumulative[at + 1],
                     std::clamp(share, 0.0f, 1.0f));
}

float dropletSample(const DropletOptics& droplets, float u) {
    const auto& cumulative = droplets.cumulative;
    const float share = 1.0f - u;
    const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, share);
    const auto i = static_cast<int>(above - cumulative.begin());
    const float low = *(above - 1), high = *above;
    const float f = high > low ? std::clamp((share - low) / (high - low), 0.0f, 1.0f) : 0.5f;
    return std::lerp(std::cos(glsl::phaseTableTheta(i - 1, kPhaseTableSize)),
                     std::cos(glsl::phaseTableTheta(i, kPhaseTableSize)), f);
}

}  // namespace neph
