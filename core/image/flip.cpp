// flip.cpp: opponent colours, filtered like the eye does; then differences of colour and of
// features.
//
// Colours are X, Y and Z relative to white. From them come the opponent channels of [Andersson20]
// without their scale factors, which have no effect here: the filters are linear and their weights
// sum to 1. All filters are separable into one along rows and one along columns. Beyond the border
// an image continues as its last pixel. The work is done in bands of rows.
#include "core/image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/image/image_error.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBandRows = 32;
constexpr float kBrightest = 1e6f;  // white after tone mapping, without overflow inside it
// [Andersson21] removes the pre-exposure of the ACES fit.
constexpr float kAcesGain = 0.6f;
constexpr double kWhiteShare = 0.85;  // [Andersson21]: where the extreme luminances are mapped to

// Contrast sensitivity as sums of Gaussians, amplitude and scale in degrees². [Andersson20]
struct Gaussian {
    double amplitude, scale;
};
constexpr Gaussian kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
constexpr std::array<Gaussian, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kSupport = 3.0;         // filter radius, in standard deviations of the widest
constexpr double kFeatureWidth = 0.082;  // degrees from peak to trough. [Andersson20]
// Exponents and the knee of the redistributed colour error. [Andersson20]
constexpr float kColourExponent = 0.7f, kKneeAt = 0.4f, kKneeError = 0.95f;

/// A filter along a line, of 2 radius + 1 weights.
using Kernel = std::vector<float>;

Kernel toKernel(const std::vector<double>& weights, double scale) {
    Kernel kernel;
    for (const double weight : weights) kernel.push_back(static_cast<float>(weight * scale));
    return kernel;
}

/// exp(-x²/width²) from -radius to radius, 0 beyond `reach`.
std::vector<double> bell(int radius, int reach, double width) {
    std::vector<double> weights;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::abs(x) > reach ? 0.0 : std::exp(-x * x / (width * width)));
    }
    return weights;
}

double sumOf(const std::vector<double>& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// Scales positive weights to sum to 1 and negative ones to sum to -1.
Kernel balanced(std::vector<double> weights) {
    double up = 0.0, down = 0.0;
    for (const double weight : weights) (weight > 0.0 ? up : down) += std::abs(weight);
    for (double& weight : weights) weight /= weight > 0.0 ? up : down;
    return toKernel(weights, 1.0);
}

/// Everything that depends only on the pixels per degree.
struct Filters {
    explicit Filters(double pixelsPerDegree);

    int radius = 0;
    Kernel achromatic, redGreen;
    std::array<Kernel, 2> blueYellow;
    std::array<float, 2> share{};  // weight of each Gaussian in the sum
    Kernel smooth, edge, point;
};

Filters::Filters(double pixelsPerDegree) {
    // exp(-π²d²/scale) with d in degrees has the standard deviation √(scale/2)/π.
    const auto width = [&](const Gaussian& of) {
        return std::sqrt(of.scale) / kPi * pixelsPerDegree;
    };
    const auto reach = [](double deviation) {
        return static_cast<int>(std::ceil(kSupport * deviation));
    };
    radius = reach(width(kBlueYellow[0]) / std::numbers::sqrt2);
    const auto normal = [&](const Gaussian& of) { return bell(radius, radius, width(of)); };
    const auto normalised = [](const std::vector<double>& weights) {
        return toKernel(weights, 1.0 / sumOf(weights));
    };
    achromatic = normalised(normal(kAchromatic));
    redGreen = normalised(normal(kRedGreen));
    std::array<double, 2> mass{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<double> weights = normal(kBlueYellow[i]);
        blueYellow[i] = normalised(weights);
        mass[i] = kBlueYellow[i].amplitude * std::sqrt(kPi / kBlueYellow[i].scale) *
                  sumOf(weights) * sumOf(weights);
    }
    for (std::size_t i = 0; i < 2; ++i)
        share[i] = static_cast<float>(mass[i] / (mass[0] + mass[1]));

    const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
    const std::vector<double> g = bell(radius, reach(deviation), deviation * std::numbers::sqrt2);
    std::vector<double> first, second;
    for (int x = -radius; x <= radius; ++x) {
        const double weight = g[static_cast<std::size_t>(x + radius)];
        first.push_back(-x * weight);
        second.push_back((x * x / (deviation * deviation) - 1.0) * weight);
    }
    smooth = normalised(g);
    edge = balanced(first);
    point = balanced(second);
}

/// Matrix from linear RGB to X, Y and Z relative to white, from the chromaticities of [BT709].
glm::mat3 whiteShareFromRgb() {
    const auto colour = [](double x, double y) {
        return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y);
    };
    const glm::dmat3 primaries(colour(0.64, 0.33), colour(0.30, 0.60), colour(0.15, 0.06));
    const glm::dvec3 white = colour(0.3127, 0.3290);
    glm::dmat3 shares(0.0);
    const glm::dvec3 amounts = glm::inverse(primaries) * white;
    for (int c = 0; c < 3; ++c) shares[c] = primaries[c] * amounts[c] / white;
    return shares;
}

