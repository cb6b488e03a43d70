// phase_functions.cpp: the rows. Closed forms come from the shader library; water droplets are
// tabulated. docs/physics.md §2
#include "core/optics/phase_functions.h"

#include <algorithm>

#include "core/optics/droplets.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

using S = const PhaseSpec&;
using Spec = PhaseSpec;
using glm::vec3;

/// Kept in memory for good.
const DropletOptics& droplets(S s) {
    return *waterDroplets(s.radiusM, s.wavelengthM);
}

constexpr auto kRows = std::to_array<PhaseFunction>({
    {.id = "isotropic",
     .label = "Isotropic",
     .help = "The same in all directions: 1 / (4 pi).",
     .parameters = {},
     .value = [](S, float) { return vec3(glsl::isotropicValue()); },
     .cumulative = [](S, float theta) { return glsl::isotropicCumulative(theta); },
     .sample = [](S, float u) { return glsl::isotropicSample(u); },
     .asymmetry = [](S) { return 0.0f; }},
    {.id = "rayleigh",
     .label = "Rayleigh",
     .help = "Of particles far smaller than the wavelength. [Rayleigh71]",
     .parameters = {},
     .value = [](S, float mu) { return vec3(glsl::rayleighValue(mu)); },
     .cumulative = [](S, float theta) { return glsl::rayleighCumulative(theta); },
     .sample = [](S, float u) { return glsl::rayleighSample(u); },
     .asymmetry = [](S) { return 0.0f; }},
    {.id = "henyey_greenstein",
     .label = "Henyey-Greenstein",
     .help = "One lobe, by its asymmetry g. [HG41]",
     .parameters = {{{&Spec::g, 0.85f}}},
     .value = [](S s, float mu) { return vec3(glsl::hgValue(mu, s.g)); },
     .cumulative = [](S s, float theta) { return glsl::hgCumulative(theta, s.g); },
     .sample = [](S s, float u) { return glsl::hgSample(u, s.g); },
     .asymmetry = [](S s) { return s.g; }},
    {.id = "double_henyey_greenstein",
     .label = "Double HG",
     .help = "A forward and a backward lobe. [Irvine65]",
     .parameters = {{{&Spec::g, 0.85f}, {&Spec::g2, -0.65f}, {&Spec::weight, 0.99f}}},
     .value = [](S s, float mu) { return vec3(glsl::doubleHgValue(mu, s.g, s.g2, s.weight)); },
     .cumulative = [](S s,
                      float theta) { return glsl::doubleHgCumulative(theta, s.g, s.g2, s.weight); },
     .sample = [](S s, float u) { return glsl::doubleHgSample(u, s.g, s.g2, s.weight); },
     .asymmetry = [](S s) { return glsl::doubleHgAsymmetry(s.g, s.g2, s.weight); }},
    {.id = "draine",
     .label = "Draine",
     .help = "Between Henyey-Greenstein and Rayleigh, by alpha. [Draine03]",
     .parameters = {{{&Spec::g, 0.85f}, {&Spec::alpha, 5.0f}}},
     .value = [](S s, float mu) { return vec3(glsl::draineValue(mu, s.g, s.alpha)); },
     .cumulative = [](S s, float theta) { return glsl::draineCumulative(theta, s.g, s.alpha); },
     .sample = [](S s, float u) { return glsl::draineSample(u, s.g, s.alpha); },
     .asymmetry = [](S s) { return glsl::draineAsymmetry(s.g, s.alpha); }},
    {.id = "cornette_shanks",
     .label = "Cornette-Shanks",
     .help = "Henyey-Greenstein with Rayleigh's shape at g = 0. [CS92]",
     .parameters = {{{&Spec::g, 0.85f}}},
     .value = [](S s, float mu) { return vec3(glsl::cornetteShanksValue(mu, s.g)); },
     .cumulative = [](S s, float theta) { return glsl::cornetteShanksCumulative(theta, s.g); },
     .sample = [](S s, float u) { return glsl::cornetteShanksSample(u, s.g); },
     .asymmetry = [](S s) { return glsl::cornetteShanksAsymmetry(s.g); }},
    {.id = "water_droplets",
     .label = "Water droplets (Mie)",
     .help = "Mie theory of a population of droplets: corona, fog bow and glory at three "
             "wavelengths. [HT74]",
     .scatterer = Scatterer::droplets,
     .parameters = {{{&Spec::radiusM, 10e-6f}}},
     .value = [](S s, float mu) { return lookUp(droplets(s).phase, mu); },
     .cumulative = [](S s, float theta) { return dropletCumulative(droplets(s), theta); },
     .sample = [](S s, float u) { return dropletSample(droplets(s), u); },
     .asymmetry = [](S s) { return droplets(s).asymmetry.y; },
     .table = [](S s) { return droplets(s).phase; }},
    {.id = "rough_aggregate",
     .label = "Rough aggregate (ice)",
     .help = "Crystals frozen together, with rough faces. [Key02]",
     .scatterer = Scatterer::crystals,
     .parameters = {{{&Spec::radiusM, 30e-6f}}},
     .value = [](S s, float mu) { return vec3(glsl::roughAggregateValue(mu, s.radiusM)); },
     .cumulative = [](S s,
                      float theta) { return glsl::roughAggregateCumulative(theta, s.radiusM); },
     .sample = [](S s, float u) { return glsl::roughAggregateSample(u, s.radiusM); },
     .asymmetry = [](S s) { return glsl::roughAggregateAsymmetry(s.radiusM); }},
    {.id = "solid_column",
     .label = "Solid column (ice)",
     .help = "Hexagonal ice columns, fitted without their halos. [Key02]",
     .scatterer = Scatterer::crystals,
     .parameters = {{{&Spec::radiusM, 30e-6f}}},
     .value = [](S s, float mu) { return vec3(glsl::solidColumnValue(mu, s.radiusM)); },
     .cumulative = [](S s, float theta) { return glsl::solidColumnCumulative(theta, s.radiusM); },
     .sample = [](S s, float u) { return glsl::solidColumnSample(u, s.radiusM); },
     .asymmetry = [](S s) { return glsl::solidColumnAsymmetry(s.radiusM); }},
});

}  // namespace

std::span<const PhaseParameter> PhaseFunction::reads() const {
    const auto none = std::ranges::find(parameters, nullptr, &PhaseParameter::member);
    return {parameters.begin(), none};
}

std::span<const PhaseFunction> phaseFunctions() {
    return kRows;
}

const PhaseFunction& phaseFunction(PhaseKind kind) {
    return kRows.at(static_cast<std::size_t>(kind));
}

PhaseSpec typicalSpec(PhaseKind kind) {
    PhaseSpec spec{.kind = kind};
    for (const auto& [member, typical] : phaseFunction(kind).reads()) spec.*member = typical;
    return spec;
}

std::vector<PhaseSpec> typicalSpecs() {
    std::vector<PhaseSpec> specs;
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        specs.push_back(typicalSpec(static_cast<PhaseKind>(i)));
    }
    return specs;
}

}  // namespace neph
