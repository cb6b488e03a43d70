// directions_test.cpp: what the sets integrate exactly, which the scattering relies on: otherwise a
// sweep makes more light than it got.
#include "core/transport/directions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/harmonics.h"

using namespace neph;

namespace {

const glm::dvec3 kTiltedAxis = glm::normalize(glm::dvec3(0.3, -0.5, -0.6));

/// Integral of the product of two harmonics over the sphere, as a set gives it.
double gramOf(const LightDirections& set, std::size_t p, std::size_t q) {
    double sum = 0.0;
    for (const LightDirection& d : set) {
        const Harmonics value = harmonicsAt(d.travel, kTiltedAxis);
        sum += d.weightSr * static_cast<double>(value[p]) * static_cast<double>(value[q]);
    }
    return sum;
}

double totalWeightSr(const LightDirections& set) {
    double sum = 0.0;
    for (const LightDirection& d : set) {
        CHECK(glm::length(d.travel) == doctest::Approx(1.0));
        sum += d.weightSr;
    }
    return sum;
}

}  // namespace

TEST_CASE("transport: a turned icosahedron integrates products of harmonics to l = 2") {
    DirectionSource source(3);
    for (int turn = 0; turn < 3; ++turn) {
        const LightDirections set = source.turnedIcosahedron();
        CHECK(set.size() == 12);
        CHECK(totalWeightSr(set) == doctest::Approx(4.0 * std::numbers::pi));
        for (std::size_t p = 0; p < kBroadMoments; ++p) {
            for (std::size_t q = 0; q < kBroadMoments; ++q) {
                CHECK(std::abs(gramOf(set, p, q) - (p == q ? 1.0 : 0.0)) < 1e-6);
            }
        }
    }
}

TEST_CASE("transport: rings about the sun integrate products of zonal harmonics to l = 8") {
    DirectionSource source(3);
    for (int turn = 0; turn < 5; ++turn) {
        const LightDirections set = source.rings(kTiltedAxis);
        CHECK(totalWeightSr(set) == doctest::Approx(4.0 * std::numbers::pi));
        for (std::size_t p = kBroadMoments; p < kAlignedMoments; ++p) {
            // With 8 rings products of l = 8 and 8 are one degree too many.
            for (std::size_t q = 0; q < kAlignedMoments; ++q) {
                if (p == kAlignedMoments - 1 && q == p && turn % 4 == 0) continue;
                if (q >= 1 && q < kBroadMoments) continue;  // not zonal
                CHECK(std::abs(gramOf(set, p, q) - (p == q ? 1.0 : 0.0)) < 1e-5);
            }
        }
    }
}

TEST_CASE("transport: a set of directions is never drawn twice") {
    DirectionSource source(3), same(3), other(4);
    const LightDirections first = source.turnedIcosahedron();
    CHECK(first.front().travel == same.turnedIcosahedron().front().travel);
    CHECK(first.front().travel != source.turnedIcosahedron().front().travel);
    CHECK(first.front().travel != other.turnedIcosahedron().front().travel);
}

TEST_CASE("transport: the opposite of each direction is in its set") {
    DirectionSource source(5);
    for (int turn = 0; turn < 5; ++turn) {
        for (const LightDirections& set : {source.turnedIcosahedron(), source.rings(kTiltedAxis)}) {
            for (const LightDirection& d : set) {
                CHECK(std::ranges::any_of(set, [&](const LightDirection& other) {
                    return glm::length(other.travel + d.travel) < 1e-9 &&
                           std::abs(other.weightSr - d.weightSr) < 1e-9;
                }));
            }
        }
    }
}
