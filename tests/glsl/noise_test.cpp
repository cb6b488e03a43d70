// noise_test.cpp: properties of gradient noise, and of the two textures billow and wisp.
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;

namespace {

/// Positions distributed evenly over the tile (R3 sequence, [Roberts18]).
glm::vec3 spread(int i) {
    const glm::dvec3 step(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    return glm::vec3(glm::fract(step * static_cast<double>(i)));
}

/// Mean square difference of `f` between points `distance` apart along `axis`.
template <typename F>
double structure(F f, glm::vec3 axis, float distance) {
    double sum = 0.0;
    for (int i = 1; i <= 20000; ++i) {
        const glm::vec3 p = spread(i);
        const auto d = static_cast<double>(f(p + axis * distance) - f(p));
        sum += d * d / 20000.0;
    }
    return sum;
}

const glm::vec3 kX(1.0f, 0.0f, 0.0f), kY(0.0f, 1.0f, 0.0f), kZ(0.0f, 0.0f, 1.0f);

}  // namespace

TEST_CASE("Gradient noise is zero on its lattice, within [-1, 1] elsewhere, and zero on average") {
    const glm::ivec3 cells(5, 7, 9);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 node = glm::floor(spread(i) * glm::vec3(cells)) / glm::vec3(cells);
        CHECK(std::abs(glsl::gradientNoise(node, cells, 3u)) < 1e-5f);
    }
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < 50000; ++i) {
        const auto n = static_cast<double>(glsl::gradientNoise(spread(i), cells, 3u));
        sum += n / 50000.0;
        largest = std::max(largest, std::abs(n));
    }
    CHECK(std::abs(sum) < 0.02);
    CHECK(largest <= 1.0);
    CHECK(largest > 0.5);
}

TEST_CASE("Gradient noise is smooth across the faces of its cells") {
    const glm::ivec3 cells(4);
    for (int i = 1; i < 200; ++i) {
        const glm::vec3 p = spread(i);
        const glm::vec3 face(0.25f, p.y, p.z);
        const glm::vec3 h(1e-3f, 0.0f, 0.0f);
        const float before =
            glsl::gradientNoise(face, cells, 1u) - glsl::gradientNoise(face - h, cells, 1u);
        const float after =
            glsl::gradientNoise(face + h, cells, 1u) - glsl::gradientNoise(face, cells, 1u);
        CHECK(std::abs(after - before) < 1e-4f);
    }
}

TEST_CASE("Different seeds give different noise") {
    double difference = 0.0;
    for (int i = 1; i < 1000; ++i) {
        difference +=
            std::abs(static_cast<double>(glsl::gradientNoise(spread(i), glm::ivec3(4), 0u) -
                                         glsl::gradientNoise(spread(i), glm::ivec3(4), 1u))) /
            1000.0;
    }
    CHECK(difference > 0.1);
}

TEST_CASE("Billow and wisp repeat from tile to tile, on both sides of the origin") {
    for (int i = 1; i < 500; ++i) {
        const glm::vec3 p = spread(i);
        for (const glm::vec3 shift : {kX, -kX, kY, -kY, kZ, -kZ, glm::vec3(-3.0f, 2.0f, -1.0f)}) {
            CHECK(std::abs(glsl::billow(p + shift) - glsl::billow(p)) < 1e-3f);
            CHECK(std::abs(glsl::wisp(p + shift) - glsl::wisp(p)) < 3e-3f);
        }
    }
}

TEST_CASE("Billow and wisp are within [0, 1] and have the stated mean") {
    double billow = 0.0, wisp = 0.0;
    constexpr int kSamples = 200000;
    for (int i = 0; i < kSamples; ++i) {
        const float b = glsl::billow(spread(i)), w = glsl::wisp(spread(i));
        REQUIRE(b >= 0.0f);
        REQUIRE(b <= 1.0f);
        REQUIRE(w >= 0.0f);
        REQUIRE(w <= 1.0f);
        billow += static_cast<double>(b) / kSamples;
        wisp += static_cast<double>(w) / kSamples;
    }
    CHECK(std::abs(billow - static_cast<double>(glsl::kDetailMean)) < 0.005);
    CHECK(std::abs(wisp - static_cast<double>(glsl::kDetailMean)) < 0.005);
}

TEST_CASE("Billows are round and wisps are elongated along x") {
    const float distance = 0.02f;
    const double billowX = structure(glsl::billow, kX, distance);
    for (const glm::vec3 axis : {kY, kZ}) {
        CHECK(structure(glsl::billow, axis, distance) / billowX ==
              doctest::Approx(1.0).epsilon(0.2));
    }
    const double wispX = structure(glsl::wisp, kX, distance);
    CHECK(structure(glsl::wisp, kY, distance) > 4.0 * wispX);
    CHECK(structure(glsl::wisp, kZ, distance) > 4.0 * wispX);
}

TEST_CASE("Detail does not change a field at amount 0 and never makes it negative") {
    CHECK(glsl::detailFactor(0.7f, 0.0f) == 1.0f);
    CHECK(glsl::detailFactor(0.0f, 1.0f) == 0.0f);
    CHECK(glsl::detailFactor(0.0f, 5.0f) == 0.0f);
    CHECK(glsl::detailFactor(glsl::kDetailMean, 0.8f) == doctest::Approx(1.0));
}

TEST_CASE("Detail conserves the mean up to amount 1 and adds the stated mass beyond") {
    struct Row {
        float amount;
        double billow, wisp;  // docs/physics.md §8
    };
    for (const Row& row : {Row{0.8f, 1.0, 1.0}, Row{1.0f, 1.0, 1.0}, Row{3.0f, 1.14, 1.53}}) {
        double billow = 0.0, wisp = 0.0;
        for (int i = 0; i < 50000; ++i) {
            const glm::vec3 p = spread(i);
            billow +=
                static_cast<double>(glsl::detailFactor(glsl::billow(p), row.amount)) / 50000.0;
            wisp += static_cast<double>(glsl::detailFactor(glsl::wisp(p), row.amount)) / 50000.0;
        }
        CHECK(billow == doctest::Approx(row.billow).epsilon(0.01));
        CHECK(wisp == doctest::Approx(row.wisp).epsilon(0.01));
    }
}
