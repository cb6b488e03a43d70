// reference_march.cpp: a double-precision march of Eq. 5-18 over slices.
#include "tests/gpu/slicing/reference_march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "app/render/light/slice_plan.h"
#include "core/look/medium.h"
#include "core/look/sun.h"
#include "core/optics/noise.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::test {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4, glm::ivec2, glm::ivec3;
using Classes = std::array<double, kSpeciesCount>;

constexpr int kBrick = 4;  // as the engine: voxels of an occupancy brick
constexpr double kNothing =
    1e-4;  // as the engine: optical depth across the domain that nobody sees
constexpr double kGroundShare = 0.2, kHazeM = 90e3;

struct Medium {
    RegularGrid grid;
    MediumPlan plan;
    std::array<std::vector<double>, kSpeciesCount> extinctionPerM;  // a class
    std::vector<double> skylight;
    Array3f billow, wisp;

    std::size_t index(ivec3 p) const {
        p = glm::clamp(p, ivec3(0), grid.size - 1);
        return static_cast<std::size_t>(p.x) +
               static_cast<std::size_t>(grid.size.x) *
                   (static_cast<std::size_t>(p.y) +
                    static_cast<std::size_t>(grid.size.y) * static_cast<std::size_t>(p.z));
    }
    double total(ivec3 p) const {
        double sum = 0.0;
        for (std::size_t c = 0; c < plan.classes.size(); ++c) sum += extinctionPerM[c][index(p)];
        return sum;
    }
    template <typename Fetch>
    static double trilinear(dvec3 at, Fetch fetch) {
        const dvec3 base = glm::floor(at - 0.5);
        const dvec3 f = at - 0.5 - base;
        double sum = 0.0;
        for (int k = 0; k < 8; ++k) {
            const ivec3 corner{k & 1, k >> 1 & 1, k >> 2};
            const dvec3 w = glm::mix(1.0 - f, f, dvec3(corner));
            sum += w.x * w.y * w.z * fetch(ivec3(base) + corner);
        }
        return sum;
    }
};

double skyShare(double tau) {
    return 1.4209 / ((1.0 - 0.85) * tau + 1.4209);
}

void addSkylight(Medium& m) {
    m.skylight.resize(m.grid.cellCount());
    for (int y = 0; y < m.grid.size.y; ++y)
        for (int x = 0; x < m.grid.size.x; ++x)
            for (int z = 0; z < m.grid.size.z; ++z) {
                double above = 0.5 * m.total({x, y, z}), below = above;
                for (int k = z + 1; k < m.grid.size.z; ++k) above += m.total({x, y, k});
                for (int k = 0; k < z; ++k) below += m.total({x, y, k});
                const double dz = m.grid.spacingM.z;
                m.skylight[m.index({x, y, z})] =
                    (skyShare(above * dz) + kGroundShare * skyShare(below * dz)) /
                    (1.0 + kGroundShare);
            }
}

Medium makeMedium(const SpeciesVolume& volume, const Look& look) {
    Medium m;
    m.grid = volume.grid;
    m.plan = planMedium(look, volume.holdings(), volume.cellM());
    for (std::size_t c = 0; c < m.plan.classes.size(); ++c) {
        m.extinctionPerM[c].assign(m.grid.cellCount(), 0.0);
    }
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        if (m.plan.classOf[s] < 0) continue;
        const SpeciesLook& field = look.species[s];
        // Eq. 1-4, 9: η σ with σ = 2 π r² and η = ρ H / (4/3 π r³ ρ_p).
        const double r = static_cast<double>(field.effectiveRadiusM);
        const double sigma = 2.0 * 3.14159265358979 * r * r;
        const double particleKg =
            4.0 / 3.0 * 3.14159265358979 * r * r * r * static_cast<double>(field.densityKgPerM3);
        const double perKg = look.extinction == ExtinctionMode::equal
                                 ? static_cast<double>(look.equalExtinctionM2PerKg)
                                 : sigma / particleKg;
        const bool sized = !volume.extinctionPerM[s].empty();  // by the model, cell by cell
        const auto& held = sized ? volume.extinctionPerM[s] : volume.contentKgPerM3[s];
        auto& out = m.extinctionPerM[static_cast<std::size_t>(m.plan.classOf[s])];
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] += (sized ? 1.0 : perKg) * static_cast<double>(field.mixingScale) *
                      static_cast<double>(held.values[i]);
        }
    }
    addSkylight(m);
    if (look.noise) {
        m.billow = bakeNoise(NoiseCharacter::billow, 128);
        m.wisp = bakeNoise(NoiseCharacter::wisp, 128);
    }
    return m;
}

