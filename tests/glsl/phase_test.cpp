// phase_test.cpp: closed-form phase functions against quadrature and tabulated values.
// docs/physics.md §2
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;
using doctest::Approx;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kDegree = 0.0174532925f;

struct Function {
    std::string name;
    std::function<float(float)> value, cumulative, sample;
    double asymmetry;
};

/// Every closed-form phase function, over its range of parameters.
std::vector<Function> functions() {
    std::vector<Function> all;
    all.push_back({"isotropic", [](float) { return glsl::isotropicValue(); },
                   glsl::isotropicCumulative, glsl::isotropicSample, 0.0});
    all.push_back(
        {"rayleigh", glsl::rayleighValue, glsl::rayleighCumulative, glsl::rayleighSample, 0.0});
    for (float g : {-0.9f, -0.5f, -1e-4f, 0.0f, 0.01f, 0.5f, 0.85f, 0.979f}) {
        all.push_back({"hg " + std::to_string(g), [g](float mu) { return glsl::hgValue(mu, g); },
                       [g](float theta) { return glsl::hgCumulative(theta, g); },
                       [g](float u) { return glsl::hgSample(u, g); }, static_cast<double>(g)});
        for (float alpha : {0.0f, 1.0f, 27.1137f, 250.0f}) {
            all.push_back({"draine " + std::to_string(g) + " " + std::to_string(alpha),
                           [=](float mu) { return glsl::draineValue(mu, g, alpha); },
                           [=](float theta) { return glsl::draineCumulative(theta, g, alpha); },
                           [=](float u) { return glsl::draineSample(u, g, alpha); },
                           static_cast<double>(glsl::draineAsymmetry(g, alpha))});
        }
    }
    all.push_back({"cornette-shanks", [](float mu) { return glsl::cornetteShanksValue(mu, 0.85f); },
                   [](float theta) { return glsl::cornetteShanksCumulative(theta, 0.85f); },
                   [](float u) { return glsl::cornetteShanksSample(u, 0.85f); },
                   static_cast<double>(glsl::cornetteShanksAsymmetry(0.85f))});
    all.push_back({"double hg", [](float mu) { return glsl::doubleHgValue(mu, 0.9f, -0.4f, 0.8f); },
                   [](float theta) { return glsl::doubleHgCumulative(theta, 0.9f, -0.4f, 0.8f); },
                   [](float u) { return glsl::doubleHgSample(u, 0.9f, -0.4f, 0.8f); },
                   0.8 * 0.9 - 0.2 * 0.4});
    for (float radius : {1e-6f, 30e-6f, 1e-3f}) {
        all.push_back({"rough aggregate " + std::to_string(radius),
                       [=](float mu) { return glsl::roughAggregateValue(mu, radius); },
                       [=](float theta) { return glsl::roughAggregateCumulative(theta, radius); },
                       [=](float u) { return glsl::roughAggregateSample(u, radius); },
                       static_cast<double>(glsl::roughAggregateAsymmetry(radius))});
        all.push_back({"solid column " + std::to_string(radius),
                       [=](float mu) { return glsl::solidColumnValue(mu, radius); },
                       [=](float theta) { return glsl::solidColumnCumulative(theta, radius); },
                       [=](float u) { return glsl::solidColumnSample(u, radius); },
                       static_cast<double>(glsl::solidColumnAsymmetry(radius))});
    }
    return all;
}

/// 2π ∫ value(cos θ) weight(cos θ) sin θ dθ from 0 to `thetaMax`; nodes are denser at both ends.
template <typename Value, typename Weight>
double integrate(Value value, Weight weight, double thetaMax = kPi) {
    constexpr int kNodes = 20000;
    double sum = 0.0;
    for (int i = 0; i < kNodes; ++i) {
        const double t = (i + 0.5) / kNodes;
        const double theta = thetaMax * 0.5 * (1.0 - std::cos(kPi * t));
        const double dTheta = thetaMax * 0.5 * kPi * std::sin(kPi * t) / kNodes;
        const auto mu = static_cast<float>(std::cos(theta));
        sum += 2.0 * kPi * static_cast<double>(value(mu)) * weight(std::cos(theta)) *
               std::sin(theta) * dTheta;
    }
    return sum;
}

}  // namespace

