// kept_images.cpp: queries of GL, and the calls that they mirror.
#include "app/gl/kept_images.h"

namespace neph::gl {

KeptImages::KeptImages(int count) : units_(static_cast<std::size_t>(count)) {
    for (GLuint i = 0; i < units_.size(); ++i) {
        Unit& unit = units_[i];
        glGetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &unit.name);
        glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &unit.level);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &unit.layered);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &unit.layer);
        glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &unit.access);
        glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &unit.format);
    }
}

KeptImages::~KeptImages() {
    for (GLuint i = 0; i < units_.size(); ++i) {
        const Unit& unit = units_[i];
        glBindImageTexture(i, static_cast<GLuint>(unit.name), unit.level,
                           unit.layered != 0 ? GL_TRUE : GL_FALSE, unit.layer,
                           static_cast<GLenum>(unit.access), static_cast<GLenum>(unit.format));
    }
}

}  // namespace neph::gl
