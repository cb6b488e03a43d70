// to_scale_test.cpp: which looks show water and ice as the data have them, and what others say.
#include "core/look/to_scale.h"

#include <doctest/doctest.h>

#include "core/volume/scale_data.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// Data of 1 km cells with such fields, whose sizes they state.
ScaleData dataWith(std::initializer_list<Species> species) {
    ScaleData data;
    for (const Species s : species) data.fields[static_cast<std::size_t>(s)] = {true, true};
    return data;
}

/// All water and ice, by the sizes of the data.
Look faithful() {
    Look look;
    for (SpeciesLook& field : look.species) field.radiusSource = RadiusSource::file;
    return look;
}

std::string said(const Look& look, const ScaleData& data) {
    return scaleText(notToScale(look, data));
}

}  // namespace

TEST_CASE("All water and ice with the sizes of the data and all scattering is to scale") {
    const ScaleData data = dataWith({Species::cloud, Species::ice, Species::rain});
    Look look = faithful();
    CHECK(said(look, data) == "to scale");
    // Of view and light, none of which changes what is there.
    look.exposureEv = 3.0f;
    look.toneMap = ToneMap::linear;
    look.skyModel = SkyModel::atmosphere;
    look.sunIntensity = 2.0f;
    look.groundVisible = false;
    look.domainSides = DomainSides::periodic;
    look.engine = Engine::reference;
    look.radiationOptics = RadiationOptics::wrfRrtmg;
    look.of(Species::ice).phase.kind = PhaseKind::solidColumn;
    CHECK(said(look, data) == "to scale");
    // What the reference does not read.
    look.transport = Transport::lowAlbedo;
    look.phaseDisplay = PhaseDisplay::linear;
    CHECK(said(look, data) == "to scale");
}

TEST_CASE("Amounts that are scaled or left out are named, where the data have any") {
    Look look = faithful();
    look.of(Species::cloud).mixingScale = 0.02f;
    look.of(Species::ice).mixingScale = 0.0f;
    look.of(Species::rain).mixingScale = 0.1f;
    look.of(Species::snow).visible = false;
    CHECK(said(look, dataWith({Species::cloud, Species::rain})) ==
          "not to scale: cloud x0.02, rain x0.1");
    CHECK(said(look, dataWith({Species::ice, Species::snow})) ==
          "not to scale: without ice, without snow");
    CHECK(said(look, dataWith({Species::graupel})) == "to scale");
    CHECK(said(look, {}) == "to scale");
}

TEST_CASE("A mixing scale by cell counts as it acts on the data") {
    Look look = faithful();
    look.of(Species::cloud).mixingScale = 0.02f;
    look.mixing = MixingRule::byCell;
    ScaleData data = dataWith({Species::cloud});
    data.cellM = 100.0;
    CHECK(said(look, data) == "not to scale: cloud x0.2");
    data.cellM = 20.0;
    CHECK(said(look, data) == "to scale");
}

TEST_CASE("A constant radius counts where the data have others, or no particle is of that size") {
    Look look = faithful();
    look.of(Species::ice).radiusSource = RadiusSource::constant;
    ScaleData data = dataWith({Species::cloud, Species::ice});
    CHECK(said(look, data) == "not to scale: constant radii, not those of the data: ice");
    FieldOfData& ice = data.fields[static_cast<std::size_t>(Species::ice)];
    ice = {true, false, 5e-6, 125e-6};
    CHECK(said(look, data) == "not to scale: ice of 1e+03 µm");
    look.of(Species::ice).effectiveRadiusM = 40e-6f;
    CHECK(said(look, data) == "to scale");
    look.extinction = ExtinctionMode::equal;  // radii play no part
    ice.statesSize = true;
    CHECK(said(look, data) == "not to scale: every field with 10 m²/kg");
}

TEST_CASE("Optics other than those of water and ice are named") {
    const ScaleData data = dataWith({Species::cloud, Species::ice});
    Look look = faithful();
    look.of(Species::cloud).albedo = 0.9f;
    look.of(Species::ice).phase.kind = PhaseKind::waterDroplets;
    CHECK(said(look, data) ==
          "not to scale: cloud of albedo 0.9; ice scatters as Water droplets (Mie)");
    look = faithful();
    look.phaseMode = PhaseMode::uniform;
    look.uniformPhase.kind = PhaseKind::waterDroplets;
    CHECK(said(look, dataWith({Species::cloud, Species::rain})) == "to scale");
    CHECK(contains(said(look, data), "ice scatters as"));
    look = faithful();
    look.colour = ColourMode::fields;
    CHECK(said(look, data) == "not to scale: field colours: cloud, ice");
}

TEST_CASE("Noise counts where it adds mass") {
    const ScaleData data = dataWith({Species::cloud, Species::ice});
    Look look = faithful();
    look.of(Species::cloud).noiseAmount = 1.0f;
    look.of(Species::ice).noiseAmount = 1.5f;
    CHECK(said(look, data) == "not to scale: detail noise adds mass: ice");
    look.noise = false;
    CHECK(said(look, data) == "to scale");
}

TEST_CASE("Light that is not followed to its end is named, by the engine that draws") {
    const ScaleData data = dataWith({Species::cloud});
    Look look = faithful();
    look.transport = Transport::lowAlbedo;
    CHECK(said(look, data) == "not to scale: light scattered once");
    look.transport = Transport::full;
    look.engine = Engine::slicing;
    look.phaseDisplay = PhaseDisplay::logarithmic;
    CHECK(said(look, data) ==
          "not to scale: light scattered forwards alone; phase functions for display");
}

TEST_CASE("Whether data state sizes is told by radius, number and scheme") {
    DatasetInfo info;
    info.spacingM = {500.0, 500.0};
    for (const Species s : {Species::cloud, Species::ice}) {
        VariableInfo& ratio = info.variables.emplace_back();
        ratio.name = s == Species::cloud ? "QC" : "QI";
        ratio.role = VariableRole::mixingRatio;
        ratio.species = s;
    }
    VolumeSummary shown;
    shown.anything[static_cast<std::size_t>(Species::cloud)] = true;
    const auto cloudOf = [&] { return scaleDataOf(info, shown).fields[0]; };
    CHECK(scaleDataOf(info, shown).cellM == 500.0);
    CHECK_FALSE(scaleDataOf(info, shown).fields[1].anything);
    CHECK_FALSE(cloudOf().statesSize);
    CHECK(cloudOf().mostRadiusM == doctest::Approx(50e-6));
    info.cloudDropletsPerM3 = 7e7;
    CHECK(cloudOf().statesSize);
    info.cloudDropletsPerM3 = 0.0;
    info.microphysics = Microphysics::wsm6;
    CHECK(cloudOf().statesSize);
    info.microphysics = Microphysics::lin;  // has none of droplets
    CHECK_FALSE(cloudOf().statesSize);
    VariableInfo& radius = info.variables.emplace_back();
    radius.name = "RE_CLOUD";
    radius.role = VariableRole::effectiveRadius;
    radius.species = Species::cloud;
    CHECK(cloudOf().statesSize);
}
