// reference_channels.cpp: structs of pixels to planes of numbers.
#include "app/cli/render/reference_channels.h"

#include <array>
#include <cstddef>

namespace neph {
namespace {

constexpr std::array<const char*, 3> kColours{"R", "G", "B"};

/// Three channels of a layer, from a function of pixel and channel.
template <typename Value>
void addColours(std::vector<ImageLayer>& channels, const std::string& name, std::size_t pixels,
                const Value& value, int power = 1) {
    for (std::size_t c = 0; c < kColours.size(); ++c) {
        ImageLayer& channel =
            channels.emplace_back(ImageLayer{name + "." + kColours[c], {}, power});
        channel.values.reserve(pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            channel.values.push_back(value(i)[static_cast<int>(c)]);
        }
    }
}

std::string depthName(int species) {
    return "optical_depth." + std::string(info(static_cast<Species>(species)).id);
}

}  // namespace

const std::vector<std::string>& referenceChannels() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const ImageLayer& channel : channelsOf({})) all.push_back(channel.name);
        return all;
    }();
    return names;
}

const std::vector<std::string>& halfChannels() {
    static const std::vector<std::string> names(
        referenceChannels().begin(),
        referenceChannels().begin() + static_cast<std::ptrdiff_t>(2 * kColours.size()));
    return names;
}

std::optional<Halves> halvesFrom(const std::vector<std::vector<float>>& channels, glm::ivec2 size) {
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    for (const std::vector<float>& channel : channels) {
        if (channel.size() != pixels) return {};
    }
    Halves halves{{size, {}}, {size, {}}};
    for (std::size_t i = 0; i < pixels; ++i) {
        halves.a.pixels.emplace_back(channels[0][i], channels[1][i], channels[2][i], 1.0f);
        halves.b.pixels.emplace_back(channels[3][i], channels[4][i], channels[5][i], 1.0f);
    }
    return halves;
}

std::vector<ImageLayer> channelsOf(const render::FrameLayers& layers) {
    std::vector<ImageLayer> channels;
    const std::size_t pixels = layers.halfA.pixels.size();
    addColours(channels, "A", pixels, [&](std::size_t i) { return layers.halfA.pixels[i]; });
    addColours(channels, "B", pixels, [&](std::size_t i) { return layers.halfB.pixels[i]; });
    addColours(
        channels, "variance", pixels, [&](std::size_t i) { return layers.varianceOfMean[i]; }, 2);
    channels.push_back({"transmittance", layers.transmittance, 0});
    channels.push_back({"depth.first_scatter", layers.firstScatterM, 0});
    for (int s = 0; s < kSpeciesCount; ++s) {
        std::vector<float> depth = layers.opticalDepth[static_cast<std::size_t>(s)];
        depth.resize(pixels, 0.0f);
        channels.push_back({depthName(s), std::move(depth), 0});
    }
    return channels;
}

}  // namespace neph
