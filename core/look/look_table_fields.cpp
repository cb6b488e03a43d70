// look_table_fields.cpp: the rows of each field, and of phase functions. A long table is data: one
// row, one parameter.
#include "core/look/look_table.h"
#include "core/look/parameter_rows.h"
#include "core/optics/phase_functions.h"

namespace neph {
namespace {

std::vector<Choice> phaseChoices() {
    std::vector<Choice> choices;
    for (const PhaseFunction& function : phaseFunctions()) {
        choices.push_back({function.id, function.label, function.help});
    }
    return choices;
}

/// A number of a phase function, which acts where its kind reads it.
template <typename Place>
Parameter& phaseNumber(Rows<Place>& rows, const std::string& id, std::string_view label,
                       std::string_view unit, float PhaseSpec::*member, ParameterRange range,
                       std::string_view help) {
    Parameter& row = rows.number(id, label, unit, member, range, Stage::medium, help);
    row.acts = [spec = rows.place(), member](const Look& look) {
        return phaseReads(spec(look).kind, member);
    };
    return row;
}

/// A phase function's kind and numbers; `id` opens theirs.
template <typename Place>
void addPhase(Rows<Place> rows, const std::string& id, Overrule overruled = {}) {
    rows.choice(id, "Phase function", &PhaseSpec::kind, Stage::medium, phaseChoices(),
                "Angular distribution of scattered light, P in Eq. 5. docs/physics.md §2")
        .overruled = overruled;
    phaseNumber(rows, id + "_g", "Asymmetry g", "1", &PhaseSpec::g, {-0.99, 0.999},
                "g of Henyey-Greenstein, Draine and Cornette-Shanks; first lobe of the double HG.");
    phaseNumber(rows, id + "_g2", "Second lobe g", "1", &PhaseSpec::g2, {-0.99, 0.99},
                "g of the second lobe of the double Henyey-Greenstein.");
    phaseNumber(rows, id + "_weight", "First lobe share", "1", &PhaseSpec::weight, {0.0, 1.0},
                "Share of the first lobe of the double Henyey-Greenstein.");
    phaseNumber(rows, id + "_alpha", "Draine alpha", "1", &PhaseSpec::alpha, {0.0, 250.0},
                "0 is Henyey-Greenstein, 1 Cornette-Shanks. [Draine03]");
    Parameter& radius = phaseNumber(
        rows, id + "_radius", "Phase radius", "m", &PhaseSpec::radiusM, {1e-6, 110e-6, true},
        "Effective radius of the droplets or crystals whose phase function is used; the extinction "
        "has its own. Droplets count up to 50 µm.");
    radius.displayUnit = "µm";
    radius.displayScale = 1e6;
}

/// Where the radius of a field comes from, and the constant one.
void addRadius(FieldRows& rows) {
    const auto isConstant = [field = rows.place()](const Look& look) {
        return field(look).radiusSource == RadiusSource::constant;
    };
    rows.choice("radius_source", "Radius from", &SpeciesLook::radiusSource, Stage::data,
                {{"constant", "Constant", "One radius for the whole field; nothing is read again."},
                 {"file", "From the file", "Effective radii that the model wrote."},
                 {"number", "From number", "From mass and number of particles in each cell."},
                 {"scheme", "By the scheme",
                  "From mass by the size distribution that the microphysics scheme assumes."}},
                "A constant, or cell by cell from the model: effective radii in the file, numbers "
                "of particles, or the microphysics scheme's own size distribution; what is missing "
                "is replaced by the next of these. The largest change an image can have: a "
                "model's ice of 20-50 µm has 82-33 m²/kg, the paper's of 1 mm 1.64, so anvils "
                "become 20 to 50 times more opaque. Reads the data again. docs/physics.md §7")
        .overruled = {[](const Look& look) { return look.extinction == ExtinctionMode::equal; },
                      "Extinction is Equal"};
    Parameter& radius =
        rows.number("effective_radius", "Effective radius", "m", &SpeciesLook::effectiveRadiusM,
                    {1e-6, 1e-2, true}, Stage::medium,
                    "Constant radius in Eq. 3 and 9; extinction goes as 1/r. [Riley03] table 3");
    radius.displayUnit = "µm";
    radius.displayScale = 1e6;
    radius.link = LinkPolicy::factor;
    radius.acts = isConstant;
    Parameter& density =
        rows.number("density", "Particle density", "kg m-3", &SpeciesLook::densityKgPerM3,
                    {10.0, 1000.0, true}, Stage::medium,
                    "Density of one particle of the constant radius, Eq. 3; extinction goes as "
                    "1/density.");
    density.link = LinkPolicy::own;
    density.acts = isConstant;
}

void addNoise(FieldRows& rows) {
    rows.number("noise_amount", "Noise amount", "1", &SpeciesLook::noiseAmount, {0.0, 4.0},
                Stage::medium,
                "Portion of the field that the noise multiplies, [Riley03] §4.5; above 1 the thin "
                "parts are eaten away.")
        .overruled = {[](const Look& look) { return !look.noise; }, "Detail noise is off"};
    rows.number("noise_cells", "Noise scale", "cells", &SpeciesLook::noiseScaleCells,
                {0.05, 1000.0, true}, Stage::medium,
                "Length of the largest features of the noise, in horizontal cells of the data: "
                "detail adapts to a storm of 1 km cells and to a cumulus of 20 m ones.");
    rows.choice("noise_character", "Noise character", &SpeciesLook::noiseCharacter, Stage::medium,
                {{"billow", "Billow", "Rounded heaps, as convective cloud has."},
                 {"wisp", "Wisp", "Streaks, as cirrus has."}},
                "Billowing as convective cloud, or wispy as cirrus.");
}

void addField(std::vector<Parameter>& table, Species s) {
    FieldRows rows(table,
                   {.name = std::string(info(s).label),
                    .prefix = std::string(info(s).id) + ".",
                    .part = ParameterPart::fields,
                    .species = s,
                    .link = LinkPolicy::value},
                   {s});
    rows.toggle("visible", "Visible", &SpeciesLook::visible, Stage::medium,
                "Whether the field takes part at all.")
        .link = LinkPolicy::own;
    rows.number("mixing_scale", "Mixing scale", "1", &SpeciesLook::mixingScale, {0.0, 100.0, true},
                Stage::medium, "Multiplies the field's mixing ratio, H in Eq. 1. [Riley03] §5")
        .link = LinkPolicy::factor;
    addRadius(rows);
    rows.number("albedo", "Albedo", "1", &SpeciesLook::albedo, {0.0, 1.0}, Stage::medium,
                "Single-scattering albedo: share of extinction that scatters, Eq. 10.");
    rows.colour("colour", "Field colour", &SpeciesLook::colour, Stage::medium,
                "Colour when mode.colour is fields. [Riley03] table 2")
        .link = LinkPolicy::own;
    addPhase(rows.within(&SpeciesLook::phase), "phase",
             {[](const Look& look) { return look.phaseMode == PhaseMode::uniform; },
              "Phase is Uniform"});
    addNoise(rows);
}

}  // namespace

void addFields(std::vector<Parameter>& table) {
    for (int s = 0; s < kSpeciesCount; ++s) addField(table, static_cast<Species>(s));
}

void addUniformPhase(std::vector<Parameter>& table) {
    LookRows rows(table, {.name = "Light", .prefix = "light.", .part = ParameterPart::fields});
    addPhase(rows.within(&Look::uniformPhase), "uniform_phase");
}

}  // namespace neph
