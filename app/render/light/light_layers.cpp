// light_layers.cpp: one dispatch a slice, since each layer is made of the one before.
#include "app/render/light/light_layers.h"

#include <algorithm>

namespace neph::render {
namespace {

// Between two questions to `progress`, a few milliseconds on the slowest machine.
constexpr int kBandSlices = 8;

}  // namespace

void LightLayers::resize(glm::ivec2 sizePx, int layers, GLenum format, bool repeats) {
    const bool same = format_ == format && repeats_ == repeats;
    if (same && layers_.size() == glm::ivec3(sizePx, layers)) return;
    layers_ = {};
    layers_ = gl::Texture::make2DArray(format, sizePx, layers);
    layers_.setLinear();
    if (repeats) layers_.setRepeat();
    format_ = format;
    repeats_ = repeats;
}

void LightLayers::copy(int from, int to) {
    const glm::ivec3 size = layers_.size();
    glCopyImageSubData(layers_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, from, layers_.name(),
                       GL_TEXTURE_2D_ARRAY, 0, 0, 0, to, size.x, size.y, 1);
}

void LightLayers::open(int fromLayer) {
    const glm::ivec3 size = layers_.size();
    if (fromLayer < 0) {
        const float full = 1.0f;
        glClearTexSubImage(layers_.name(), 0, 0, 0, 0, size.x, size.y, 1, GL_RED, GL_FLOAT, &full);
    } else {
        copy(fromLayer, 0);
    }
}

void LightLayers::march(const gl::Program& program, const LightTiles& tiles,
                        const Progress& progress) {
    if (!tiles.tiles.empty()) {
        tiles_.write(tiles.tiles.data(), tiles.tiles.size() * sizeof(glm::ivec2));
        tiles_.bind(GL_SHADER_STORAGE_BUFFER, kLightTilesBuffer);
    }
    layers_.bindImage(kLightImage, GL_WRITE_ONLY);
    const int slices = static_cast<int>(tiles.firstOf.size()) - 1;
    for (int layer = 0; layer < slices; ++layer) {
        if (layer % kBandSlices == 0 && !goOn(progress, 0.0)) throw Cancelled{};
        const int first = tiles.firstOf[static_cast<std::size_t>(layer)];
        const int end = tiles.firstOf[static_cast<std::size_t>(layer) + 1];
        copy(layer, layer + 1);  // light passes unchanged where there is nothing
        program.setInt(kLightLayerLocation, layer);
        program.dispatchGroups(end - first, first);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                        GL_TEXTURE_UPDATE_BARRIER_BIT);
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