const glm::mat3 kSharesFromRgb = whiteShareFromRgb();
const glm::mat3 kRgbFromShares = glm::inverse(kSharesFromRgb);

/// How an image is displayed: clipped, or tone mapped after `gain`.
struct Showing {
    bool toned = false;
    float gain = 1.0f;
};

/// The colour on screen of a pixel: linear, in [0, 1].
glm::vec3 shown(const glm::vec4& pixel, const Showing& showing) {
    const glm::vec3 colour(pixel);
    if (!showing.toned) return glm::clamp(colour, 0.0f, 1.0f);
    return glsl::filmic(kAcesGain * glm::clamp(colour * showing.gain, 0.0f, kBrightest));
}

/// Rows of one opponent channel, padded by `radius` pixels on each side.
struct Padded {
    int width = 0, rows = 0;  // without the padding
    int radius = 0;
    std::vector<float> values;
    std::size_t stride() const { return static_cast<std::size_t>(width + 2 * radius); }
    float* row(int y) { return values.data() + static_cast<std::size_t>(y + radius) * stride(); }
    const float* row(int y) const {
        return values.data() + static_cast<std::size_t>(y + radius) * stride();
    }
};

/// Achromatic, red-green and blue-yellow channels of `rows` rows, starting at `first`.
std::array<Padded, 3> opponents(const ImageF& image, const Showing& showing, int first, int rows,
                                int radius) {
    std::array<Padded, 3> channels;
    for (Padded& channel : channels) {
        channel = {image.size.x, rows, radius, {}};
        channel.values.resize(channel.stride() * static_cast<std::size_t>(rows + 2 * radius));
    }
    for (int y = -radius; y < rows + radius; ++y) {
        const int from = std::clamp(first + y, 0, image.size.y - 1);
        const glm::vec4* pixels =
            image.pixels.data() + static_cast<std::ptrdiff_t>(from) * image.size.x;
        for (int x = 0; x < image.size.x; ++x) {
            const glm::vec3 shares = kSharesFromRgb * shown(pixels[x], showing);
            channels[0].row(y)[radius + x] = shares.y;
            channels[1].row(y)[radius + x] = shares.x - shares.y;
            channels[2].row(y)[radius + x] = shares.y - shares.z;
        }
        for (Padded& channel : channels) {
            float* row = channel.row(y);
            std::fill_n(row, radius, row[radius]);
            std::fill_n(row + radius + image.size.x, radius, row[radius + image.size.x - 1]);
        }
    }
    return channels;
}

/// A loop that compilers vectorise; filtering takes most of the time.
void addScaled(const float* from, float weight, int count, float* to) {
    for (int i = 0; i < count; ++i) to[i] += weight * from[i];
}

