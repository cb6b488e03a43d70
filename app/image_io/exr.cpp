// exr.cpp: OpenEXR behind two functions; its exceptions end here.
#include "app/image_io/exr.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "core/atomic_file.h"
#include "core/error.h"

namespace neph {
namespace {

constexpr std::array<const char*, 4> kChannels{"R", "G", "B", "A"};
constexpr float kHalfMax = 65504.0f;  // largest finite half, IEEE 754 binary16

Imf::Header makeHeader(glm::ivec2 sizePx, const Metadata& metadata, Imf::PixelType type) {
    Imf::Header header(sizePx.x, sizePx.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : kChannels) header.channels().insert(name, Imf::Channel(type));
    for (const auto& [key, text] : metadata) {
        header.insert(key.c_str(), Imf::StringAttribute(text));
    }
    return header;
}

/// Slices over interleaved RGBA of the component type T, row 0 on top.
template <typename T>
Imf::FrameBuffer interleaved(T* first, glm::ivec2 size, glm::ivec2 lower, Imf::PixelType type) {
    const std::size_t xStride = 4 * sizeof(T);
    const std::size_t yStride = xStride * static_cast<std::size_t>(size.x);
    // The library addresses pixels from (0, 0), which need not be within the picture.
    char* origin = reinterpret_cast<char*>(first) - static_cast<std::ptrdiff_t>(xStride) * lower.x -
                   static_cast<std::ptrdiff_t>(yStride) * lower.y;
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
        const double fill = c == 3 ? 1.0 : 0.0;
        frame.insert(kChannels[c],
                     Imf::Slice(type, origin + c * sizeof(T), xStride, yStride, 1, 1, fill));
    }
    return frame;
}

std::vector<half> toHalf(const ImageF& image) {
    std::vector<half> values;
    values.reserve(image.pixels.size() * 4);
    for (const glm::vec4& pixel : image.pixels) {
        for (int c = 0; c < 4; ++c) {
            values.emplace_back(std::clamp(pixel[c], -kHalfMax, kHalfMax));
        }
    }
    return values;
}

/// The next rows of the file; `row` is the first of them.
void writeBand(Imf::OutputFile& out, const ImageF& band, int row, ExrPixels pixels) {
    if (pixels == ExrPixels::half) {
        std::vector<half> values = toHalf(band);
        out.setFrameBuffer(interleaved(values.data(), band.size, {0, row}, Imf::HALF));
        out.writePixels(band.size.y);
    } else {
        std::vector<glm::vec4> values = band.pixels;
        out.setFrameBuffer(interleaved(&values.data()->x, band.size, {0, row}, Imf::FLOAT));
        out.writePixels(band.size.y);
    }
}

void writeTo(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
             ExrPixels pixels, const std::function<ImageF()>& next) {
    const Imf::PixelType type = pixels == ExrPixels::half ? Imf::HALF : Imf::FLOAT;
    Imf::OutputFile out(file.c_str(), makeHeader(sizePx, metadata, type));
    for (int row = 0; row < sizePx.y;) {
        const ImageF band = next();
        assert(band.size.x == sizePx.x && band.size.y >= 1);
        writeBand(out, band, row, pixels);
        row += band.size.y;
    }
}

ImageF readFrom(const std::filesystem::path& file, Metadata* metadata) {
    Imf::InputFile in(file.c_str());
    const auto window = in.header().dataWindow();
    ImageF image;
    image.size = {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
    image.pixels.resize(static_cast<std::size_t>(image.size.x) *
                        static_cast<std::size_t>(image.size.y));
    in.setFrameBuffer(
        interleaved(&image.pixels.data()->x, image.size, {window.min.x, window.min.y}, Imf::FLOAT));
    in.readPixels(window.min.y, window.max.y);
    if (metadata != nullptr) {
        for (auto at = in.header().begin(); at != in.header().end(); ++at) {
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&at.attribute())) {
                metadata->emplace_back(at.name(), text->value());
            }
        }
    }
    return image;
}

}  // namespace

void writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              ExrPixels pixels, const std::function<ImageF()>& next) {
    replaceFile(file, [&](const std::filesystem::path& aside) {
        try {
            writeTo(aside, sizePx, metadata, pixels, next);
        } catch (const Iex::BaseExc& fault) {
            throw Error({file.string(), "cannot be written as OpenEXR", fault.what(), "", ""});
        }
    });
}

void writeExr(const std::filesystem::path& file, const ImageF& image, const Metadata& metadata,
              ExrPixels pixels) {
    writeExr(file, image.size, metadata, pixels, [&] { return image; });
}

ImageF readExr(const std::filesystem::path& file, Metadata* metadata) {
    try {
        return readFrom(file, metadata);
    } catch (const std::exception& fault) {
        throw Error({file.string(), "cannot be read as OpenEXR", fault.what(), "", ""});
    }
}

}  // namespace neph
