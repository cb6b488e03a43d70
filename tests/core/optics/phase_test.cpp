// phase_test.cpp: phase functions by name, as the renderer and the panels ask for them.
#include "core/optics/phase_functions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <set>
#include <string>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;
using doctest::Approx;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// 2π ∫ table · weight(μ) dμ over the sphere at 550 nm, as the renderer looks it up.
template <typename Weight>
double integrateTable(const PhaseTable& table, Weight weight) {
    constexpr int kNodes = 40000;
    double sum = 0.0;
    for (int i = 0; i < kNodes; ++i) {
        const double s = (i + 0.5) / kNodes;  // crowded at forward, like the table
        const double theta = kPi * s * s;
        sum += 2.0 * kPi *
               static_cast<double>(lookUp(table, static_cast<float>(std::cos(theta))).y) *
               weight(std::cos(theta)) * std::sin(theta) * 2.0 * kPi * s / kNodes;
    }
    return sum;
}

}  // namespace

TEST_CASE("Every phase function has an id, a label and a line of help of its own") {
    std::set<std::string_view> ids, labels, helps;
    for (const PhaseFunction& function : phaseFunctions()) {
        CAPTURE(function.id);
        CHECK(!function.label.empty());
        CHECK(function.help.ends_with(function.id == "isotropic" ? "." : "]"));  // its source
        ids.insert(function.id);
        labels.insert(function.label);
        helps.insert(function.help);
    }
    CHECK(ids.size() == phaseFunctions().size());
    CHECK(labels.size() == phaseFunctions().size());
    CHECK(helps.size() == phaseFunctions().size());
}

TEST_CASE("The sources of phase functions are in the list of references") {
    std::ifstream file(NEPH_TEST_SOURCE_DIR "/docs/references.md");
    const std::string references{std::istreambuf_iterator<char>(file), {}};
    for (const PhaseFunction& function : phaseFunctions()) {
        const std::size_t key = function.help.find('[');
        if (key == std::string_view::npos) continue;
        CAPTURE(function.help);
        CHECK(references.find("| " + std::string(function.help.substr(key)) + " |") !=
              std::string::npos);
    }
}

TEST_CASE("Kinds that code refers to are those that presets spell so") {
    CHECK(phaseFunction(PhaseKind::isotropic).id == "isotropic");
    CHECK(phaseFunction(PhaseKind::rayleigh).id == "rayleigh");
    CHECK(phaseFunction(PhaseKind::henyeyGreenstein).id == "henyey_greenstein");
    CHECK(phaseFunction(PhaseKind::doubleHenyeyGreenstein).id == "double_henyey_greenstein");
    CHECK(phaseFunction(PhaseKind::draine).id == "draine");
    CHECK(phaseFunction(PhaseKind::cornetteShanks).id == "cornette_shanks");
    CHECK(phaseFunction(PhaseKind::waterDroplets).id == "water_droplets");
    CHECK(phaseFunction(PhaseKind::roughAggregate).id == "rough_aggregate");
    CHECK(phaseFunction(PhaseKind::solidColumn).id == "solid_column");
}

TEST_CASE("A phase function changes with the parameters that it reads, and with no others") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        for (float PhaseSpec::*member : {&PhaseSpec::g, &PhaseSpec::g2, &PhaseSpec::weight,
                                         &PhaseSpec::alpha, &PhaseSpec::radiusM}) {
            PhaseSpec other = spec;
            other.*member *= 0.5f;
            const bool changes = phaseAsymmetry(other) != phaseAsymmetry(spec) ||
                                 phaseValue(other, 0.7f) != phaseValue(spec, 0.7f);
            CHECK(changes == phaseReads(spec.kind, member));
        }
    }
}

TEST_CASE("The cumulative of every phase function is the integral of its table") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        const PhaseTable table = makePhaseTable(spec);
        for (const double degrees : {1.0, 10.0, 60.0, 120.0}) {
            CAPTURE(degrees);
            const double edge = std::cos(glm::radians(degrees));
            const double share = integrateTable(table, [&](double mu) { return mu > edge; });
            const auto stated = static_cast<double>(
                phaseCumulative(spec, static_cast<float>(glm::radians(degrees))));
            CHECK(std::abs(share - stated) < 1e-3);
        }
    }
}

