// light_layers.cpp: one dispatch a slice, since each layer is made of the one before.
#include "app/render/engines/light_layers.h"

#include <algorithm>

namespace neph::render {
namespace {

// Between two questions to `progress`, a few milliseconds on the slowest machine.
constexpr int kBandSlices = 8;

}  // namespace

void LightLayers::resize(glm::ivec2 sizePx, int layers, GLenum format) {
    if (layers_.size() == glm::ivec3(sizePx, layers) && format_ == format) return;
    layers_ = {};
    layers_ = gl::Texture::make2DArray(format, sizePx, layers);
    layers_.setLinear();
    format_ = format;
}

void LightLayers::open(int fromLayer) {
    const glm::ivec3 size = layers_.size();
    if (fromLayer < 0) {
        const float full = 1.0f;
        glClearTexSubImage(layers_.name(), 0, 0, 0, 0, size.x, size.y, 1, GL_RED, GL_FLOAT, &full);
    } else {
        glCopyImageSubData(layers_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, fromLayer, layers_.name(),
                           GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, size.x, size.y, 1);
    }
}

void LightLayers::march(const gl::Program& program, int slices, const Progress& progress) {
    layers_.bindImage(0, GL_WRITE_ONLY);
    for (int layer = 0; layer < slices; ++layer) {
        if (layer % kBandSlices == 0 && !goOn(progress, 0.0)) throw Cancelled{};
        program.setInt(0, layer);
        program.dispatch({layers_.size().x, layers_.size().y, 1});
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

int layersThatFit(glm::ivec2 sizePx, std::size_t bytesPerTexel, std::size_t mostBytes) {
    const std::size_t layerBytes =
        static_cast<std::size_t>(sizePx.x) * static_cast<std::size_t>(sizePx.y) * bytesPerTexel;
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    return std::max(2, std::min(static_cast<int>(mostBytes / layerBytes), most));
}

}  // namespace neph::render
