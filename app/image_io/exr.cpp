// exr.cpp: calls of OpenEXR. Its exceptions are caught here and become Errors.
#include "app/image_io/exr.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/sky/spectrum.h"

namespace neph {
namespace {

constexpr std::array<const char*, 4> kChannels{"R", "G", "B", "A"};
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;  // 4 GiB of RGBA
constexpr float kHalfMax = 65504.0f;  // largest finite half, IEEE 754 binary16

/// Linear sRGB whose luminance is radiance as the eye weighs it: a white of 1 W m⁻² sr⁻¹ has 683
/// cd/m².
void addUnits(Imf::Header& header) {
    header.insert(kRadianceUnitsKey, Imf::StringAttribute(kRadianceUnits));
    Imf::addWhiteLuminance(header, static_cast<float>(kLumensPerW));
    Imf::addChromaticities(header, Imf::Chromaticities());  // those of Rec. 709
}

float radianceScale() {
    return static_cast<float>(imageUnitWPerM2Sr());
}

Imf::Header makeHeader(glm::ivec2 sizePx, const Metadata& metadata, Imf::PixelType type,
                       bool radiance, const std::vector<std::string>& layers) {
    Imf::Header header(sizePx.x, sizePx.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : kChannels) header.channels().insert(name, Imf::Channel(type));
    for (const std::string& name : layers) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [key, text] : metadata) {
        header.insert(key.c_str(), Imf::StringAttribute(text));
    }
    if (radiance) addUnits(header);
    return header;
}

/// A slice over an array whose first value belongs to column `lower.x` and row `lower.y`. The
/// library addresses pixels from (0, 0), which may be outside the image.
template <typename T>
Imf::Slice sliceFrom(T* first, std::size_t components, glm::ivec2 size, glm::ivec2 lower,
                     Imf::PixelType type, double fill) {
    const std::size_t xStride = components * sizeof(T);
    const std::size_t yStride = xStride * static_cast<std::size_t>(size.x);
    char* origin = reinterpret_cast<char*>(first) - static_cast<std::ptrdiff_t>(xStride) * lower.x -
                   static_cast<std::ptrdiff_t>(yStride) * lower.y;
    return {type, origin, xStride, yStride, 1, 1, fill};
}

/// Slices over interleaved RGBA of the component type T, row 0 at the top.
template <typename T>
Imf::FrameBuffer interleaved(T* first, glm::ivec2 size, glm::ivec2 lower, Imf::PixelType type) {
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
        const double fill = c == 3 ? 1.0 : 0.0;
        frame.insert(kChannels[c], sliceFrom(first + c, kChannels.size(), size, lower, type, fill));
    }
    return frame;
}

/// Clips instead of overflowing to infinity, and counts how often.
std::vector<half> toHalf(const ImageF& image, std::size_t& clipped) {
    std::vector<half> values;
    values.reserve(image.pixels.size() * 4);
    for (const glm::vec4& pixel : image.pixels) {
        for (int c = 0; c < 4; ++c) {
            if (std::abs(pixel[c]) > kHalfMax) ++clipped;
            values.emplace_back(std::clamp(pixel[c], -kHalfMax, kHalfMax));
        }
    }
    return values;
}

/// All that is radiance, to the units of the file.
void toUnits(LayeredImage& band) {
    const float scale = radianceScale();
    for (glm::vec4& pixel : band.colours.pixels) pixel *= glm::vec4(scale, scale, scale, 1.0f);
    for (ImageLayer& layer : band.layers) {
        const float factor = std::pow(scale, static_cast<float>(layer.radiancePower));
        for (float& value : layer.values) value *= factor;
    }
}

/// Adds slices over the layers of a band that begins at row `row`.
void addLayers(Imf::FrameBuffer& frame, LayeredImage& band, int row) {
    for (ImageLayer& layer : band.layers) {
        assert(layer.values.size() == band.colours.pixels.size());
        frame.insert(layer.name, sliceFrom(layer.values.data(), 1, band.colours.size, {0, row},
                                           Imf::FLOAT, 0.0));
    }
}

/// Writes a band of rows that begins at row `row`; returns how many values were clipped.
std::size_t writeBand(Imf::OutputFile& out, LayeredImage band, int row, ExrFormat format) {
    if (format.radiance) toUnits(band);
    ImageF& colours = band.colours;
    std::vector<half> halves;
    std::size_t clipped = 0;
    Imf::FrameBuffer frame;
    if (format.pixels == ExrPixels::half) {
        halves = toHalf(colours, clipped);
        frame = interleaved(halves.data(), colours.size, {0, row}, Imf::HALF);
    } else {
        frame = interleaved(&colours.pixels.data()->x, colours.size, {0, row}, Imf::FLOAT);
    }
    addLayers(frame, band, row);
    out.setFrameBuffer(frame);
    out.writePixels(colours.size.y);
    return clipped;
}

