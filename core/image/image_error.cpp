// image_error.cpp: sums over the pixels, in double precision.
//
// With halves, (I_A - R_A)(I_B - R_B) and (I_A - R_B)(I_B - R_A) have the squared true difference
// as their expectation, because the four errors are independent. The code sums the mean of the two:
// the squared difference of the means minus a quarter of the squared differences between halves,
// which is the noise. An image without halves is used as both of its halves.
#include "core/image/image_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/quantile.h"

namespace neph {
namespace {

constexpr double kFloorShare = 0.01;  // of the mean or the maximum of R; below it R counts as dark
constexpr double kQuantile = 0.95;
constexpr int kColours = 3;

/// A single NaN would make every sum NaN, so the pixel is named instead.
void checkFinite(const ImageF& image, const char* name) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec4& pixel = image.pixels[i];
        if (std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b)) continue;
        const auto width = static_cast<std::size_t>(image.size.x);
        throw Error({.what = fmt::format("{} has a value that is no finite number", name),
                     .found = fmt::format("{}, {}, {} in column {}, row {} from the top", pixel.r,
                                          pixel.g, pixel.b, i % width, i / width),
                     .expected = "finite red, green and blue"});
    }
}

void checkHalves(const SampledImage& sampled, const char* name) {
    if (!sampled.halved()) return;
    for (const ImageF* half : {sampled.halfA, sampled.halfB}) {
        if (half->size != sampled.image.size) {
            throw Error(
                {.what = fmt::format("{} and its halves differ in size", name),
                 .found = fmt::format("{}x{}", half->size.x, half->size.y),
                 .expected = fmt::format("{}x{}", sampled.image.size.x, sampled.image.size.y)});
        }
        checkFinite(*half, name);
    }
}

/// Sums over all pixels.
struct Sums {
    double difference = 0.0;     // I-R
    double reference = 0.0;      // R
    double squared = 0.0;        // (I-R)², noise subtracted
    double noise = 0.0;          // noise that was subtracted
    double squaredVariance = 0;  // of `squared`
    double biasVariance = 0.0;   // of `difference`
};

/// The channels of a pixel come from the same paths, so their errors are added before they are
/// squared.
void add(Sums& sums, const SampledImage& image, const SampledImage& reference, std::size_t i) {
    const auto half = [i](const SampledImage& of, const ImageF* which) {
        return glm::dvec3((of.halved() ? *which : of.image).pixels[i]);
    };
    const glm::dvec3 a = half(image, image.halfA), b = half(image, image.halfB);
    const glm::dvec3 refA = half(reference, reference.halfA),
                     refB = half(reference, reference.halfB);
    const glm::dvec3 middle = 0.5 * ((a + b) - (refA + refB));
    const glm::dvec3 apart = 0.5 * (a - b), refApart = 0.5 * (refA - refB);
    const glm::dvec3 one(1.0);
    const glm::dvec3 whole(reference.image.pixels[i]);
    sums.difference += glm::dot(glm::dvec3(image.image.pixels[i]) - whole, one);
    sums.reference += glm::dot(whole, one);
    const double noise = glm::dot(apart, apart) + glm::dot(refApart, refApart);
    sums.squared += glm::dot(middle, middle) - noise;
    sums.noise += noise;
    const double along = glm::dot(middle, apart), refAlong = glm::dot(middle, refApart);
    sums.squaredVariance += 4.0 * (along * along + refAlong * refAlong);
    const double total = glm::dot(apart, one), refTotal = glm::dot(refApart, one);
    sums.biasVariance += total * total + refTotal * refTotal;
}

/// Mean of squared difference over squared reference, per channel; the floor keeps dark pixels from
/// dominating.
double relativeMse(const ImageF& image, const ImageF& reference, double meanReference) {
    const double floor = kFloorShare * meanReference;
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int c = 0; c < kColours; ++c) {
            const double is = static_cast<double>(image.pixels[i][c]);
            const double should = static_cast<double>(reference.pixels[i][c]);
            sum += (is - should) * (is - should) / (should * should + floor * floor);
        }
    }
    return sum / (kColours * static_cast<double>(image.pixels.size()));
}

/// Largest luminance; 0 for an image that is black everywhere.
float brightest(const ImageF& image) {
    float most = 0.0f;
    for (const glm::vec4& pixel : image.pixels) most = std::max(most, luminance(pixel));
    return most;
}

[[noreturn]] void refuseBlack() {
    throw Error({.what = "the reference is black: errors relative to it are not defined",
                 .expected = "a reference with some light"});
}

/// Relative errors of dark pixels are noise, so only brighter ones count.
double relativeP95(const ImageF& image, const ImageF& reference) {
    const float floor = static_cast<float>(kFloorShare) * brightest(reference);
    std::vector<float> errors;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float should = luminance(reference.pixels[i]);
        if (should > floor) {
            errors.push_back(std::abs(luminance(image.pixels[i]) - should) / should);
        }
    }
    return errors.empty() ? 0.0 : quantile(errors, kQuantile);
}

}  // namespace

float luminance(const glm::vec4& colour) {
    return 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
}

void checkComparable(const ImageF& image, const ImageF& reference) {
    if (image.size != reference.size) {
        throw Error({.what = "the images differ in size",
                     .found = fmt::format("{}x{} and {}x{}", image.size.x, image.size.y,
                                          reference.size.x, reference.size.y),
                     .expected = "the same view at the same size",
                     .hint = "render one of them again with --size"});
    }
    if (image.pixels.empty()) throw Error({.what = "the images have no pixels"});
    checkFinite(image, "the image");
    checkFinite(reference, "the reference");
}

ImageErrors imageErrors(const SampledImage& image, const SampledImage& reference) {
    checkComparable(image.image, reference.image);
    checkHalves(image, "the image");
    checkHalves(reference, "the reference");
    Sums sums;
    const std::size_t pixels = image.image.pixels.size();
    for (std::size_t i = 0; i < pixels; ++i) add(sums, image, reference, i);
    if (!(sums.reference > 0.0)) refuseBlack();
    const double count = kColours * static_cast<double>(pixels);
    const double mean = sums.reference / count;
    const double mse = sums.squared / count, noise = sums.noise / count;
    const double sigma = std::sqrt(sums.squaredVariance) / count;
    ImageErrors errors;
    errors.bias = sums.difference / sums.reference;
    errors.biasSigma = std::sqrt(sums.biasVariance) / sums.reference;
    errors.relRmse = std::sqrt(std::max(mse, 0.0)) / mean;
    errors.relRmseRaw = std::sqrt(std::max(mse + noise, 0.0)) / mean;
    errors.noise = std::sqrt(noise) / mean;
    errors.relRmseSigma = std::sqrt(std::max(mse, 0.0) + sigma) / mean - errors.relRmse;
    errors.relMse = relativeMse(image.image, reference.image, mean);
    errors.p95 = relativeP95(image.image, reference.image);
    return errors;
}

std::vector<float> relativeErrors(const ImageF& image, const ImageF& reference) {
    checkComparable(image, reference);
    const float floor = static_cast<float>(kFloorShare) * brightest(reference);
    if (!(floor > 0.0f)) refuseBlack();
    std::vector<float> errors(image.pixels.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float should = luminance(reference.pixels[i]);
        errors[i] = (luminance(image.pixels[i]) - should) / std::max(should, floor);
    }
    return errors;
}

}  // namespace neph