double noiseAt(const Array3f& texture, dvec3 tile) {
    const int n = texture.size.x;
    return Medium::trilinear(tile * static_cast<double>(n), [&](ivec3 p) {
        p = ((p % n) + n) % n;
        return static_cast<double>(texture.at(p.x, p.y, p.z));
    });
}

Classes sample(const Medium& m, dvec3 pM) {
    Classes out{};
    for (std::size_t c = 0; c < m.plan.classes.size(); ++c) {
        out[c] = Medium::trilinear(pM / m.grid.spacingM,
                                   [&](ivec3 p) { return m.extinctionPerM[c][m.index(p)]; });
        const MediumClass& k = m.plan.classes[c];
        if (k.noiseAmount > 0.0f) {
            const Array3f& texture = k.noiseCharacter == NoiseCharacter::billow ? m.billow : m.wisp;
            const double n = noiseAt(texture, pM / (4.0 * static_cast<double>(k.noiseScaleM)));
            out[c] *= std::max(0.0, 1.0 + static_cast<double>(k.noiseAmount) *
                                              (n / static_cast<double>(glsl::kDetailMean) - 1.0));
        }
    }
    return out;
}

/// The part of the volume that slices go through: bricks whose voxels, with one more around, hold
/// anything.
std::optional<BoxM> occupied(const Medium& m) {
    const double threshold = kNothing / glm::length(m.grid.extentM());
    const ivec3 bricks = (m.grid.size + kBrick - 1) / kBrick;
    ivec3 lower = bricks, upper{0};
    for (int z = 0; z < m.grid.size.z; ++z)
        for (int y = 0; y < m.grid.size.y; ++y)
            for (int x = 0; x < m.grid.size.x; ++x) {
                if (static_cast<float>(m.total({x, y, z})) <= static_cast<float>(threshold))
                    continue;
                const ivec3 p{x, y, z};
                lower = glm::min(lower, glm::max(p - 1, ivec3(0)) / kBrick);
                upper = glm::max(upper, glm::min(p + 1, m.grid.size - 1) / kBrick + 1);
            }
    if (upper == ivec3(0)) return {};
    const dvec3 brickM = m.grid.spacingM * static_cast<double>(kBrick);
    return BoxM{dvec3(lower) * brickM, glm::min(dvec3(upper) * brickM, m.grid.extentM())};
}

struct LightBuffer {
    ivec2 size{1};
    std::vector<double> values;

    double at(ivec2 p) const {
        p = glm::clamp(p, ivec2(0), size - 1);
        return values[static_cast<std::size_t>(p.y * size.x + p.x)];
    }
    double bilinear(dvec2 texel) const {
        const dvec2 base = glm::floor(texel - 0.5), f = texel - 0.5 - base;
        const ivec2 p(base);
        return (1 - f.y) * ((1 - f.x) * at(p) + f.x * at(p + ivec2(1, 0))) +
               f.y * ((1 - f.x) * at(p + ivec2(0, 1)) + f.x * at(p + ivec2(1, 1)));
    }
};

struct Scene {
    const Look& look;
    Medium medium;
    render::SlicePlan plan;
    BoxM box;
    dvec3 sun;
    std::vector<LightBuffer> light;  // light[i] meets slice i
};

bool inside(const BoxM& box, dvec3 p) {
    return glm::all(glm::greaterThanEqual(p, box.lowerM)) &&
           glm::all(glm::lessThanEqual(p, box.upperM));
}