TEST_CASE("The table of every kind integrates to one and has the stated asymmetry") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        const PhaseTable table = makePhaseTable(spec);
        REQUIRE(table.size() == static_cast<std::size_t>(kPhaseTableSize));
        CHECK(integrateTable(table, [](double) { return 1.0; }) == Approx(1.0).epsilon(5e-4));
        const double mean = integrateTable(table, [](double mu) { return mu; });
        CHECK(std::abs(mean - static_cast<double>(phaseAsymmetry(spec))) < 5e-4);
    }
}

TEST_CASE("Values by name are those of the table at every angle") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        const PhaseTable table = makePhaseTable(spec);
        for (float mu : {1.0f, 0.999f, 0.8f, 0.0f, -0.7f, -1.0f}) {
            const glm::vec3 value = phaseValue(spec, mu);
            const glm::vec3 tabulated = lookUp(table, mu);
            for (int c = 0; c < 3; ++c) CHECK(tabulated[c] == Approx(value[c]).epsilon(1e-3));
        }
    }
}

TEST_CASE("The cumulative by name starts at 0, never falls and ends at 1") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        CHECK(phaseCumulative(spec, 0.0f) == Approx(0.0).epsilon(1e-6));
        CHECK(phaseCumulative(spec, static_cast<float>(kPi)) == Approx(1.0).epsilon(1e-5));
        float before = 0.0f;
        for (int degrees = 0; degrees <= 180; ++degrees) {
            const float now = phaseCumulative(spec, glm::radians(static_cast<float>(degrees)));
            CHECK(now >= before - 1e-6f);
            before = now;
        }
    }
}

TEST_CASE("Samples by name pass the Kolmogorov-Smirnov test against the cumulative") {
    for (const PhaseSpec& spec : typicalSpecs()) {
        CAPTURE(phaseFunction(spec.kind).id);
        constexpr int kSamples = 4096;
        std::vector<double> shares;
        std::uint32_t state = 7u;
        for (int i = 0; i < kSamples; ++i) {
            state = state * 1664525u + 1013904223u;  // [Knuth98] §3.3.4
            const float mu = phaseSample(spec, static_cast<float>(state >> 8u) / 16777216.0f);
            REQUIRE(std::abs(mu) <= 1.0f + 1e-6f);
            const float theta = std::acos(std::clamp(mu, -1.0f, 1.0f));
            shares.push_back(static_cast<double>(phaseCumulative(spec, theta)));
        }
        std::sort(shares.begin(), shares.end());
        double distance = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double share = shares[static_cast<std::size_t>(i)];
            distance = std::max({distance, share - static_cast<double>(i) / kSamples,
                                 static_cast<double>(i + 1) / kSamples - share});
        }
        CHECK(distance < 1.63 / std::sqrt(static_cast<double>(kSamples)));  // 1 % level
    }
}

TEST_CASE("The uniform Cornette-Shanks function is reached by name") {
    const PhaseSpec spec{.kind = PhaseKind::cornetteShanks, .g = 0.85f};
    CHECK(phaseValue(spec, 1.0f).y == Approx(7.209958).epsilon(1e-5));
    CHECK(phaseCumulative(spec, glm::radians(10.0f)) == Approx(0.37859480).epsilon(1e-5));
    CHECK(phaseAsymmetry({.kind = PhaseKind::cornetteShanks, .g = 0.80765f}) ==
          Approx(0.85).epsilon(1e-5));
}

TEST_CASE("Looking up clamps what rounding puts outside the sphere") {
    const PhaseTable table = makePhaseTable({.kind = PhaseKind::henyeyGreenstein});
    CHECK(lookUp(table, 1.0000002f) == table.front());
    CHECK(lookUp(table, -1.0000002f) == table.back());
}