TEST_CASE("Every phase function integrates to one over the sphere") {
    for (const Function& f : functions()) {
        CAPTURE(f.name);
        CHECK(integrate(f.value, [](double) { return 1.0; }) == Approx(1.0).epsilon(2e-4));
    }
}

TEST_CASE("Every phase function has the mean cosine that it states") {
    for (const Function& f : functions()) {
        CAPTURE(f.name);
        const double mean = integrate(f.value, [](double mu) { return mu; });
        CHECK(std::abs(mean - f.asymmetry) < 2e-4);
    }
}

TEST_CASE("Every cumulative is the integral of its phase function, from 0 to 1") {
    for (const Function& f : functions()) {
        CAPTURE(f.name);
        CHECK(f.cumulative(0.0f) == 0.0f);
        CHECK(f.cumulative(static_cast<float>(kPi)) == Approx(1.0).epsilon(2e-6));
        for (float degrees : {0.5f, 5.0f, 30.0f, 90.0f, 150.0f}) {
            CAPTURE(degrees);
            const double exact = integrate(
                f.value, [](double) { return 1.0; }, static_cast<double>(degrees * kDegree));
            CHECK(std::abs(static_cast<double>(f.cumulative(degrees * kDegree)) - exact) < 1.5e-4);
        }
    }
}

TEST_CASE("Every sampler inverts its cumulative") {
    for (const Function& f : functions()) {
        CAPTURE(f.name);
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / 2000.0f;
            const float mu = f.sample(u);
            REQUIRE(std::abs(mu) <= 1.0f + 1e-6f);
            // For sums of two lobes u also chooses the lobe, so cosines are not ordered by u.
            if (f.name.find("hg ") == 0 || f.name.find("draine") == 0 || f.name == "rayleigh") {
                const float theta = std::acos(std::min(1.0f, std::max(-1.0f, mu)));
                const double back = 1.0 - static_cast<double>(f.cumulative(theta));
                worst = std::max(worst, std::abs(back - static_cast<double>(u)));
            }
        }
        // A float cosine near 1 is accurate to 6e-8, times 2π P = 4600 at the peak of g = 0.979.
        CHECK(worst < 3e-4);
    }
}

TEST_CASE("Samples pass the Kolmogorov-Smirnov test against the cumulative") {
    for (const Function& f : functions()) {
        CAPTURE(f.name);
        constexpr int kSamples = 4096;
        std::vector<float> shares;
        glsl::uint state = 12345u;
        for (int i = 0; i < kSamples; ++i) {
            state = state * 1664525u + 1013904223u;  // [Knuth98] §3.3.4
            const float u = static_cast<float>(state >> 8u) / 16777216.0f;
            const float mu = std::min(1.0f, std::max(-1.0f, f.sample(u)));
            shares.push_back(f.cumulative(std::acos(mu)));
        }
        std::sort(shares.begin(), shares.end());
        double distance = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const auto share = static_cast<double>(shares[static_cast<std::size_t>(i)]);
            distance = std::max({distance, share - static_cast<double>(i) / kSamples,
                                 static_cast<double>(i + 1) / kSamples - share});
        }
        CHECK(distance < 1.63 / std::sqrt(static_cast<double>(kSamples)));  // 1 % level
    }
}

TEST_CASE("Cornette-Shanks at g = 0.85 has the tabulated cumulative and values") {
    struct Row {
        float degrees;
        double cumulative;
    };
    for (const Row& row : {Row{1.0f, 0.00684014}, Row{5.0f, 0.14208500}, Row{10.0f, 0.37859480},
                           Row{30.0f, 0.81449379}, Row{90.0f, 0.97504725}, Row{180.0f, 1.0}}) {
        CAPTURE(row.degrees);
        CHECK(glsl::cornetteShanksCumulative(row.degrees * kDegree, 0.85f) ==
              Approx(row.cumulative).epsilon(3e-6));
    }
    CHECK(glsl::cornetteShanksValue(1.0f, 0.85f) == Approx(7.209958).epsilon(1e-5));
    CHECK(glsl::cornetteShanksValue(0.0f, 0.85f) == Approx(5.381925e-3).epsilon(1e-5));
    CHECK(glsl::cornetteShanksValue(-1.0f, 0.85f) == Approx(3.843185e-3).epsilon(1e-5));
}