double lightAfter(const Scene& s, const LightBuffer& before, dvec2 texel, double centre, dvec3 pM) {
    const Classes ext = sample(s.medium, pM);
    double beta = 0.0, scattering = 0.0;
    for (std::size_t c = 0; c < s.medium.plan.classes.size(); ++c) {
        beta += ext[c];
        scattering += ext[c] * static_cast<double>(s.medium.plan.classes[c].albedo);
    }
    const double tau = beta * s.plan.lightStepM, t = std::exp(-tau);
    if (s.look.transport == Transport::lowAlbedo) return centre * t;
    const ForwardShares shares = forwardShares(s.look);
    const double inner = static_cast<double>(shares.inner),
                 outer = static_cast<double>(shares.outer);
    const double ringM =
        s.plan.lightStepM *
        std::tan(3.0 / 8.0 * glm::radians(static_cast<double>(s.look.forwardAngleDeg)));
    const dvec2 step = ringM * dvec2(before.size) / s.plan.lightExtentM;
    const double ring =
        0.25 *
        (before.bilinear(texel + dvec2(step.x, 0)) + before.bilinear(texel - dvec2(step.x, 0)) +
         before.bilinear(texel + dvec2(0, step.y)) + before.bilinear(texel - dvec2(0, step.y)));
    const double spread = centre * inner + ring * (outer - inner);
    if (s.look.lightForm == LightForm::printed) return centre * t + (1.0 - t) * spread;
    const double albedo = beta > 0.0 ? scattering / beta : 1.0;
    const double gain = (std::exp(-(1.0 - albedo * outer) * tau) - t) / outer;
    return centre * t + gain * spread;
}

void marchLight(Scene& s) {
    LightBuffer light{s.plan.lightSizePx, {}};
    light.values.assign(static_cast<std::size_t>(light.size.x * light.size.y), 1.0);
    s.light.push_back(light);
    for (int i = 0; i < s.plan.count; ++i) {
        const LightBuffer before = s.light.back();
        const double planeM = s.plan.firstM + (i + 0.5) * s.plan.spacingM;
        for (int y = 0; y < light.size.y; ++y)
            for (int x = 0; x < light.size.x; ++x) {
                const dvec2 texel{x + 0.5, y + 0.5};
                const dvec2 across =
                    s.plan.lightLowerM + texel / dvec2(light.size) * s.plan.lightExtentM;
                const dvec3 base = s.plan.lightU * across.x + s.plan.lightV * across.y;
                const dvec3 p = base + s.sun * ((planeM - glm::dot(s.plan.normal, base)) /
                                                glm::dot(s.plan.normal, s.sun));
                const double centre = before.at({x, y});
                light.values[static_cast<std::size_t>(y * light.size.x + x)] =
                    inside(s.box, p) ? lightAfter(s, before, texel, centre, p) : centre;
            }
        s.light.push_back(light);
    }
}

double lightAt(const Scene& s, int slice, dvec3 p) {
    const LightBuffer& buffer = s.light[static_cast<std::size_t>(slice)];
    const dvec2 across{glm::dot(s.plan.lightU, p), glm::dot(s.plan.lightV, p)};
    return buffer.bilinear((across - s.plan.lightLowerM) / s.plan.lightExtentM *
                           dvec2(buffer.size));
}

dvec3 ambientOf(const Look& look) {
    return 0.5 * static_cast<double>(look.skyIntensity * look.skylight) *
           dvec3(look.skyZenith + look.skyHorizon);
}

dvec3 background(const Scene& s, dvec3 eye, double eyeHeightM, dvec3 dir) {
    const Look& look = s.look;
    const dvec3 horizon = dvec3(look.skyHorizon) * static_cast<double>(look.skyIntensity);
    const dvec3 zenith = dvec3(look.skyZenith) * static_cast<double>(look.skyIntensity);
    if (look.groundVisible && dir.z < 0.0 && eyeHeightM > 0.0) {
        const double distanceM = -eyeHeightM / dir.z;
        const dvec3 p = eye + distanceM * dir;
        const dvec2 across{glm::dot(s.plan.lightU, p), glm::dot(s.plan.lightV, p)};
        const dvec2 uv = (across - s.plan.lightLowerM) / s.plan.lightExtentM;
        const bool shaded = s.plan.count > 0 && uv.x >= 0 && uv.y >= 0 && uv.x <= 1 && uv.y <= 1;
        const double sun = shaded ? lightAt(s, s.plan.count, p) : 1.0;
        const dvec3 lit = dvec3(look.sunColour) * static_cast<double>(look.sunIntensity) *
                              std::max(s.sun.z, 0.0) * sun +
                          ambientOf(look);
        return glm::mix(horizon, dvec3(look.groundColour) * lit, std::exp(-distanceM / kHazeM));
    }
    return glm::mix(horizon, zenith, std::pow(std::clamp(dir.z, 0.0, 1.0), 0.55));
}

