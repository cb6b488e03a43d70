// random_test.cpp: stateless random numbers, directions around an axis, and the tables from which
// scattering angles are sampled.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;

TEST_CASE("Random words are those of the published hash") {
    // pcg4d of [JO20], computed by hand for four zeros: after the linear step all words are c.
    std::uint32_t v[4] = {1013904223u, 1013904223u, 1013904223u, 1013904223u};
    const auto mix = [&v] {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
    };
    mix();
    for (std::uint32_t& word : v) word ^= word >> 16;
    mix();
    const glm::uvec4 words = glsl::randomWords(glm::uvec4(0u));
    CHECK(words == glm::uvec4(v[0], v[1], v[2], v[3]));
}

TEST_CASE("Random numbers of neighbouring pixels, passes and draws fill their bins evenly") {
    constexpr int kBins = 64, kEach = 1000, kCount = kBins * kEach;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<std::array<int, kBins>, 4> bins{};
        for (int i = 0; i < kCount; ++i) {
            glm::uvec4 of(7u, 3u, 11u, 0u);
            of[axis] = static_cast<std::uint32_t>(i);
            const glm::vec4 u = glsl::unitsOf(glsl::randomWords(of));
            for (int k = 0; k < 4; ++k) {
                REQUIRE(u[k] >= 0.0f);
                REQUIRE(u[k] < 1.0f);
                ++bins[static_cast<std::size_t>(k)][static_cast<std::size_t>(u[k] * kBins)];
            }
        }
        for (const auto& counts : bins) {
            double chi2 = 0.0;
            for (const int count : counts) chi2 += std::pow(count - kEach, 2) / kEach;
            // 63 degrees of freedom: beyond 120 once in 60,000, and below 25 likewise.
            CHECK(chi2 < 120.0);
            CHECK(chi2 > 25.0);
        }
    }
}

TEST_CASE("A direction around an axis has unit length and the requested angle") {
    for (const glm::vec3 axis : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0),
                                 glm::normalize(glm::vec3(1, -2, -0.01f))}) {
        for (const float versine : {0.0f, 1e-5f, 0.1f, 1.0f, 1.9f, 2.0f}) {
            const glm::vec3 dir = glsl::directionAround(axis, versine, 0.37f);
            CHECK(glm::length(dir) == doctest::Approx(1.0).epsilon(1e-6));
            CHECK(glsl::versineBetween(axis, dir) ==
                  doctest::Approx(static_cast<double>(versine)).epsilon(1e-3).scale(1e-3));
        }
    }
    // One full circle of azimuths: the mean of the directions is on the axis.
    const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    glm::vec3 sum(0.0f);
    for (int i = 0; i < 360; ++i) {
        sum += glsl::directionAround(axis, 0.5f, static_cast<float>(i) / 360.0f) / 360.0f;
    }
    CHECK(glm::length(sum - 0.5f * axis) < 1e-5f);
}

TEST_CASE("Cosine-weighted directions have a mean cosine of two thirds") {
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / 10000.0f;
        sum += (1.0 - static_cast<double>(glsl::versineByCosine(u))) / 10000.0;
    }
    CHECK(sum == doctest::Approx(2.0 / 3.0).epsilon(1e-4));
}

TEST_CASE("The table index of small angles is accurate to float precision") {
    constexpr int kSize = 1024;
    for (const int entry : {1, 3, 10, 100, 700, 1022}) {
        const auto theta = static_cast<double>(glsl::phaseTableTheta(entry, kSize));
        const auto versine = static_cast<float>(2.0 * std::pow(std::sin(0.5 * theta), 2));
        CHECK(glsl::phaseTableIndexOfVersine(versine, kSize) ==
              doctest::Approx(entry).epsilon(1e-4));
    }
}
