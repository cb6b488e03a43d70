#include "app/ui/format.h"

#include <doctest/doctest.h>

#include <set>

using namespace neph;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The parameters of the phase function of cloud that act when it is of this kind.
std::set<std::string> acting(PhaseKind kind) {
    Look look;
    look.of(Species::cloud).phase.kind = kind;
    std::set<std::string> ids;
    for (const Parameter& row : lookTable()) {
        if (row.id.starts_with("cloud.phase_") && ui::applies(row, look)) ids.insert(row.id);
    }
    return ids;
}

}  // namespace

TEST_CASE("Numbers carry their unit as a reader writes it") {
    CHECK(ui::sliderFormat(parameter("cloud.effective_radius")) == "%.4g µm");
    CHECK(ui::sliderFormat(parameter("cloud.density")) == "%.4g kg/m³");
    CHECK(ui::sliderFormat(parameter("sun.azimuth")) == "%.4g°");
    CHECK(ui::sliderFormat(parameter("cloud.mixing_scale")) == "%.4g");
    CHECK(ui::sliderFormat(parameter("view.planes")) == "%d");
}

TEST_CASE("A tooltip gives meaning, range and default in the units of the screen, and the id") {
    const std::string tip = ui::tooltipOf(parameter("cloud.effective_radius"));
    CHECK(contains(tip, parameter("cloud.effective_radius").help));
    CHECK(contains(tip, "1 µm to 1e+04 µm"));
    CHECK(contains(tip, "Default 10 µm"));
    CHECK(contains(tip, "cloud.effective_radius"));
    for (const Parameter& row : lookTable()) CHECK(contains(ui::tooltipOf(row), "Default "));
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

TEST_CASE("What is no parameter of a phase function always acts") {
    const Look look;
    for (const Parameter& row : lookTable()) {
        const bool ofPhase = row.id.find("phase_") != std::string::npos &&
                             row.id.find(".phase_truncation") == std::string::npos &&
                             row.id.find(".phase_display") == std::string::npos;
        CAPTURE(row.id);
        if (!ofPhase) CHECK(ui::applies(row, look));
    }
}
