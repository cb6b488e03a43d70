// measured_error.cpp: the mean of two halves as the reference, and what its noise may explain.
#include "core/image/measured_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"

namespace neph {
namespace {

constexpr double kShareKnown = 0.1, kLeastKnown = 0.003;
constexpr int kReach = 2;  // pixels around one whose noise is taken together
constexpr int kBlur =
    1;  // of the map: less noise, and an eye finds errors of single pixels nowhere
constexpr double kTellSpread = 5e-4;
constexpr double kDeviations = 2.0;  // that noise may well explain

// What is rare: so many times what is around, and more where that is so in more pixels than a rare
// thing could be; tuned on the storm.
constexpr float kLeastTimes = 2.0f, kMostTimes = 128.0f;
constexpr double kMostRare = 0.01;  // of the pixels of both halves
// Points of relRMSE that a share of the light may be worth, wherever it belongs.
constexpr double kErrorPerSpread = 2.0;

std::size_t pixelAt(glm::ivec2 size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(x);
}

/// Calls `use` with the index of every pixel within `reach` of `at`.
template <typename Use>
void around(glm::ivec2 size, glm::ivec2 at, int reach, Use use) {
    const glm::ivec2 from = glm::max(at - reach, glm::ivec2(0));
    const glm::ivec2 to = glm::min(at + reach, size - 1);
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) use(pixelAt(size, x, y));
    }
}

glm::ivec2 placeOf(const ImageF& image, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(image.size.x);
    return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
}

float brightest(const glm::vec4& colour) {
    return std::max({colour.r, colour.g, colour.b});
}

glm::dvec3 sumOf(const ImageF& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec4& pixel : image.pixels) sum += glm::dvec3(pixel);
    return sum;
}

/// The median around a pixel, which no rare path moves.
float usualAround(const ImageF& image, std::size_t pixel) {
    std::vector<float> values;
    around(image.size, placeOf(image, pixel), kReach,
           [&](std::size_t i) { values.push_back(brightest(image.pixels[i])); });
    return static_cast<float>(quantile(values, 0.5));
}

struct Spread {
    glm::dvec3 light{0.0};
    std::size_t pixels = 0;
};

/// `half` with the light of rare paths, beyond `times` what is around, spread over it; adds to
/// `spread`.
ImageF steadied(const ImageF& half, const ImageF& other, const ImageF& image, float times,
                Spread& spread) {
    const glm::dvec3 whole = sumOf(image);
    const double pixels = static_cast<double>(image.pixels.size());
    const glm::dvec3 level = glm::max(whole, sumOf(half) * 0.5 + sumOf(other) * 0.5) / pixels;
    ImageF steady = half;
    glm::dvec3 taken(0.0);
    for (std::size_t i = 0; i < half.pixels.size(); ++i) {
        float near = 0.0f;
        around(image.size, placeOf(image, i), 1,
               [&](std::size_t beside) { near = std::max(near, brightest(image.pixels[beside])); });
        const float is = brightest(half.pixels[i]);
        const float least =
            times * (near + static_cast<float>(std::max({level.r, level.g, level.b})));
        if (is <= least) continue;
        const float most = least + times * usualAround(other, i);
        if (is <= most) continue;
        const glm::vec3 beyond = glm::vec3(half.pixels[i]) * (1.0f - most / is);
        taken += glm::dvec3(beyond);
        ++spread.pixels;
        steady.pixels[i] -= glm::vec4(beyond, 0.0f);
    }
    spread.light += taken;
    const glm::vec3 share(taken / glm::max(whole, glm::dvec3(1e-30)));
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        steady.pixels[i] += glm::vec4(share * glm::vec3(image.pixels[i]), 0.0f);
    }
    return steady;
}

int pixelsAround(glm::ivec2 size, glm::ivec2 at, int reach) {
    int count = 0;
    around(size, at, reach, [&count](std::size_t) { ++count; });
    return count;
}

/// Each pixel the mean of those within kBlur.
ImageF blurred(const ImageF& image) {
    ImageF mean = image;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        glm::vec4 sum(0.0f);
        around(image.size, placeOf(image, i), kBlur,
               [&](std::size_t beside) { sum += image.pixels[beside]; });
        mean.pixels[i] =
            sum / static_cast<float>(pixelsAround(image.size, placeOf(image, i), kBlur));
    }
    return mean;
}

struct Steady {
    std::array<ImageF, 2> halves;
    double spread = 0.0;  // share of all light
};

