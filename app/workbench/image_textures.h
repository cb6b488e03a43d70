// image_textures.h: images that panels show, as textures.
#pragma once
#include <filesystem>
#include <map>

#include "app/gl/objects.h"
#include "app/ui/panel/services.h"
#include "core/image/image.h"

namespace neph {

class ImageTextures {
  public:
    ui::LoadedImage load(const std::filesystem::path& png);
    ui::LoadedImage show(const Image8& image);
    void drop(unsigned texture) { textures_.erase(texture); }

  private:
    std::map<unsigned, gl::Texture> textures_;
};

}  // namespace neph
