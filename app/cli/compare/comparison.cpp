// comparison.cpp: figures to words, JSON and colours.
#include "app/cli/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

constexpr const char* kGap = "  ";

std::size_t widthOf(const std::string& utf8) {
    return static_cast<std::size_t>(std::ranges::count_if(
        utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::string tableText(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], widthOf(row[c]));
        }
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            line += row[c] + std::string(widths[c] - widthOf(row[c]), ' ') + kGap;
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string madeText(const ComparedImage& of) {
    std::string text = fmt::format("{}x{}", of.image.size.x, of.image.size.y);
    if (of.display) text += ", as a screen shows it";
    if (!of.made.empty()) text += ", " + of.made;
    if (of.halves) text += ", in two halves";
    return text;
}

const char* flipName(const Comparison& comparison) {
    return comparison.exposures ? "HDR-FLIP" : "LDR-FLIP";
}

/// The exposures that FLIP looked at.
Row exposuresRow(const FlipExposures& at) {
    std::string text =
        fmt::format("of HDR-FLIP, tone mapped as ACES: {} EV", numberText(at.start, 3));
    if (at.count > 1) {
        text += fmt::format(" to {} EV, the largest of {}", numberText(at.stop, 3), at.count);
    }
    return {"exposures", text};
}

/// What was subtracted, of all images.
std::string noiseText(const std::vector<Comparison>& comparisons) {
    double most = 0.0;
    for (const Comparison& each : comparisons) most = std::max(most, each.errors.noise);
    if (!(most > 0.0)) return "with all noise: nothing has halves";
    return fmt::format(
        "without noise, of which {} % was subtracted; the figures below have it in them",
        numberText(100.0 * most, 3));
}

std::string meanings(const std::vector<Comparison>& comparisons) {
    const Comparison& first = comparisons.front();
    std::vector<Row> rows{
        {"bias", "sum of the differences over the sum of the reference"},
        {"relRMSE", "root mean square of the differences over the mean of the reference"},
        {"", noiseText(comparisons)},
        {"relMSE", "mean of the squared differences over R² + (1 % of the reference's mean)²"},
        {"p95", "95 % of the pixels brighter than 1 % of the brightest differ by less, luminance"},
        {flipName(first),
         "what an eye sees of the difference, 0 to 1: mean, and 95 % of the pixels"}};
    if (first.exposures) rows.push_back(exposuresRow(*first.exposures));
    return tableText(rows);
}

Json describeJson(const ComparedImage& of) {
    Json json{{"name", of.name},
              {"width", of.image.size.x},
              {"height", of.image.size.y},
              {"kind", of.display ? "display" : "radiance"},
              {"halves", of.halves.has_value()}};
    if (!of.made.empty()) json["made"] = of.made;
    if (!of.device.empty()) json["device"] = of.device;
    if (!of.scale.empty()) json["scale"] = of.scale;
    if (of.samples) json["samples"] = *of.samples;
    if (of.seconds) json["seconds"] = *of.seconds;
    return json;
}

Json figuresJson(const Comparison& comparison) {
    const ImageErrors& errors = comparison.errors;
    Json flip{{"kind", flipName(comparison)},
              {"mean", comparison.flip.mean()},
              {"p95", comparison.flip.p95()},
              {"pixels_per_degree", kFlipPixelsPerDegree}};
    if (const auto& at = comparison.exposures) {
        flip["start_ev"] = at->start;
        flip["stop_ev"] = at->stop;
        flip["exposures"] = at->count;
    }
    return {{"bias", errors.bias},
            {"bias_sigma", errors.biasSigma},
            {"rel_rmse", errors.relRmse},
            {"rel_rmse_sigma", errors.relRmseSigma},
            {"rel_rmse_with_noise", errors.relRmseRaw},
            {"noise_taken_off", errors.noise},
            {"rel_mse", errors.relMse},
            {"p95", errors.p95},
            {"flip", std::move(flip)}};
}

}  // namespace

