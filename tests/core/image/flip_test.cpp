// flip_test.cpp: FLIP against the papers' formulae written out plainly, and values they imply.
//
// [Andersson20], [Andersson21]: double precision, filters in two dimensions, no short cuts.
#include "core/image/flip.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/base/error.h"

using namespace neph;

namespace {

constexpr double kPi = 3.14159265358979323846;

ImageF uniform(const glm::vec3& colour, glm::ivec2 size = {12, 9}) {
    ImageF image;
    image.size = size;
    image.pixels.assign(static_cast<std::size_t>(size.x * size.y), glm::vec4(colour, 1.0f));
    return image;
}

/// Taller than a band of the implementation, with edges, points and colours.
ImageF patterned(unsigned seed, float most = 1.0f) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, most);
    ImageF image = uniform(glm::vec3(0.3f), {22, 45});
    for (int i = 0; i < 60; ++i) {
        const glm::ivec2 from(random() % 22, random() % 45), size(random() % 9, random() % 9);
        const glm::vec4 colour(value(random), value(random), value(random), 1.0f);
        for (int y = from.y; y < std::min(from.y + size.y, 45); ++y) {
            for (int x = from.x; x < std::min(from.x + size.x, 22); ++x) {
                image.pixels[static_cast<std::size_t>(y * 22 + x)] = colour;
            }
        }
    }
    return image;
}

/// One number per pixel, repeated beyond the border.
struct Plane {
    glm::ivec2 size;
    std::vector<double> values;
    double at(int x, int y) const {
        return values[static_cast<std::size_t>(glm::clamp(y, 0, size.y - 1) * size.x +
                                               glm::clamp(x, 0, size.x - 1))];
    }
};

using Weight = std::function<double(int x, int y)>;

/// Positive weights are scaled to sum to 1, negative ones to -1.
Plane convolve(const Plane& plane, int radius, const Weight& weight) {
    double up = 0.0, down = 0.0;
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            (weight(x, y) > 0.0 ? up : down) += std::abs(weight(x, y));
        }
    }
    Plane result{plane.size, std::vector<double>(plane.values.size(), 0.0)};
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            const double w = weight(x, y) / (weight(x, y) > 0.0 ? up : down == 0.0 ? 1.0 : down);
            for (int j = 0; j < plane.size.y; ++j) {
                for (int i = 0; i < plane.size.x; ++i) {
                    result.values[static_cast<std::size_t>(j * plane.size.x + i)] +=
                        w * plane.at(i + x, j + y);
                }
            }
        }
    }
    return result;
}

glm::dvec3 xyzOf(const glm::dvec3& rgb) {
    // IEC 61966-2-1
    return {0.4124 * rgb.r + 0.3576 * rgb.g + 0.1805 * rgb.b,
            0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b,
            0.0193 * rgb.r + 0.1192 * rgb.g + 0.9505 * rgb.b};
}
const glm::dvec3 kWhite(0.9505, 1.0, 1.0890);

glm::dvec3 huntLab(const glm::dvec3& rgb) {
    const glm::dvec3 share = xyzOf(rgb) / kWhite;
    const auto f = [](double t) {
        return t > std::pow(6.0 / 29.0, 3) ? std::cbrt(t)
                                           : t * std::pow(29.0 / 6.0, 2) / 3.0 + 4.0 / 29.0;
    };
    const double lightness = 116.0 * f(share.y) - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f(share.x) - f(share.y)),
            0.01 * lightness * 200.0 * (f(share.y) - f(share.z))};
}

double distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

double redistributed(double distance07) {
    const double most = distance(huntLab({0.0, 1.0, 0.0}), huntLab({0.0, 0.0, 1.0}));
    const double knee = 0.4 * most;
    if (distance07 < knee) return 0.95 / knee * distance07;
    return 0.95 + 0.05 * (distance07 - knee) / (most - knee);
}

struct Seen {
    std::vector<glm::dvec3> lab;
    std::vector<double> edge, point;
};

