// parameter_acts_test.cpp: which rows of the table act with a phase function, an engine and a sky.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "core/look/parameter.h"
#include "core/optics/phase_functions.h"

using namespace neph;

namespace {

/// The parameters of the phase function of cloud that act when it is of this kind.
std::set<std::string> acting(PhaseKind kind) {
    Look look;
    look.of(Species::cloud).phase.kind = kind;
    std::set<std::string> ids;
    for (const Parameter& row : lookTable()) {
        if (row.id.starts_with("cloud.phase_") && applies(row, look)) ids.insert(row.id);
    }
    return ids;
}

}  // namespace

TEST_CASE("Every parameter that a phase function reads has a row") {
    for (std::size_t kind = 0; kind < phaseFunctions().size(); ++kind) {
        const PhaseFunction& function = phaseFunctions()[kind];
        CAPTURE(function.id);
        CHECK(acting(static_cast<PhaseKind>(kind)).size() == function.reads().size());
    }
}

TEST_CASE("A phase function shows the parameters that it has, and no others") {
    using Ids = std::set<std::string>;
    CHECK(acting(PhaseKind::isotropic) == Ids{});
    CHECK(acting(PhaseKind::henyeyGreenstein) == Ids{"cloud.phase_g"});
    CHECK(acting(PhaseKind::doubleHenyeyGreenstein) ==
          Ids{"cloud.phase_g", "cloud.phase_g2", "cloud.phase_weight"});
    CHECK(acting(PhaseKind::draine) == Ids{"cloud.phase_g", "cloud.phase_alpha"});
    CHECK(acting(PhaseKind::waterDroplets) == Ids{"cloud.phase_radius"});
    CHECK(acting(PhaseKind::roughAggregate) == Ids{"cloud.phase_radius"});
}

TEST_CASE("What is no parameter of a phase function acts with the engines that it is of") {
    Look look;
    look.transport = Transport::translucent;
    look.phaseDisplay = PhaseDisplay::logarithmic;
    for (const Parameter& row : parameterTable()) {
        const bool ofPhase = row.id.find("phase_") != std::string::npos &&
                             row.id.find(".phase_truncation") == std::string::npos &&
                             row.id.find(".phase_display") == std::string::npos;
        const std::set<std::string> ofDate{"sun.latitude", "sun.longitude", "sun.day", "sun.hour"};
        look.sunSource = ofDate.contains(row.id) ? SunSource::date : SunSource::angles;
        const bool ofMoon = row.id.starts_with("sun.moon_");
        look.sunBody = ofMoon ? LightBody::moon : LightBody::sun;
        CAPTURE(row.id);
        for (const Engine engine : {Engine::march, Engine::slicing, Engine::reference}) {
            look.engine = engine;
            const bool acts = (row.engines & bitOf(engine)) != 0;
            if (ofPhase && acts) continue;
            look.skyModel = SkyModel::gradient;
            const bool inGradient = applies(row, look);
            look.skyModel = SkyModel::atmosphere;
            CHECK((inGradient || applies(row, look)) == acts);
        }
    }
    look.engine = Engine::reference;
    CHECK_FALSE(applies(parameter("sky.intensity"), look));
    CHECK(applies(parameter("sky.visibility"), look));
    look.skyModel = SkyModel::gradient;
    CHECK_FALSE(applies(parameter("sky.visibility"), look));
    CHECK_FALSE(applies(parameter("sky.skylight"), look));
    CHECK_FALSE(applies(parameter("light.phase_display"), look));
    CHECK(applies(parameter("sky.intensity"), look));
    CHECK(applies(parameter("view.seed"), look));
    look.engine = Engine::march;
    CHECK_FALSE(applies(parameter("view.seed"), look));
    CHECK(applies(parameter("sky.skylight"), look));
}
