// compare_command.cpp: two files, or what engines drew, compared and told.
#include "app/cli/compare/compare_command.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/cli/common/interrupt.h"
#include "app/cli/compare/compare_engines.h"
#include "app/cli/compare/comparison.h"
#include "app/cli/render/reference_channels.h"
#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "core/look/colours.h"

namespace neph {
namespace {

constexpr double kPerPercent = 0.01;

std::string textOf(const Metadata& metadata, std::string_view key) {
    for (const auto& [name, text] : metadata) {
        if (name == key) return text;
    }
    return {};
}

ComparedPicture readExrPicture(const std::string& file, Metadata& metadata) {
    ComparedPicture read;
    read.picture = readExr(file, &metadata);
    read.halves = halvesFrom(readExrLayers(file, halfChannels()), read.picture.size);
    return read;
}

ComparedPicture readPngPicture(const std::string& file, Metadata& metadata) {
    ComparedPicture read;
    read.display = true;
    metadata = readPngMetadata(file);
    const Image8 image = readPng(file);
    read.picture.size = image.size;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const glm::vec3 srgb =
            glm::vec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) / 255.0f;
        const float alpha = static_cast<float>(image.rgba[i + 3]) / 255.0f;
        read.picture.pixels.emplace_back(alpha * linearFromSrgb(srgb), alpha);
    }
    return read;
}

ComparedPicture readPicture(const std::string& file, Metadata& metadata) {
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension != ".exr" && extension != ".png") {
        throw UsageError({file, "is no picture that can be compared",
                          extension.empty() ? "no extension" : extension, ".exr or .png",
                          "nephoscope compare --engine march,reference FILE... compares engines"});
    }
    ComparedPicture read =
        extension == ".exr" ? readExrPicture(file, metadata) : readPngPicture(file, metadata);
    read.name = file;
    read.made = textOf(metadata, "nephoscope.renderer");
    return read;
}

/// Pictures of different views differ for another reason than their engines.
void warnOfDifferences(const Metadata& a, const Metadata& b) {
    for (const char* key : {"camera", "data"}) {
        const std::string one = textOf(a, fmt::format("nephoscope.{}", key));
        const std::string other = textOf(b, fmt::format("nephoscope.{}", key));
        if (one.empty() || other.empty() || one == other) continue;
        fmt::print(stderr, "warning: the pictures differ in their {}: {}; {}\n", key, one, other);
    }
}

std::optional<double> endOfScale(const ComparisonOptions& options) {
    std::optional<double> most = parseOptionalNumber("--error-to", options.errorTo);
    if (most) *most *= kPerPercent;
    return most;
}

void keepPicture(const std::filesystem::path& file, const Image8& picture) {
    if (file.empty()) return;
    writePng(file, picture, {});
    fmt::print(stderr, "wrote {}\n", file.string());
}

/// Figures of all but the last, which is the reference.
std::vector<Comparison> compareAll(const ComparisonOptions& options,
                                   const std::vector<ComparedPicture>& pictures) {
    const auto exposure = parseOptionalNumber("--exposure", options.exposureEv);
    std::vector<Comparison> comparisons;
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
        comparisons.push_back(compare(pictures[i], pictures.back(), exposure));
    }
    return comparisons;
}

void tell(const ComparisonOptions& options, std::vector<ComparedPicture> pictures,
          const std::vector<Comparison>& comparisons) {
    const ComparedPicture reference = std::move(pictures.back());
    pictures.pop_back();
    const auto told = options.json ? comparisonJson : comparisonText;
    fmt::print("{}", told(pictures, comparisons, reference));
}

void compareFiles(const ComparisonOptions& options) {
    std::vector<Metadata> texts(2);
    std::vector<ComparedPicture> pictures;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        pictures.push_back(readPicture(options.render.scene.files[i], texts[i]));
    }
    warnOfDifferences(texts[0], texts[1]);
    const std::vector<Comparison> comparisons = compareAll(options, pictures);
    if (!options.errorPicture.empty()) {
        keepPicture(
            options.errorPicture,
            relativeErrorPicture(pictures[0], pictures[1], options.bothSigns, endOfScale(options)));
    }
    if (!options.flipPicture.empty()) keepPicture(options.flipPicture, flipPicture(comparisons[0]));
    tell(options, std::move(pictures), comparisons);
}

void compareEngines(const ComparisonOptions& options) {
    std::vector<ComparedPicture> pictures = drawEngines(options, untilInterrupted());
    const std::vector<Comparison> comparisons = compareAll(options, pictures);
    for (std::size_t i = 0; i < comparisons.size() && !options.out.empty(); ++i) {
        const std::string& name = pictures[i].name;
        keepPicture(fileOf(options, name, "-error.png"),
                    relativeErrorPicture(pictures[i], pictures.back(), options.bothSigns,
                                         endOfScale(options)));
        keepPicture(fileOf(options, name, "-flip.png"), flipPicture(comparisons[i]));
    }
    tell(options, std::move(pictures), comparisons);
}

}  // namespace

int runCompare(const ComparisonOptions& options) {
    checkOptions(options);
    if (options.engines.empty()) {
        compareFiles(options);
        return 0;
    }
    noteInterrupts();
    try {
        compareEngines(options);
    } catch (const Cancelled&) {
        return 128 + interruptSignal();
    }
    return 0;
}

}  // namespace neph
