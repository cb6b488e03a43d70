// framing.cpp: finds the blocks that hold something to see.
#include "core/volume/framing.h"

#include <algorithm>
#include <limits>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

constexpr int kBlocksPerAxis = 16;  // boxes closer than a sixteenth of the domain; tuned by eye

/// Cells of a block along each axis.
glm::ivec3 blockCells(const RegularGrid& grid) {
    return (grid.size + kBlocksPerAxis - 1) / kBlocksPerAxis;
}

/// Boxes of cells, one for each block; empty ones have no upper corner.
class SeenBlocks {
  public:
    explicit SeenBlocks(const RegularGrid& grid)
        : cells_(blockCells(grid)),
          boxes_((grid.size + cells_ - 1) / cells_,
                 {glm::ivec3(std::numeric_limits<int>::max()), glm::ivec3(0)}) {}

    void add(const Array3f& field, float threshold) {
        std::size_t i = 0;
        for (int z = 0; z < field.size.z; ++z) {
            for (int y = 0; y < field.size.y; ++y) {
                for (int x = 0; x < field.size.x; ++x, ++i) {
                    if (field.values[i] <= threshold) continue;
                    CellBox& box = boxes_.at(x / cells_.x, y / cells_.y, z / cells_.z);
                    box.lower = glm::min(box.lower, glm::ivec3(x, y, z));
                    box.upper = glm::max(box.upper, glm::ivec3(x, y, z) + 1);
                }
            }
        }
    }
    const std::vector<CellBox>& boxes() const { return boxes_.values; }

  private:
    glm::ivec3 cells_;
    Array3<CellBox> boxes_;
};

/// Of the species that count, a box for each block.
std::vector<BoxM> boxesOf(const std::vector<SeenPart>& parts, auto&& counts) {
    std::vector<BoxM> boxes;
    int block = -1;
    for (const SeenPart& part : parts) {
        if (!counts(part.species)) continue;
        if (part.block == block) {
            boxes.back().lowerM = glm::min(boxes.back().lowerM, part.box.lowerM);
            boxes.back().upperM = glm::max(boxes.back().upperM, part.box.upperM);
        } else {
            boxes.push_back(part.box);
        }
        block = part.block;
    }
    return boxes;
}

}  // namespace

std::vector<SeenPart> seenParts(const SpeciesVolume& volume) {
    const RegularGrid& grid = volume.grid;
    std::vector<SeenPart> parts;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        const SpeciesInfo& known = info(species);
        const float m2PerKg = glsl::massExtinctionM2PerKg(known.radiusM, known.densityKgPerM3);
        SeenBlocks blocks(grid);
        blocks.add(volume.contentKgPerM3[s], kVisibleExtinctionPerM / m2PerKg);
        blocks.add(volume.extinctionPerM[s], kVisibleExtinctionPerM);
        int block = 0;
        for (const CellBox& box : blocks.boxes()) {
            const BoxM boxM{grid.originM + glm::dvec3(box.lower) * grid.spacingM,
                            grid.originM + glm::dvec3(box.upper) * grid.spacingM};
            if (box.upper.x != 0) parts.push_back({block, species, boxM});
            ++block;
        }
    }
    std::ranges::stable_sort(parts, {}, &SeenPart::block);
    return parts;
}

CameraPose framed(View view, const CameraPose& pose, const VolumeSummary& shown, const Look& look,
                  double aspect) {
    std::vector<BoxM> boxes = boxesOf(shown.seen, [&look](Species s) {
        return look.of(s).visible && look.of(s).mixingScale > 0.0f;
    });
    if (boxes.empty()) boxes = boxesOf(shown.seen, [](Species) { return true; });
    if (boxes.empty()) boxes = {{shown.grid.originM, shown.grid.upperM()}};
    return viewOf(view, pose, shown.grid, boxes, aspect);
}

}  // namespace neph
