// png.h: display images as PNG files: sRGB, 8 bits per channel.
#pragma once
#include <filesystem>
#include <functional>

#include "app/image_io/metadata.h"
#include "core/image/image.h"

namespace neph {

/// Writes RGBA with the sRGB chunk; metadata as tEXt chunks, or iTXt if not ASCII. Writes to a
/// temporary file, then renames it. Throws Error.
void writePng(const std::filesystem::path& file, const Image8& image, const Metadata& metadata);

/// As above, but in bands: `next` returns the next rows from the top, until the image of `sizePx`
/// is complete. Nothing is written if `next` throws.
void writePng(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              const std::function<Image8()>& next);

/// Reads any PNG, converted to 8-bit sRGB RGBA. Throws Error.
Image8 readPng(const std::filesystem::path& file);

/// The text chunks that precede the image data. Throws Error.
Metadata readPngMetadata(const std::filesystem::path& file);

}  // namespace neph