/// Filters along rows, then along columns.
std::vector<float> filtered(const Padded& channel, const Kernel& across, const Kernel& down) {
    const int radius = channel.radius, width = channel.width;
    const auto stride = static_cast<std::size_t>(width);
    std::vector<float> lines(stride * static_cast<std::size_t>(channel.rows + 2 * radius), 0.0f);
    for (int y = 0; y < channel.rows + 2 * radius; ++y) {
        float* line = lines.data() + static_cast<std::size_t>(y) * stride;
        for (std::size_t t = 0; t < across.size(); ++t) {
            addScaled(channel.row(y - radius) + t, across[t], width, line);
        }
    }
    std::vector<float> result(stride * static_cast<std::size_t>(channel.rows), 0.0f);
    for (std::size_t y = 0; y < static_cast<std::size_t>(channel.rows); ++y) {
        for (std::size_t t = 0; t < down.size(); ++t) {
            addScaled(lines.data() + (y + t) * stride, down[t], width, result.data() + y * stride);
        }
    }
    return result;
}

/// CIE L*a*b* of linear RGB within [0, 1]; a* and b* are reduced in the dark, after Hunt.
/// [Andersson20]
glm::vec3 perceived(const glm::vec3& rgb) {
    constexpr float kDelta = 6.0f / 29.0f;
    const glm::vec3 shares = kSharesFromRgb * rgb;
    glm::vec3 f(0.0f);
    for (int c = 0; c < 3; ++c) {
        f[c] = shares[c] > kDelta * kDelta * kDelta
                   ? std::cbrt(shares[c])
                   : shares[c] / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
    }
    const float lightness = 116.0f * f.y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (f.x - f.y),
            0.01f * lightness * 200.0f * (f.y - f.z)};
}

/// HyAB distance [Abasi20], to the power of [Andersson20].
float colourDistance(const glm::vec3& a, const glm::vec3& b) {
    const float hyab = std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
    return std::pow(hyab, kColourExponent);
}

/// A band of one image as the eye perceives it: filtered colours, edges and points.
struct Seen {
    std::vector<glm::vec3> colour;
    std::vector<float> edge, point;
};

/// Magnitude of a gradient from its two components.
std::vector<float> lengths(const std::vector<float>& x, const std::vector<float>& y) {
    std::vector<float> length(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) length[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
    return length;
}

/// Applies all filters to one band of rows. Bands limit memory and are the pieces of work for
/// threads.
Seen see(const ImageF& image, const Showing& showing, int first, int rows, const Filters& by) {
    const std::array<Padded, 3> channels = opponents(image, showing, first, rows, by.radius);
    const Padded &light = channels[0], &blueYellow = channels[2];
    const std::vector<float> y = filtered(light, by.achromatic, by.achromatic);
    const std::vector<float> rg = filtered(channels[1], by.redGreen, by.redGreen);
    const std::vector<float> wide = filtered(blueYellow, by.blueYellow[0], by.blueYellow[0]);
    const std::vector<float> narrow = filtered(blueYellow, by.blueYellow[1], by.blueYellow[1]);
    Seen seen;
    seen.colour.reserve(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        const float cz = by.share[0] * wide[i] + by.share[1] * narrow[i];
        const glm::vec3 rgb = kRgbFromShares * glm::vec3(rg[i] + y[i], y[i], y[i] - cz);
        seen.colour.push_back(perceived(glm::clamp(rgb, 0.0f, 1.0f)));
    }
    seen.edge = lengths(filtered(light, by.edge, by.smooth), filtered(light, by.smooth, by.edge));
    seen.point =
        lengths(filtered(light, by.point, by.smooth), filtered(light, by.smooth, by.point));
    return seen;
}

/// Error of pixel i: the colour error, amplified by the feature error. [Andersson20]
float flipError(const Seen& a, const Seen& b, std::size_t i) {
    static const float largest =
        colourDistance(perceived({0.0f, 1.0f, 0.0f}), perceived({0.0f, 0.0f, 1.0f}));
    const float knee = kKneeAt * largest;
    const float distance = colourDistance(a.colour[i], b.colour[i]);
    const float colour =
        distance < knee ? kKneeError * distance / knee
                        : kKneeError + (1.0f - kKneeError) * (distance - knee) / (largest - knee);
    const float feature =
        std::max(std::abs(a.edge[i] - b.edge[i]), std::abs(a.point[i] - b.point[i]));
    const float exponent = 1.0f - std::sqrt(feature / std::numbers::sqrt2_v<float>);
    return std::clamp(std::pow(colour, std::max(exponent, 0.0f)), 0.0f, 1.0f);
}

/// The largest error of each pixel over all displays of the images.
FlipMap flip(const ImageF& image, const ImageF& reference, const std::vector<Showing>& showings,
             double pixelsPerDegree, const Progress& progress) {
    checkComparable(image, reference);
    const Filters filters(pixelsPerDegree);
    FlipMap map{image.size, std::vector<float>(image.pixels.size(), 0.0f)};
    const auto band = [&](std::size_t piece, std::size_t, const Progress& within) {
        const int first = static_cast<int>(piece) * kBandRows;
        const int rows = std::min(kBandRows, image.size.y - first);
        float* errors = map.errors.data() + static_cast<std::ptrdiff_t>(first) * image.size.x;
        for (const Showing& showing : showings) {
            const Seen a = see(image, showing, first, rows, filters);
            const Seen b = see(reference, showing, first, rows, filters);
            for (std::size_t i = 0; i < a.colour.size(); ++i) {
                errors[i] = std::max(errors[i], flipError(a, b, i));
            }
            if (!goOn(within, 0.0)) throw Cancelled{};
        }
    };
    const auto bands = static_cast<std::size_t>((image.size.y + kBandRows - 1) / kBandRows);
    shareOut(bands, workerCount(bands), band, progress);
    return map;
}

}  // namespace