/// Sizes must be equal; an image that is black in a colour has nowhere to spread light to.
Steady steadyOf(const ImageF& image, const std::array<ImageF, 2>& halves) {
    checkComparable(image, halves[0]);
    checkComparable(image, halves[1]);
    const glm::dvec3 whole = sumOf(image), one(1.0);
    if (!(std::min({whole.r, whole.g, whole.b}) > 0.0)) return {halves};
    const double all = glm::dot(sumOf(halves[0]) + sumOf(halves[1]), one);
    if (!(all > 0.0)) return {halves};
    for (float times = kLeastTimes; times <= kMostTimes; times *= 2.0f) {
        Spread spread;
        Steady steady;
        steady.halves = {steadied(halves[0], halves[1], image, times, spread),
                         steadied(halves[1], halves[0], image, times, spread)};
        steady.spread = glm::dot(spread.light, one) / all;
        const double pixels = 2.0 * static_cast<double>(image.pixels.size());
        if (static_cast<double>(spread.pixels) <= kMostRare * pixels) return steady;
    }
    return {halves};
}

ImageF meanOf(const std::array<ImageF, 2>& halves) {
    ImageF mean = halves[0];
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        mean.pixels[i] = 0.5f * (halves[0].pixels[i] + halves[1].pixels[i]);
    }
    return mean;
}

/// Decimals that show one digit of a standard error in percent.
int decimalsFor(double sigmaPercent) {
    if (!(sigmaPercent > 0.0)) return 2;
    return std::clamp(-static_cast<int>(std::floor(std::log10(sigmaPercent))), 0, 2);
}

/// Squared standard error of the luminance of the mean of both halves, of each pixel alone.
std::vector<double> noiseOf(const std::array<ImageF, 2>& halves) {
    std::vector<double> noise;
    noise.reserve(halves[0].pixels.size());
    for (std::size_t i = 0; i < halves[0].pixels.size(); ++i) {
        const float apart = luminance(halves[0].pixels[i]) - luminance(halves[1].pixels[i]);
        noise.push_back(0.25 * static_cast<double>(apart) * static_cast<double>(apart));
    }
    return noise;
}

/// The mean over the pixels within kReach.
double meanAround(const std::vector<double>& values, glm::ivec2 size, glm::ivec2 at) {
    double sum = 0.0;
    around(size, at, kReach, [&](std::size_t i) { sum += values[i]; });
    return sum / pixelsAround(size, at, kReach);
}

}  // namespace

MeasuredError measureError(const ImageF& image, const std::array<ImageF, 2>& halves, int paths) {
    const auto errorsFrom = [&image](const std::array<ImageF, 2>& of) {
        const ImageF mean = meanOf(of);
        return imageErrors({image}, {mean, of.data(), &of[1]});
    };
    const Steady steady = steadyOf(image, halves);
    MeasuredError measured{.errors = errorsFrom(steady.halves),
                           .sizePx = image.size,
                           .paths = paths,
                           .spread = steady.spread};
    // Where light belongs that was spread is not known, which its pixels do not show.
    const ImageErrors whole = errorsFrom(halves);
    measured.errors.bias = whole.bias;
    measured.errors.biasSigma = whole.biasSigma;
    measured.errors.relRmseSigma =
        std::hypot(measured.errors.relRmseSigma, kErrorPerSpread * measured.spread);
    return measured;
}

bool isKnownWell(const MeasuredError& measured) {
    const ImageErrors& errors = measured.errors;
    return errors.relRmseSigma <= std::max(kShareKnown * errors.relRmse, kLeastKnown);
}

std::string errorText(const MeasuredError& measured) {
    const ImageErrors& errors = measured.errors;
    const double sigma = 100.0 * errors.relRmseSigma;
    const int decimals = decimalsFor(sigma);
    return fmt::format("{:.{}f} % ± {:.{}f} (bias {:+.{}f} %)", 100.0 * errors.relRmse, decimals,
                       sigma, decimals, 100.0 * errors.bias, decimalsFor(100.0 * errors.biasSigma));
}

std::string meaningOf(const MeasuredError& measured) {
    const std::string spread =
        measured.spread < kTellSpread
            ? std::string()
            : fmt::format("; {:.1f} % of its light, of rare paths, was spread over the image",
                          100.0 * measured.spread);
    return fmt::format(
        "relRMSE of the linear radiance at {} x {} px against {} paths per pixel of the reference, "
        "its noise subtracted; the bias has a standard error of {:.{}f} %{}",
        measured.sizePx.x, measured.sizePx.y, measured.paths, 100.0 * measured.errors.biasSigma,
        decimalsFor(100.0 * measured.errors.biasSigma), spread);
}

std::vector<float> errorsBeyondNoise(const ImageF& image, const std::array<ImageF, 2>& halves) {
    const Steady steady = steadyOf(image, halves);
    const ImageF is = blurred(image), should = blurred(meanOf(steady.halves));
    std::vector<float> errors = relativeErrors(is, should);
    const std::vector<double> noise = noiseOf(steady.halves);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double averaged = pixelsAround(image.size, placeOf(image, i), kBlur);
        const double variance = meanAround(noise, image.size, placeOf(image, i)) / averaged;
        const auto difference = static_cast<double>(luminance(is.pixels[i])) -
                                static_cast<double>(luminance(should.pixels[i]));
        if (difference * difference < kDeviations * kDeviations * variance) errors[i] = 0.0f;
    }
    return errors;
}

}  // namespace neph