TEST_CASE("Cornette-Shanks needs g = 0.979 to scatter nine tenths within 10 degrees") {
    CHECK(glsl::cornetteShanksCumulative(10.0f * kDegree, 0.979f) == Approx(0.90).epsilon(2e-3));
}

TEST_CASE("Cornette-Shanks parameters for a given asymmetry are the tabulated ones") {
    struct Row {
        float parameter;
        double asymmetry;
    };
    for (const Row& row : {Row{0.69179f, 0.75}, Row{0.74859f, 0.80}, Row{0.80765f, 0.85},
                           Row{0.81975f, 0.86}, Row{0.83194f, 0.87}}) {
        CHECK(glsl::cornetteShanksAsymmetry(row.parameter) == Approx(row.asymmetry).epsilon(1e-5));
    }
}

TEST_CASE("Henyey-Greenstein cumulative at 10 degrees, g = 0.85, is the tabulated value") {
    CHECK(glsl::hgCumulative(10.0f * kDegree, 0.85f) == Approx(0.345695).epsilon(1e-5));
}

TEST_CASE("Draine with alpha 0 is Henyey-Greenstein, with alpha 1 and g 0 it is Rayleigh") {
    for (float mu : {-1.0f, -0.3f, 0.0f, 0.7f, 1.0f}) {
        CHECK(glsl::draineValue(mu, 0.6f, 0.0f) == glsl::hgValue(mu, 0.6f));
        CHECK(glsl::draineValue(mu, 0.0f, 1.0f) == Approx(glsl::rayleighValue(mu)).epsilon(1e-6));
    }
    CHECK(glsl::rayleighValue(1.0f) == Approx(3.0 / (8.0 * kPi)).epsilon(1e-6));
}

TEST_CASE("Jendersie's droplets of 20 µm, as a sum of two lobes, have the tabulated asymmetry") {
    const float weight = 0.498159f;
    const float g =
        (1.0f - weight) * 0.994610f + weight * glsl::draineAsymmetry(0.593791f, 27.1137f);
    CHECK(g == Approx(0.87931).epsilon(2e-5));
}

TEST_CASE(
    "Ice has the asymmetry of the fit it comes from, and stays there beyond the fitted radii") {
    CHECK(glsl::solidColumnAsymmetry(30e-6f) == Approx(0.7525).epsilon(1e-4));
    for (float radius : {10e-6f, 30e-6f, 50e-6f, 90e-6f}) {
        CAPTURE(radius);
        CHECK(glsl::roughAggregateAsymmetry(radius) >= 0.7455f);
        CHECK(glsl::roughAggregateAsymmetry(radius) <= 0.7515f);
    }
    CHECK(glsl::roughAggregateAsymmetry(1.0f) == glsl::roughAggregateAsymmetry(108.1e-6f));
    CHECK(glsl::solidColumnAsymmetry(0.0f) == glsl::solidColumnAsymmetry(5.96e-6f));
}

TEST_CASE("Angles of table entries increase with the square of the index, up to 180 degrees") {
    CHECK(glsl::phaseTableTheta(0, 1024) == 0.0f);
    CHECK(glsl::phaseTableTheta(1023, 1024) == Approx(kPi));
    CHECK(glsl::phaseTableTheta(3, 7) == Approx(kPi / 4.0));
    for (int i : {0, 1, 100, 511, 900, 1023}) {
        const float index = glsl::phaseTableIndex(std::cos(glsl::phaseTableTheta(i, 1024)), 1024);
        CHECK(std::abs(index - static_cast<float>(i)) < (i == 1 ? 1.01f : 0.05f));
    }
    CHECK(glsl::phaseTableIndex(1.5f, 1024) == 0.0f);
    CHECK(glsl::phaseTableIndex(-1.5f, 1024) == 1023.0f);
}
