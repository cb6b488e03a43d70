// png.h: pictures for the screen as PNG files; sRGB, 8 bits.
#pragma once
#include <filesystem>
#include <functional>

#include "app/image_io/metadata.h"
#include "core/image/image.h"

namespace neph {

/// Writes RGBA with the sRGB chunk; metadata as tEXt chunks, or iTXt where not ASCII. Written
/// aside, then renamed. Throws Error.
void writePng(const std::filesystem::path& file, const Image8& image, const Metadata& metadata);

/// The same of `sizePx`, from the bands of rows that `next` gives, from the top, until they are all
/// there. What `next` throws leaves no file.
void writePng(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              const std::function<Image8()>& next);

/// Any PNG, converted to 8-bit sRGB RGBA. Throws Error.
Image8 readPng(const std::filesystem::path& file);

/// The text chunks that stand before the picture. Throws Error.
Metadata readPngMetadata(const std::filesystem::path& file);

}  // namespace neph
