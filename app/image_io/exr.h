// exr.h: linear pictures as OpenEXR files; premultiplied alpha, as the format wants it.
#pragma once
#include <filesystem>
#include <functional>

#include "app/image_io/metadata.h"
#include "core/image.h"

namespace neph {

enum class ExrPixels { half, full };

/// Channels R, G, B, A, ZIP compression, metadata as string attributes of the header. Half holds
/// values to 65504; larger ones are clipped to it. Written aside, then renamed. Throws Error.
void writeExr(const std::filesystem::path& file, const ImageF& image, const Metadata& metadata,
              ExrPixels pixels = ExrPixels::half);

/// The same of `sizePx`, from the bands of rows that `next` gives, from the top, until they are all
/// there. What `next` throws leaves no file.
void writeExr(const std::filesystem::path& file, glm::ivec2 sizePx, const Metadata& metadata,
              ExrPixels pixels, const std::function<ImageF()>& next);

/// Missing channels read as 0, missing alpha as 1. String attributes are added to `metadata` where
/// given. Throws Error.
ImageF readExr(const std::filesystem::path& file, Metadata* metadata = nullptr);

}  // namespace neph