dvec4 marchEye(const Scene& s, const std::vector<PhaseTable>& phases, dvec3 eye, double eyeHeightM,
               dvec3 dir) {
    const double slope = glm::dot(s.plan.normal, dir);
    const double segmentM = s.plan.spacingM / std::abs(slope);
    const dvec3 ambient = ambientOf(s.look);
    dvec3 radiance{0.0};
    double through = 1.0;
    for (int k = 0; k < s.plan.count; ++k) {
        const int slice = slope > 0.0 ? k : s.plan.count - 1 - k;
        const double planeM = s.plan.firstM + (slice + 0.5) * s.plan.spacingM;
        const double t = (planeM - glm::dot(s.plan.normal, eye)) / slope;
        const dvec3 p = eye + t * dir;
        const bool buried =
            s.look.groundVisible && eyeHeightM > 0.0 && eyeHeightM + t * dir.z < 0.0;
        if (t < 0.0 || buried || !inside(s.box, p)) continue;
        const Classes ext = sample(s.medium, p);
        const double light = lightAt(s, slice, p);
        const double sky = Medium::trilinear(p / s.medium.grid.spacingM, [&](ivec3 q) {
            return s.medium.skylight[s.medium.index(q)];
        });
        double beta = 0.0;
        dvec3 source{0.0};
        for (std::size_t c = 0; c < s.medium.plan.classes.size(); ++c) {
            const MediumClass& k2 = s.medium.plan.classes[c];
            const dvec3 phase(lookUp(phases[c], static_cast<float>(glm::dot(s.sun, dir))));
            const dvec3 sunlit =
                phase * dvec3(s.look.sunColour) * static_cast<double>(s.look.sunIntensity) * light;
            beta += ext[c];
            source += ext[c] * static_cast<double>(k2.albedo) * dvec3(k2.colour) *
                      (sunlit + sky * ambient);
        }
        if (beta <= 0.0) continue;
        const double segment = std::exp(-beta * segmentM);
        radiance += through * (1.0 - segment) * source / beta;
        through *= segment;
    }
    return {radiance, through};
}

}  // namespace

ImageF referenceMarch(const SpeciesVolume& volume, const render::FrameInputs& inputs) {
    Scene s{inputs.look, makeMedium(volume, inputs.look), {}, {}, sunDirWorld(inputs.look), {}};
    const auto box = occupied(s.medium);
    s.box = box.value_or(BoxM{dvec3(0.0), volume.grid.extentM()});
    const double texelM =
        std::cbrt(volume.grid.spacingM.x * volume.grid.spacingM.y * volume.grid.spacingM.z);
    s.plan = render::planSlices(inputs.camera, s.sun, s.box, inputs.planes, texelM);
    if (!box) s.plan.count = 0;
    marchLight(s);
    const auto phases = displayPhases(inputs.look, s.medium.plan);
    ImageF image;
    image.size = inputs.sizePx;
    const dvec3 eye = inputs.camera.eyeWorld - volume.grid.originM;
    const double eyeHeightM = inputs.camera.eyeWorld.z;
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x) {
            const dvec2 ndc{2.0 * (x + 0.5) / image.size.x - 1.0,
                            1.0 - 2.0 * (y + 0.5) / image.size.y};
            const dvec3 dir = inputs.camera.rayDir(ndc);
            const dvec4 eyeBuffer = marchEye(s, phases, eye, eyeHeightM, dir);
            const dvec3 colour =
                dvec3(eyeBuffer) + eyeBuffer.w * background(s, eye, eyeHeightM, dir);
            image.pixels.emplace_back(glm::vec4(colour, 1.0 - eyeBuffer.w));
        }
    return image;
}

}  // namespace neph::test
