// forward_peak_test.cpp: against series in closed form.
#include "core/transport/forward_peak.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace neph;

namespace {

constexpr std::array<double, 3> kTimes{1.0, 2.0, 4.0};

PhaseTable tableOf(PhaseKind kind, float g) {
    PhaseSpec spec;
    spec.kind = kind;
    spec.g = g;
    return makePhaseTable(spec);
}

/// Of Henyey-Greenstein, whose moments are the powers of g.
double peakOfHg(double g, int degree, double times, double cosTheta) {
    double sum = 0.0, before = 0.0, legendre = 1.0;
    for (int l = 0; l < 500; ++l) {
        const double peak = l > degree ? std::pow(g, l - degree) : 1.0;
        sum += (2 * l + 1) / (4.0 * std::numbers::pi) * std::pow(peak, times) * legendre;
        const double above = ((2 * l + 1) * cosTheta * legendre - l * before) / (l + 1);
        before = legendre;
        legendre = above;
    }
    return std::pow(g, degree) * sum;
}

}  // namespace

TEST_CASE("transport: peaks of Henyey-Greenstein are as their series says") {
    constexpr float kG = 0.85f;
    const PhaseTable phase = tableOf(PhaseKind::henyeyGreenstein, kG);
    for (const int degree : {3, 9}) {
        const auto peaks = peaksOf(phase, degree, kTimes);
        REQUIRE(peaks.size() == kTimes.size());
        for (std::size_t n = 0; n < kTimes.size(); ++n) {
            CAPTURE(degree);
            CAPTURE(kTimes[n]);
            for (const double ofRing : {0.0, 0.02, 0.1, 0.3, 0.5}) {
                const double cosTheta = std::cos(ofRing * std::numbers::pi / degree);
                const double expected =
                    peakOfHg(static_cast<double>(kG), degree, kTimes[n], cosTheta);
                CAPTURE(ofRing);
                CHECK(static_cast<double>(lookUp(peaks[n], static_cast<float>(cosTheta)).g) ==
                      doctest::Approx(std::max(0.0, expected)).epsilon(0.01));
            }
            for (std::size_t i = 0; i < phase.size(); ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(phase.size() - 1);
                if (x * x * degree > 1.0) CHECK(peaks[n][i] == glm::vec3(0.0f));
            }
        }
    }
}

TEST_CASE("transport: what is scattered more often is wider, and less bright in its middle") {
    for (const PhaseKind kind : {PhaseKind::waterDroplets, PhaseKind::roughAggregate}) {
        for (const int degree : {3, 9}) {
            const auto peaks = peaksOf(tableOf(kind, 0.0f), degree, kTimes);
            CHECK(peaks[1].front().g < 0.9f * peaks[0].front().g);
            CHECK(peaks[2].front().g < 0.9f * peaks[1].front().g);
        }
    }
}

TEST_CASE("transport: there is no peak in light that scatters evenly") {
    for (const PhaseTable& peak : peaksOf(tableOf(PhaseKind::isotropic, 0.0f), 3, kTimes)) {
        CHECK(peak == PhaseTable(peak.size(), glm::vec3(0.0f)));
    }
}
