// parameter_rows_test.cpp: rows whose kind does not fit their member do not compile.
#include "core/look/parameter_rows.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

template <auto member, typename R = LookRows>
concept Toggle = requires(R rows) {
    rows.toggle("", "", member, Stage::eye, "");
};
template <auto member, typename R = LookRows>
concept Integer = requires(R rows) {
    rows.integer("", "", "", member, {}, Stage::eye, "");
};
template <auto member, typename R = LookRows>
concept Number = requires(R rows) {
    rows.number("", "", "", member, {}, Stage::eye, "");
};
template <auto member, typename R = LookRows>
concept Colour = requires(R rows) {
    rows.colour("", "", member, Stage::eye, "");
};
template <auto member, typename R = LookRows>
concept Chosen = requires(R rows) {
    rows.choice("", "", member, Stage::eye, {}, "");
};

static_assert(Toggle<&Look::noise>);
static_assert(!Toggle<&Look::planes> && !Toggle<&Look::exposureEv> && !Toggle<&Look::engine>);
static_assert(Integer<&Look::planes>);
static_assert(!Integer<&Look::noise> && !Integer<&Look::exposureEv> && !Integer<&Look::engine>);
static_assert(Number<&Look::exposureEv>);
static_assert(!Number<&Look::noise> && !Number<&Look::planes> && !Number<&Look::engine>);
static_assert(Colour<&Look::sunColour>);
static_assert(!Colour<&Look::exposureEv> && !Colour<&Look::noise>);
static_assert(Chosen<&Look::engine>);
static_assert(!Chosen<&Look::planes> && !Chosen<&Look::noise>);

// A member of another struct is no member of this one.
static_assert(Number<&SpeciesLook::albedo, FieldRows> && !Number<&SpeciesLook::albedo>);
static_assert(Integer<&Sampling::seed, SamplingRows> && !Integer<&Sampling::seed>);
static_assert(!Number<&Look::exposureEv, FieldRows>);

}  // namespace

TEST_CASE("A row reads and writes the member that it was made of, within the field of its group") {
    std::vector<Parameter> table;
    FieldRows rows(table, {.name = "Snow", .prefix = "snow.", .species = Species::snow},
                   {Species::snow});
    rows.number("albedo", "Albedo", "1", &SpeciesLook::albedo, {0.0, 1.0}, Stage::medium, "");
    auto phase = rows.within(&SpeciesLook::phase);
    phase.choice("phase", "Phase", &PhaseSpec::kind, Stage::medium,
                 {{"isotropic", "", ""}, {"rayleigh", "", ""}}, "");
    REQUIRE(table.size() == 2);
    CHECK(table[1].id == "snow.phase");
    CHECK(table[1].group == "Snow");
    CHECK(table[1].species == Species::snow);
    Look look;
    setValue(look, table[0], 0.5f);
    setValue(look, table[1], 1);
    Look expected;
    expected.of(Species::snow).albedo = 0.5f;
    expected.of(Species::snow).phase.kind = PhaseKind::rayleigh;
    CHECK(look == expected);
    CHECK(valueOf(look, table[0]) == ParameterValue(0.5f));
    CHECK(valueOf(look, table[1]) == ParameterValue(1));
}
