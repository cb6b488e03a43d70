// directions.cpp: an icosahedron and rings.
#include "core/transport/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace neph {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

struct GaussPoint {
    double x = 0.0, weight = 0.0;
};

/// Newton's method on P_n, whose derivative follows from P_(n-1).
GaussPoint gaussPoint(int n, int i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int round = 0; round < 50; ++round) {
        double before = 1.0, value = x;
        for (int l = 2; l <= n; ++l) {
            const double next = ((2 * l - 1) * x * value - (l - 1) * before) / l;
            before = value;
            value = next;
        }
        slope = n * (x * value - before) / (x * x - 1.0);
        x -= value / slope;
    }
    return {x, 2.0 / ((1.0 - x * x) * slope * slope)};
}

/// A turn about an axis through an angle, both such that all orientations are equally likely.
glm::dmat3 turnOf(double u, double v, double w) {
    const double a = std::sqrt(1.0 - u), b = std::sqrt(u);
    const double x = a * std::sin(kTau * v), y = a * std::cos(kTau * v);
    const double z = b * std::sin(kTau * w), s = b * std::cos(kTau * w);
    return {1 - 2 * (y * y + z * z), 2 * (x * y + z * s),     2 * (x * z - y * s),
            2 * (x * y - z * s),     1 - 2 * (x * x + z * z), 2 * (y * z + x * s),
            2 * (x * z + y * s),     2 * (y * z - x * s),     1 - 2 * (x * x + y * y)};
}

}  // namespace

DirectionSource::DirectionSource(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (double& start : starts_) start = static_cast<double>(random() >> 11U) * 0x1p-53;
}

double DirectionSource::spread(std::size_t i, double step) const {
    return std::fmod(starts_[i] + turn_ * step, 1.0);
}

LightDirections DirectionSource::turnedIcosahedron() {
    // Powers of the inverse of the root of x^4 = x + 1. [Roberts18]
    constexpr double kStep = 0.8191725133961645;
    ++turn_;
    const glm::dmat3 turn =
        turnOf(spread(0, kStep), spread(1, kStep * kStep), spread(2, kStep * kStep * kStep));
    LightDirections set;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 at(0.0);
            at[(axis + 1) % 3] = (corner & 1) != 0 ? 1.0 : -1.0;
            at[(axis + 2) % 3] = (corner & 2) != 0 ? std::numbers::phi : -std::numbers::phi;
            set.push_back({turn * glm::normalize(at), 2.0 * kTau / 12.0});
        }
    }
    return set;
}

LightDirections DirectionSource::rings(const glm::dvec3& axis) {
    constexpr int kFewestRings = 8, kRingChoices = 4, kFewestAzimuths = 3;
    constexpr double kAzimuthsAtEquator = 5.0;
    const glm::dvec3 other =
        std::abs(axis.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, axis)), v = glm::cross(axis, u);
    const int count = kFewestRings + turn_++ % kRingChoices;
    static_assert((kFewestRings + kRingChoices) / 2 <= kMostStarts);
    LightDirections set;
    for (int i = 0; i < (count + 1) / 2; ++i) {
        const GaussPoint ring = gaussPoint(count, i);
        const double radius = std::sqrt(1.0 - ring.x * ring.x);
        const double first = spread(static_cast<std::size_t>(i), std::numbers::phi);
        const bool equator = 2 * i + 1 == count;
        int azimuths =
            std::max(kFewestAzimuths, static_cast<int>(std::lround(kAzimuthsAtEquator * radius)));
        if (equator && azimuths % 2 != 0) ++azimuths;
        for (int j = 0; j < azimuths; ++j) {
            const double angle = kTau * (j + first) / azimuths;
            const glm::dvec3 across = u * std::cos(angle) + v * std::sin(angle);
            const glm::dvec3 travel = axis * ring.x + across * radius;
            const double weightSr = ring.weight * kTau / azimuths;
            set.push_back({travel, weightSr});
            if (!equator) set.push_back({-travel, weightSr});
        }
    }
    return set;
}

}  // namespace neph