double FlipMap::mean() const {
    return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

double FlipMap::p95() const {
    return quantile(errors, 0.95);
}

FlipMap ldrFlip(const ImageF& image, const ImageF& reference, double pixelsPerDegree,
                const Progress& progress) {
    return flip(image, reference, {Showing{}}, pixelsPerDegree, progress);
}

FlipExposures flipExposures(const ImageF& reference) {
    std::vector<float> lights;
    for (const glm::vec4& pixel : reference.pixels) {
        lights.push_back(luminance(glm::max(pixel, 0.0f)));
    }
    const float most = lights.empty() ? 0.0f : *std::max_element(lights.begin(), lights.end());
    if (!(most > 0.0f)) {
        throw Error({.what = "the reference is black: it has no exposures to be seen at",
                     .expected = "a reference with some light"});
    }
    double median = quantile(lights, 0.5);
    if (!(median > 0.0)) {  // mostly black: median of the rest
        std::erase_if(lights, [](float light) { return !(light > 0.0f); });
        median = quantile(lights, 0.5);
    }
    // The light that is mapped to the share t of white: filmic(u) = t is a quadratic in u.
    const double a = 2.51 - kWhiteShare * 2.43, b = 0.03 - kWhiteShare * 0.59,
                 c = -kWhiteShare * 0.14;
    const double light =
        (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a) / static_cast<double>(kAcesGain);
    FlipExposures exposures;
    exposures.start = std::log2(light / static_cast<double>(most));
    exposures.stop = std::log2(light / median);
    exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
    return exposures;
}

FlipMap hdrFlip(const ImageF& image, const ImageF& reference, const FlipExposures& exposures,
                double pixelsPerDegree, const Progress& progress) {
    std::vector<Showing> showings;
    for (int i = 0; i < exposures.count; ++i) {
        const double share =
            exposures.count > 1 ? static_cast<double>(i) / (exposures.count - 1) : 0.0;
        const double ev = exposures.start + share * (exposures.stop - exposures.start);
        showings.push_back({true, static_cast<float>(std::exp2(ev))});
    }
    return flip(image, reference, showings, pixelsPerDegree, progress);
}

}  // namespace neph
