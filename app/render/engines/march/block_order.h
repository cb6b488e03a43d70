// block_order.h: which blocks of the medium each batch of layers of light passes through.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

#include "app/render/light/slice_plan.h"
#include "app/render/medium/volume_textures.h"

namespace neph::render {

/// The blocks that may hold anything, and those around them, `repeats`: also across the sides of
/// the domain: the light between two samples is taken from both, of which one may lie outside.
inline std::vector<glm::ivec3> around(const VolumeTextures& volume, bool repeats) {
    Array3<std::uint8_t> marks((volume.grid.size + kBlockVoxels - 1) / kBlockVoxels, 0);
    std::vector<glm::ivec3> found;
    for (const glm::ivec3 block : volume.blocks) {
        const glm::ivec3 open(!repeats, !repeats, 1);
        const glm::ivec3 lower = glm::max(block - 1, open - 1);
        const glm::ivec3 upper = glm::min(block + 2, marks.size + 1 - open);
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y)
                for (int x = lower.x; x < upper.x; ++x) {
                    const glm::ivec3 at = (glm::ivec3(x, y, z) + marks.size) % marks.size;
                    if (std::exchange(marks.at(at.x, at.y, at.z), std::uint8_t{1}) == 0) {
                        found.push_back(at);
                    }
                }
    }
    return found;
}

/// The blocks that may hold anything, by the layers of light that pass through them.
class BlockOrder {
  public:
    BlockOrder(const VolumeTextures& volume, const SlicePlan& plan) {
        const glm::dvec3 blockM = volume.grid.spacingM * static_cast<double>(kBlockVoxels);
        // Half the extent of a block along the light.
        const double reachM = 0.5 * glm::dot(glm::abs(plan.normal), blockM);
        for (const glm::ivec3 block : around(volume, plan.repeats)) {
            const glm::dvec3 middleM = (glm::dvec3(block) + 0.5) * blockM;
            const double alongM = glm::dot(plan.normal, middleM) - plan.firstM;
            const auto layer = [&](double m) {  // what lies before or behind all has an end's light
                return std::clamp(m / plan.spacingM, 0.0, static_cast<double>(plan.count));
            };
            blocks_.push_back(
                {glm::ivec4(block, 0), layer(alongM - reachM), layer(alongM + reachM)});
        }
    }

    /// Those that lie between layers `first` and `first + slices`, if only in part.
    std::vector<glm::ivec4> within(int first, int slices) const {
        std::vector<glm::ivec4> found;
        for (const Spanned& each : blocks_) {
            if (each.last >= first && each.first <= first + slices) found.push_back(each.block);
        }
        return found;
    }

  private:
    struct Spanned {
        glm::ivec4 block;
        double first, last;  ///< layers
    };
    std::vector<Spanned> blocks_;
};

}  // namespace neph::render
