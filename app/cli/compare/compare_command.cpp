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
#include "core/sky/spectrum.h"

namespace neph {
namespace {

std::string textOf(const Metadata& metadata, std::string_view key) {
    for (const auto& [name, text] : metadata) {
        if (name == key) return text;
    }
    return {};
}

ComparedImage readExrImage(const std::string& file, Metadata& metadata) {
    ComparedImage read;
    read.image = readExr(file, &metadata);
    std::vector<std::vector<float>> halves = readExrLayers(file, halfChannels());
    const float scale = imageUnitOfExr(metadata);
    for (std::vector<float>& channel : halves) {
        for (float& value : channel) value *= scale;
    }
    read.halves = halvesFrom(halves, read.image.size);
    return read;
}

ComparedImage readPngImage(const std::string& file, Metadata& metadata) {
    ComparedImage read;
    read.display = true;
    metadata = readPngMetadata(file);
    const Image8 image = readPng(file);
    read.image.size = image.size;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const glm::vec3 srgb =
            glm::vec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) / 255.0f;
        const float alpha = static_cast<float>(image.rgba[i + 3]) / 255.0f;
        read.image.pixels.emplace_back(alpha * linearFromSrgb(srgb), alpha);
    }
    return read;
}

ComparedImage readImage(const std::string& file, Metadata& metadata) {
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension != ".exr" && extension != ".png") {
        throw UsageError({file, "is no image that can be compared",
                          extension.empty() ? "no extension" : extension, ".exr or .png",
                          "nephoscope compare --engine march,reference FILE... compares engines"});
    }
    ComparedImage read =
        extension == ".exr" ? readExrImage(file, metadata) : readPngImage(file, metadata);
    if (const std::string preview = textOf(metadata, kDenoisedKey); !preview.empty()) {
        throw Error({file, "has no figures: its noise has been removed", preview,
                     "an image of the engine itself",
                     "render it again without --denoise, and with more --samples"});
    }
    read.name = file;
    read.made = textOf(metadata, "nephoscope.renderer");
    read.scale = textOf(metadata, "nephoscope.scale");
    return read;
}

/// Images of different views differ for another reason than their engines.
void warnOfDifferences(const Metadata& a, const Metadata& b) {
    for (const char* key : {"camera", "data"}) {
        const std::string one = textOf(a, fmt::format("nephoscope.{}", key));
        const std::string other = textOf(b, fmt::format("nephoscope.{}", key));
        if (one.empty() || other.empty() || one == other) continue;
        fmt::print(stderr, "warning: the images differ in their {}: {}; {}\n", key, one, other);
    }
}

/// An image that states no units may have any.
void warnOfUnits(const CompareRequest& request, const std::vector<Metadata>& texts) {
    const auto stated = [&](std::size_t i) { return !textOf(texts[i], kRadianceUnitsKey).empty(); };
    if (stated(0) == stated(1)) return;
    const std::size_t without = stated(0) ? 1 : 0;
    fmt::print(stderr, "warning: {} states no {}: 1 is taken to be {:.4g} {}, as in full light\n",
               request.render.scene.files[without], kRadianceUnitsKey, imageUnitWPerM2Sr(),
               kRadianceUnits);
}

void keepImage(const std::filesystem::path& file, const Image8& image) {
    if (file.empty()) return;
    writePng(file, image, {});
    fmt::print(stderr, "wrote {}\n", file.string());
}

/// Figures of all but the last, which is the reference.
std::vector<Comparison> compareAll(const CompareRequest& request,
                                   const std::vector<ComparedImage>& images) {
    std::vector<Comparison> comparisons;
    for (std::size_t i = 0; i + 1 < images.size(); ++i) {
        comparisons.push_back(compare(images[i], images.back(), request.exposureEv));
    }
    return comparisons;
}

void tell(const CompareRequest& request, std::vector<ComparedImage> images,
          const std::vector<Comparison>& comparisons) {
    const ComparedImage reference = std::move(images.back());
    images.pop_back();
    const auto told = request.json ? comparisonJson : comparisonText;
    fmt::print("{}", told(images, comparisons, reference));
}

void compareFiles(const CompareRequest& request) {
    std::vector<Metadata> texts(2);
    std::vector<ComparedImage> images;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        images.push_back(readImage(request.render.scene.files[i], texts[i]));
    }
    if (request.exposureEv && images[0].display) {
        throw UsageError({.where = "--exposure",
                          .what = "is of HDR-FLIP, and these are images of a screen",
                          .hint = "leave it out, or compare EXR files"});
    }
    warnOfDifferences(texts[0], texts[1]);
    warnOfUnits(request, texts);
    const std::vector<Comparison> comparisons = compareAll(request, images);
    if (!request.errorImage.empty()) {
        keepImage(request.errorImage,
                  relativeErrorImage(images[0], images[1], request.bothSigns, request.errorTo));
    }
    if (!request.flipImage.empty()) keepImage(request.flipImage, flipImage(comparisons[0]));
    tell(request, std::move(images), comparisons);
}

void compareEngines(const CompareRequest& request) {
    std::vector<ComparedImage> images = drawEngines(request, untilInterrupted());
    const std::vector<Comparison> comparisons = compareAll(request, images);
    for (std::size_t i = 0; i < comparisons.size() && !request.out.empty(); ++i) {
        const std::string& name = images[i].name;
        keepImage(fileOf(request, name, "-error.png"),
                  relativeErrorImage(images[i], images.back(), request.bothSigns, request.errorTo));
        keepImage(fileOf(request, name, "-flip.png"), flipImage(comparisons[i]));
    }
    tell(request, std::move(images), comparisons);
}

}  // namespace

int runCompare(const CompareRequest& request) {
    if (!request.draws()) {
        compareFiles(request);
        return 0;
    }
    noteInterrupts();
    try {
        compareEngines(request);
    } catch (const Cancelled&) {
        return 128 + interruptSignal();
    }
    return 0;
}

}  // namespace neph