/// Writes all bands; at most one is held in memory.
std::size_t writeTo(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
                    ExrFormat format, const std::vector<std::string>& layers,
                    const std::function<LayeredImage()>& next) {
    const Imf::PixelType type = format.pixels == ExrPixels::half ? Imf::HALF : Imf::FLOAT;
    Imf::OutputFile out(file.c_str(), makeHeader(sizePx, metadata, type, format.radiance, layers));
    std::size_t clipped = 0;
    for (int row = 0; row < sizePx.y;) {
        LayeredImage band = next();
        const int rows = band.colours.size.y;
        assert(band.colours.size.x == sizePx.x && rows >= 1);
        assert(std::ranges::equal(band.layers, layers, {}, &ImageLayer::name));
        clipped += writeBand(out, std::move(band), row, format);
        row += rows;
    }
    return clipped;
}

/// Size of the data window. Throws if the image is too large to be held in memory.
glm::ivec2 sizeOf(const Imf::InputFile& in) {
    const auto window = in.header().dataWindow();
    const glm::ivec2 size{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
    if (static_cast<std::int64_t>(size.x) * size.y <= kMaxPixels) return size;
    throw Iex::InputExc(
        fmt::format("{} x {} pixels, more than {} in total", size.x, size.y, kMaxPixels));
}

ImageF readFrom(const std::filesystem::path& file, Metadata* metadata) {
    Imf::InputFile in(file.c_str());
    const auto window = in.header().dataWindow();
    ImageF image;
    image.size = sizeOf(in);
    image.pixels.resize(static_cast<std::size_t>(image.size.x) *
                        static_cast<std::size_t>(image.size.y));
    in.setFrameBuffer(
        interleaved(&image.pixels.data()->x, image.size, {window.min.x, window.min.y}, Imf::FLOAT));
    in.readPixels(window.min.y, window.max.y);
    Metadata texts;
    for (auto at = in.header().begin(); at != in.header().end(); ++at) {
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&at.attribute())) {
            texts.emplace_back(at.name(), text->value());
        }
    }
    if (const float scale = imageUnitOfExr(texts); scale != 1.0f) {
        for (glm::vec4& pixel : image.pixels) pixel *= glm::vec4(scale, scale, scale, 1.0f);
    }
    if (metadata != nullptr) metadata->insert(metadata->end(), texts.begin(), texts.end());
    return image;
}

std::vector<std::vector<float>> layersFrom(const std::filesystem::path& file,
                                           const std::vector<std::string>& names) {
    Imf::InputFile in(file.c_str());
    const auto window = in.header().dataWindow();
    const glm::ivec2 size = sizeOf(in);
    std::vector<std::vector<float>> layers(names.size());
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (in.header().channels().findChannel(names[i]) == nullptr) continue;
        layers[i].resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        frame.insert(names[i], sliceFrom(layers[i].data(), 1, size, {window.min.x, window.min.y},
                                         Imf::FLOAT, 0.0));
    }
    in.setFrameBuffer(frame);
    if (frame.begin() != frame.end()) in.readPixels(window.min.y, window.max.y);
    return layers;
}

}  // namespace

float imageUnitOfExr(const Metadata& metadata) {
    const auto stated =
        std::ranges::find(metadata, kRadianceUnitsKey, &std::pair<std::string, std::string>::first);
    return stated != metadata.end() && stated->second == kRadianceUnits ? 1.0f / radianceScale()
                                                                        : 1.0f;
}

void append(LayeredImage& image, const LayeredImage& band) {
    const auto add = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    assert(image.layers.size() == band.layers.size());
    image.colours.size.y += band.colours.size.y;
    add(image.colours.pixels, band.colours.pixels);
    for (std::size_t i = 0; i < image.layers.size(); ++i) {
        add(image.layers[i].values, band.layers[i].values);
    }
}

std::size_t writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
                     ExrFormat format, const std::vector<std::string>& layers,
                     const std::function<LayeredImage()>& next) {
    std::size_t clipped = 0;
    replaceFile(file, [&](const std::filesystem::path& temporary) {
        try {
            clipped = writeTo(temporary, sizePx, metadata, format, layers, next);
        } catch (const Iex::BaseExc& fault) {
            throw Error({file.string(), "cannot be written as OpenEXR", fault.what(), "", ""});
        }
    });
    return clipped;
}

std::size_t writeExr(const std::filesystem::path& file, const ImageF& image,
                     const Metadata& metadata, ExrFormat format) {
    return writeExr(file, image.size, metadata, format, {}, [&] {
        return LayeredImage{image, {}};
    });
}

ImageF readExr(const std::filesystem::path& file, Metadata* metadata) {
    try {
        return readFrom(file, metadata);
    } catch (const std::exception& fault) {
        throw Error({file.string(), "cannot be read as OpenEXR", fault.what(), "", ""});
    }
}

std::vector<std::vector<float>> readExrLayers(const std::filesystem::path& file,
                                              const std::vector<std::string>& names) {
    try {
        return layersFrom(file, names);
    } catch (const std::exception& fault) {
        throw Error({file.string(), "cannot be read as OpenEXR", fault.what(), "", ""});
    }
}

}  // namespace neph
