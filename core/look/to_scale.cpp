// to_scale.cpp: the fields first, then what is common to them.
#include "core/look/to_scale.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <utility>

#include "core/look/medium.h"
#include "core/optics/phase_functions.h"

namespace neph {
namespace {

/// A field that takes part in the image, or should.
struct ShownField {
    const SpeciesInfo& known;
    const SpeciesLook& look;
    const FieldOfData& data;
    double cellM;
};

/// "cloud x0.02", "without snow"; empty where all of it is shown.
std::string amountReason(const Look& look, const ShownField& field) {
    const float scale = mixingScaleAt(look, field.look, field.cellM);
    if (!field.look.visible || scale <= 0.0f) return fmt::format("without {}", field.known.id);
    return scale == 1.0f ? std::string() : fmt::format("{} x{:.3g}", field.known.id, scale);
}

bool ownRadiusIgnored(const Look& look, const ShownField& field) {
    return look.extinction == ExtinctionMode::physical && field.data.statesSize &&
           field.look.radiusSource == RadiusSource::constant;
}

/// "ice of 1000 µm" where no particles of it are so large, or so small.
std::string sizeReason(const Look& look, const ShownField& field) {
    const bool constant = look.extinction == ExtinctionMode::physical && !field.data.statesSize &&
                          field.look.radiusSource == RadiusSource::constant;
    const auto radiusM = static_cast<double>(field.look.effectiveRadiusM);
    if (!constant || (radiusM >= field.data.leastRadiusM && radiusM <= field.data.mostRadiusM)) {
        return {};
    }
    return fmt::format("{} of {:.3g} µm", field.known.id, 1e6 * radiusM);
}

/// "cloud scatters as Isotropic" where its phase function is not one of its particles.
std::string phaseReason(const Look& look, const ShownField& field) {
    const bool own = look.phaseMode == PhaseMode::perField;
    const PhaseFunction& phase =
        phaseFunction(own ? field.look.phase.kind : look.uniformPhase.kind);
    const Scatterer right = field.known.liquid ? Scatterer::droplets : Scatterer::crystals;
    if (phase.scatterer == right) return {};
    return fmt::format("{} scatters as {}", field.known.id, phase.label);
}

/// Lists with one reason each, of the fields that it holds of.
struct FieldReasons {
    std::vector<std::string> amounts, sizes, albedos, phases;
    std::vector<std::string_view> constant, noisy, coloured;
};

void addReasons(FieldReasons& reasons, const Look& look, const ShownField& field) {
    const auto add = [](std::vector<std::string>& list, std::string text) {
        if (!text.empty()) list.push_back(std::move(text));
    };
    add(reasons.amounts, amountReason(look, field));
    if (!field.look.visible || field.look.mixingScale <= 0.0f) return;
    add(reasons.sizes, sizeReason(look, field));
    if (field.look.albedo != 1.0f) {
        reasons.albedos.push_back(
            fmt::format("{} of albedo {:.3g}", field.known.id, field.look.albedo));
    }
    add(reasons.phases, phaseReason(look, field));
    if (ownRadiusIgnored(look, field)) reasons.constant.push_back(field.known.id);
    // Up to 1 the noise keeps the mass. docs/physics.md §8
    if (look.noise && field.look.noiseAmount > 1.0f) reasons.noisy.push_back(field.known.id);
    if (look.colour == ColourMode::fields && field.look.colour != glm::vec3(1.0f)) {
        reasons.coloured.push_back(field.known.id);
    }
}

FieldReasons reasonsOf(const Look& look, const ScaleData& data) {
    FieldReasons reasons;
    for (std::size_t s = 0; s < data.fields.size(); ++s) {
        if (!data.fields[s].anything) continue;
        addReasons(reasons, look, {kSpecies[s], look.species[s], data.fields[s], data.cellM});
    }
    return reasons;
}

/// How light is followed where it is not followed to its end.
void addLightReasons(std::vector<std::string>& all, const Look& look) {
    if (!traitsOf(look.engine).singleScattering || scattersOften(look)) return;
    all.emplace_back(look.transport == Transport::lowAlbedo ? "light scattered once"
                                                            : "light scattered forwards alone");
    if (look.phaseDisplay != PhaseDisplay::physical) {
        all.emplace_back("phase functions for display");
    }
}

}  // namespace

std::vector<std::string> notToScale(const Look& look, const ScaleData& data) {
    const FieldReasons fields = reasonsOf(look, data);
    std::vector<std::string> all;
    const auto list = [&all](std::string_view what, const auto& items) {
        if (!items.empty()) all.push_back(fmt::format("{}{}", what, fmt::join(items, ", ")));
    };
    list("", fields.amounts);
    if (look.extinction == ExtinctionMode::equal) {
        all.push_back(fmt::format("every field with {:.3g} m²/kg", look.equalExtinctionM2PerKg));
    }
    list("constant radii, not those of the data: ", fields.constant);
    list("", fields.sizes);
    list("", fields.albedos);
    list("", fields.phases);
    list("detail noise adds mass: ", fields.noisy);
    list("field colours: ", fields.coloured);
    addLightReasons(all, look);
    return all;
}

std::string scaleText(const std::vector<std::string>& reasons) {
    if (reasons.empty()) return "to scale";
    return fmt::format("not to scale: {}", fmt::join(reasons, "; "));
}

}  // namespace neph
