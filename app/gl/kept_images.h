// kept_images.h: leaves image units as they were, for a pass in the midst of others' work.
#pragma once
#include <epoxy/gl.h>

#include <vector>

namespace neph::gl {

/// Remembers what the first `count` image units are bound to, and binds it again at its end. The
/// textures must still be there.
class KeptImages {
  public:
    explicit KeptImages(int count);
    ~KeptImages();
    KeptImages(const KeptImages&) = delete;
    KeptImages& operator=(const KeptImages&) = delete;

  private:
    struct Unit {
        GLint name = 0, level = 0, layered = 0, layer = 0, access = 0, format = 0;
    };
    std::vector<Unit> units_;
};

}  // namespace neph::gl
