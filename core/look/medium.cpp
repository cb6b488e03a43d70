// medium.cpp: grouping species into classes, and the phase functions as displayed.
#include "core/look/medium.h"

#include <algorithm>
#include <cmath>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

MediumClass classFor(const Look& look, const SpeciesLook& field, double cellM) {
    MediumClass made;
    made.albedo = field.albedo;
    made.colour = look.colour == ColourMode::fields ? field.colour : glm::vec3(1.0f);
    made.phase = look.phaseMode == PhaseMode::perField ? field.phase : look.uniformPhase;
    if (look.noise && field.noiseAmount > 0.0f) {
        made.noiseAmount = field.noiseAmount;
        made.noiseScaleM = noiseScaleM(field, cellM);
        made.noiseCharacter = field.noiseCharacter;
    }
    return made;
}

float extinctionPerHeld(const Look& look, const SpeciesLook& field, Holding holding, double cellM) {
    const float scale = mixingScaleAt(look, field, cellM);
    if (holding == Holding::extinction) return scale;
    const float k = look.extinction == ExtinctionMode::equal
                        ? look.equalExtinctionM2PerKg
                        : glsl::massExtinctionM2PerKg(field.effectiveRadiusM, field.densityKgPerM3);
    return k * scale;
}

/// The logarithmic display puts black this far below the smallest value, or light at right angles
/// would vanish; tuned by eye.
constexpr float kLogarithmicFoot = 10.0f;

/// Smallest and cut value over all classes: one common range, so that water and ice keep their
/// ratio.
struct DisplayRange {
    float lo;
    float cut;
};

DisplayRange rangeOf(const std::vector<PhaseTable>& tables, float cutCosTheta) {
    DisplayRange range{1e30f, 0.0f};
    for (const PhaseTable& table : tables) {
        for (const glm::vec3& value : table) {
            range.lo = std::min({range.lo, value.r, value.g, value.b});
        }
        range.cut = std::max(range.cut, lookUp(table, cutCosTheta).g);
    }
    return range;
}

float displayed(float value, PhaseDisplay display, DisplayRange range) {
    if (display == PhaseDisplay::physical) return value / glsl::kInverseFourPi;
    const float cut = std::min(value, range.cut);
    if (display == PhaseDisplay::linear) return cut / range.cut;
    if (range.cut <= range.lo) return 1.0f;  // isotropic: no range to spread over
    const float floor = range.lo / kLogarithmicFoot;
    return std::log(cut / floor) / std::log(range.cut / floor);
}

}  // namespace

glm::vec2 fitNoise(float scaleM, glm::dvec2 widthM) {
    const double tileM = static_cast<double>(glsl::kDetailFeaturesPerTile * scaleM);
    return widthM / (glm::max(glm::round(widthM / tileM), 1.0) * tileM);
}

float mixingScaleAt(const Look& look, const SpeciesLook& field, double cellM) {
    const auto scale = static_cast<double>(field.mixingScale);
    if (look.mixing == MixingRule::asGiven || scale >= 1.0) return field.mixingScale;
    return static_cast<float>(std::min(1.0, scale * std::max(1.0, kLookCellM / cellM)));
}

MediumPlan planMedium(const Look& look, const std::array<Holding, kSpeciesCount>& holdings,
                      double cellM) {
    MediumPlan plan;
    plan.classOf.fill(-1);
    for (std::size_t s = 0; s < holdings.size(); ++s) {
        const SpeciesLook& field = look.species[s];
        const bool absent = holdings[s] == Holding::absent;
        if (absent || !field.visible || field.mixingScale <= 0.0f) continue;
        const MediumClass wanted = classFor(look, field, cellM);
        auto found = std::find(plan.classes.begin(), plan.classes.end(), wanted);
        if (found == plan.classes.end()) found = plan.classes.insert(found, wanted);
        plan.classOf[s] = static_cast<int>(found - plan.classes.begin());
        plan.extinctionPerHeld[s] = extinctionPerHeld(look, field, holdings[s], cellM);
    }
    return plan;
}

MediumPlan planMedium(const Look& look, const std::array<Holding, kSpeciesCount>& holdings,
                      double cellM, glm::dvec2 widthM) {
    MediumPlan plan = planMedium(look, holdings, cellM);
    plan.repeats = sidesRepeat(look);
    if (!plan.repeats) return plan;
    for (MediumClass& c : plan.classes) c.noiseFit = fitNoise(c.noiseScaleM, widthM);
    return plan;
}

std::vector<PhaseTable> displayPhases(const Look& look, const MediumPlan& plan) {
    std::vector<PhaseTable> tables;
    for (const MediumClass& c : plan.classes) tables.push_back(makePhaseTable(c.phase));
    const DisplayRange range = rangeOf(tables, std::cos(glm::radians(look.phaseTruncationDeg)));
    for (PhaseTable& table : tables) {
        for (glm::vec3& value : table) {
            for (int i = 0; i < 3; ++i) value[i] = displayed(value[i], look.phaseDisplay, range);
        }
    }
    return tables;
}

ForwardShares forwardShares(const Look& look) {
    const PhaseSpec spec{.kind = PhaseKind::cornetteShanks, .g = look.forwardG};
    const float fullRad = glm::radians(look.forwardAngleDeg);
    return {phaseCumulative(spec, fullRad / 4.0f), phaseCumulative(spec, fullRad / 2.0f)};
}

}  // namespace neph
