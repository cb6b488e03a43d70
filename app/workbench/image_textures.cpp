// image_textures.cpp: row 0 of a texture is the image's top row, as ImGui has it.
#include "app/workbench/image_textures.h"

#include <utility>

#include "app/image_io/png.h"
#include "core/base/error.h"

namespace neph {

ui::LoadedImage ImageTextures::load(const std::filesystem::path& png) {
    try {
        return show(readPng(png));
    } catch (const Error&) {
        return {};
    }
}

ui::LoadedImage ImageTextures::show(const Image8& image) {
    gl::Texture texture = gl::Texture::make2D(GL_RGBA8, image.size);
    texture.setLinear();
    texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    const unsigned name = texture.name();
    textures_.insert_or_assign(name, std::move(texture));
    return {name, image.size};
}

}  // namespace neph