Seen see(const ImageF& image, double ppd) {
    Plane y{image.size, {}}, cx = y, cz = y;
    for (const glm::vec4& pixel : image.pixels) {
        const glm::dvec3 share = xyzOf(glm::clamp(glm::dvec3(pixel), 0.0, 1.0)) / kWhite;
        y.values.push_back(116.0 * share.y - 16.0);
        cx.values.push_back(500.0 * (share.x - share.y));
        cz.values.push_back(200.0 * (share.y - share.z));
    }
    const auto sensitivity = [&](double a1, double b1, double a2, double b2) {
        return [=](int i, int j) {
            const double d2 = (i * i + j * j) / (ppd * ppd);
            return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
                   a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
        };
    };
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * ppd));
    const Plane fy = convolve(y, radius, sensitivity(1.0, 0.0047, 0.0, 1e-5));
    const Plane fx = convolve(cx, radius, sensitivity(1.0, 0.0053, 0.0, 1e-5));
    const Plane fz = convolve(cz, radius, sensitivity(34.1, 0.04, 13.5, 0.025));
    Seen seen;
    const glm::dmat3 rgbFromXyz = glm::inverse(
        glm::dmat3(xyzOf({1.0, 0.0, 0.0}), xyzOf({0.0, 1.0, 0.0}), xyzOf({0.0, 0.0, 1.0})));
    for (std::size_t i = 0; i < fy.values.size(); ++i) {
        const double sy = (fy.values[i] + 16.0) / 116.0;
        const glm::dvec3 xyz =
            kWhite * glm::dvec3(sy + fx.values[i] / 500.0, sy, sy - fz.values[i] / 200.0);
        seen.lab.push_back(huntLab(glm::clamp(rgbFromXyz * xyz, 0.0, 1.0)));
    }
    for (double& value : y.values) value = (value + 16.0) / 116.0;
    const double sd = 0.5 * 0.082 * ppd;
    const int reach = static_cast<int>(std::ceil(3.0 * sd));
    const auto g = [&](int i, int j) { return std::exp(-(i * i + j * j) / (2.0 * sd * sd)); };
    const Plane ex = convolve(y, reach, [&](int i, int j) { return -i * g(i, j); });
    const Plane ey = convolve(y, reach, [&](int i, int j) { return -j * g(i, j); });
    const Plane px =
        convolve(y, reach, [&](int i, int j) { return (i * i / (sd * sd) - 1.0) * g(i, j); });
    const Plane py =
        convolve(y, reach, [&](int i, int j) { return (j * j / (sd * sd) - 1.0) * g(i, j); });
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        seen.edge.push_back(std::hypot(ex.values[i], ey.values[i]));
        seen.point.push_back(std::hypot(px.values[i], py.values[i]));
    }
    return seen;
}

std::vector<double> plainFlip(const ImageF& a, const ImageF& b, double ppd) {
    const Seen one = see(a, ppd), other = see(b, ppd);
    std::vector<double> errors;
    for (std::size_t i = 0; i < one.lab.size(); ++i) {
        const double colour = redistributed(distance(one.lab[i], other.lab[i]));
        const double feature = std::max(std::abs(one.edge[i] - other.edge[i]),
                                        std::abs(one.point[i] - other.point[i]));
        errors.push_back(std::pow(colour, 1.0 - std::sqrt(feature / std::sqrt(2.0))));
    }
    return errors;
}

double largestGap(const FlipMap& map, const std::vector<double>& plain) {
    REQUIRE(map.errors.size() == plain.size());
    double gap = 0.0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        gap = std::max(gap, std::abs(static_cast<double>(map.errors[i]) - plain[i]));
    }
    return gap;
}

}  // namespace

TEST_CASE("An observer before the standard screen has 67 pixels a degree") {
    CHECK(kFlipPixelsPerDegree == doctest::Approx(67.02).epsilon(1e-4));  // [Andersson20]
}

TEST_CASE("FLIP is what the paper's formulae give, pixel by pixel, near and far") {
    // The matrix written out in IEC 61966-2-1 has four digits.
    const ImageF a = patterned(1), b = patterned(2);
    for (const double ppd : {kFlipPixelsPerDegree, 20.0}) {
        CAPTURE(ppd);
        CHECK(largestGap(ldrFlip(a, b, ppd), plainFlip(a, b, ppd)) < 1e-3);
    }
    ImageF touched = a;
    touched.pixels[22 * 31 + 11] = glm::vec4(1.0f);
    CHECK(largestGap(ldrFlip(touched, a), plainFlip(touched, a, kFlipPixelsPerDegree)) < 1e-3);
}

TEST_CASE("Large patches have the errors that colour alone gives") {
    const auto error = [](const glm::vec3& a, const glm::vec3& b) {
        return ldrFlip(uniform(a), uniform(b)).mean();
    };
    // Green and blue are what the scale ends with: 203.3 apart, to the power 0.7 41.28.
    CHECK(error({0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}) == doctest::Approx(1.0).epsilon(1e-5));
    // Black and white: L* differs by 100; 0.95 + 0.05 (100^0.7 - 16.51) / (41.28 - 16.51).
    CHECK(error(glm::vec3(0.0f), glm::vec3(1.0f)) == doctest::Approx(0.96738).epsilon(1e-4));
    // Greys of 18 % and 20 %: L* 49.496 and 51.837 (CIE 15); 0.95 · 2.341^0.7 / 16.51.
    CHECK(error(glm::vec3(0.18f), glm::vec3(0.20f)) == doctest::Approx(0.10438).epsilon(1e-3));
}