Comparison compare(const ComparedImage& image, const ComparedImage& reference,
                   const std::optional<double>& exposureEv) {
    if (image.display != reference.display) {
        throw Error({.where = image.name,
                     .what = "is compared with " + reference.name,
                     .found = image.display ? "a PNG and an EXR" : "an EXR and a PNG",
                     .expected = "two images of one kind: radiance cannot be told from a screen's "
                                 "colours"});
    }
    try {
        Comparison comparison;
        comparison.errors = imageErrors(image.sampled(), reference.sampled());
        if (image.display) {
            comparison.flip = ldrFlip(image.image, reference.image);
        } else {
            comparison.exposures = exposureEv ? FlipExposures{*exposureEv, *exposureEv, 1}
                                              : flipExposures(reference.image);
            comparison.flip = hdrFlip(image.image, reference.image, *comparison.exposures);
        }
        return comparison;
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = fmt::format("{} and its reference {}", image.name, reference.name);
        throw Error(parts);
    }
}

std::string comparisonText(const std::vector<ComparedImage>& images,
                           const std::vector<Comparison>& comparisons,
                           const ComparedImage& reference) {
    std::vector<Row> whats;
    for (const ComparedImage& image : images) {
        whats.push_back({"image", image.name, madeText(image)});
    }
    whats.push_back({"reference", reference.name, madeText(reference)});
    std::vector<Row> figures{
        {"", "bias", "relRMSE", "relMSE", "p95", flipName(comparisons.front()), "its p95"}};
    for (std::size_t i = 0; i < images.size(); ++i) {
        const ImageErrors& errors = comparisons[i].errors;
        figures.push_back({images[i].name, percentText(errors.bias, errors.biasSigma),
                           percentText(errors.relRmse, errors.relRmseSigma),
                           numberText(errors.relMse, 3), percentText(errors.p95),
                           numberText(comparisons[i].flip.mean(), 3),
                           numberText(comparisons[i].flip.p95(), 3)});
    }
    if (reference.seconds) {
        figures.push_back({reference.name, "reference", "", "", "", "", ""});
        figures.front().insert(figures.front().end(), {"samples", "seconds"});
        for (std::size_t i = 0; i <= images.size(); ++i) {
            const ComparedImage& drawn = i < images.size() ? images[i] : reference;
            figures[i + 1].push_back(fmt::format("{}", drawn.samples.value_or(0)));
            figures[i + 1].push_back(numberText(drawn.seconds.value_or(0.0), 3));
        }
    }
    std::string text = tableText(whats) + "\n" + tableText(figures) + "\n" + meanings(comparisons);
    if (reference.display) {
        text +=
            "\nThese are colours of a screen, decoded to linear light: tone mapping has changed "
            "errors of\nradiance. Compare EXR files for those.\n";
    }
    return text;
}

std::string comparisonJson(const std::vector<ComparedImage>& images,
                           const std::vector<Comparison>& comparisons,
                           const ComparedImage& reference) {
    Json list = Json::array();
    for (std::size_t i = 0; i < images.size(); ++i) {
        Json json = describeJson(images[i]);
        json.update(figuresJson(comparisons[i]));
        list.push_back(std::move(json));
    }
    const Json json{{"type", "nephoscope-comparison"},
                    {"version", 1},
                    {"reference", describeJson(reference)},
                    {"images", std::move(list)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Image8 relativeErrorImage(const ComparedImage& image, const ComparedImage& reference,
                          bool bothSigns, const std::optional<double>& most) {
    const std::vector<float> errors = relativeErrors(image.image, reference.image);
    ErrorScale scale;
    scale.most = most.value_or(roundEnd(errors));
    scale.bothSigns = bothSigns;
    scale.title = bothSigns ? "(A-B)/B" : "|A-B|/B";
    return errorImage(image.image.size, errors, scale);
}

Image8 flipImage(const Comparison& comparison) {
    ErrorScale scale;
    scale.percent = false;
    scale.title = "FLIP";
    return errorImage(comparison.flip.size, comparison.flip.errors, scale);
}

}  // namespace neph