TEST_CASE("FLIP of two images is between 0 and 1, the same either way, and 0 for one image") {
    const ImageF a = patterned(3), b = patterned(4);
    const FlipMap forth = ldrFlip(a, b), back = ldrFlip(b, a);
    CHECK(forth.errors == back.errors);
    for (const float error : forth.errors) CHECK((error >= 0.0f && error <= 1.0f));
    CHECK(forth.mean() > 0.05);
    CHECK(forth.p95() >= forth.mean());
    CHECK(ldrFlip(a, a).p95() == 0.0);
    CHECK(hdrFlip(a, a, flipExposures(a)).p95() == 0.0);
}

TEST_CASE("A point is seen better than the same change of a colour on its own") {
    const ImageF plain = uniform(glm::vec3(0.2f), {41, 41});
    ImageF point = plain;
    point.pixels[41 * 20 + 20] = glm::vec4(glm::vec3(0.6f), 1.0f);
    const FlipMap map = ldrFlip(point, plain);
    CHECK(map.errors[41 * 20 + 20] > 0.05f);
    CHECK(map.errors[0] == 0.0f);  // beyond the reach of all filters
}

TEST_CASE("Exposures go from where the brightest to where the median comes to 0.85 of white") {
    // Solved by hand for the fit of ACES without its pre-exposure: 2.1189 comes to 0.85.
    ImageF image = uniform(glm::vec3(1.0f), {3, 1});
    image.pixels[1] = glm::vec4(8.0f);
    const FlipExposures exposures = flipExposures(image);
    CHECK(exposures.start == doctest::Approx(std::log2(2.1189 / 8.0)).epsilon(1e-4));
    CHECK(exposures.stop == doctest::Approx(std::log2(2.1189)).epsilon(1e-4));
    CHECK(exposures.count == 3);
    // The authors' own test image: -12.5423 to 0.9427 EV in 14 exposures.
    image.pixels[0] = image.pixels[2] = glm::vec4(2.1189f * std::exp2(-0.9427f));
    image.pixels[1] = glm::vec4(2.1189f * std::exp2(12.5423f));
    CHECK(flipExposures(image).count == 14);
    CHECK(flipExposures(uniform(glm::vec3(0.5f))).count == 2);
    CHECK_THROWS_WITH_AS(flipExposures(uniform(glm::vec3(0.0f))), doctest::Contains("black"),
                         Error);
    ImageF night = uniform(glm::vec3(0.0f), {5, 1});
    night.pixels[0] = glm::vec4(1.0f);
    CHECK(std::isfinite(flipExposures(night).stop));
}

TEST_CASE("HDR-FLIP is the largest LDR-FLIP of the tone-mapped exposures") {
    const ImageF a = patterned(5, 20.0f), b = patterned(6, 20.0f);
    const FlipExposures exposures = flipExposures(b);
    REQUIRE(exposures.count >= 2);
    const auto toned = [](ImageF image, double ev) {
        for (glm::vec4& pixel : image.pixels) {
            for (int c = 0; c < 3; ++c) {
                const double x = 0.6 * std::exp2(ev) * static_cast<double>(pixel[c]);
                pixel[c] = static_cast<float>(std::min(
                    1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)));  // [Narkowicz15]
            }
        }
        return image;
    };
    std::vector<double> largest(a.pixels.size(), 0.0);
    for (int i = 0; i < exposures.count; ++i) {
        const double ev =
            exposures.start + (exposures.stop - exposures.start) * i / (exposures.count - 1);
        const FlipMap map = ldrFlip(toned(a, ev), toned(b, ev));
        for (std::size_t p = 0; p < largest.size(); ++p) {
            largest[p] = std::max(largest[p], static_cast<double>(map.errors[p]));
        }
    }
    CHECK(largestGap(hdrFlip(a, b, exposures), largest) < 1e-4);
}

TEST_CASE("FLIP refuses what cannot be compared, takes any light and can be cancelled") {
    CHECK_THROWS_AS(ldrFlip(uniform(glm::vec3(0.0f), {3, 3}), uniform(glm::vec3(0.0f), {3, 4})),
                    Error);
    CHECK_THROWS_AS(ldrFlip(uniform(glm::vec3(NAN)), uniform(glm::vec3(0.0f))), Error);
    const ImageF bright = uniform(glm::vec3(1e30f)), dim = uniform(glm::vec3(-1.0f, 1e-30f, 1.0f));
    CHECK(hdrFlip(bright, dim, flipExposures(dim)).mean() <= 1.0);
    CHECK_THROWS_AS(ldrFlip(bright, dim, kFlipPixelsPerDegree, [](double) { return false; }),
                    Cancelled);
}
