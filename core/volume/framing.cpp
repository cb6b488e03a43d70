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

}  // namespace

std::vector<BoxM> seenParts(const SpeciesVolume& volume) {
    const RegularGrid& grid = volume.grid;
    SeenBlocks blocks(grid);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const SpeciesInfo& known = info(static_cast<Species>(s));
        const float m2PerKg = glsl::massExtinctionM2PerKg(known.radiusM, known.densityKgPerM3);
        blocks.add(volume.contentKgPerM3[s], kVisibleExtinctionPerM / m2PerKg);
        blocks.add(volume.extinctionPerM[s], kVisibleExtinctionPerM);
    }
    std::vector<BoxM> parts;
    for (const CellBox& box : blocks.boxes()) {
        if (box.upper.x == 0) continue;
        parts.push_back({grid.originM + glm::dvec3(box.lower) * grid.spacingM,
                         grid.originM + glm::dvec3(box.upper) * grid.spacingM});
    }
    return parts;
}

CameraPose framed(View view, const CameraPose& pose, const VolumeSummary& shown, double aspect) {
    if (!shown.seen.empty()) return viewOf(view, pose, shown.grid, shown.seen, aspect);
    const BoxM whole{shown.grid.originM, shown.grid.upperM()};
    return viewOf(view, pose, shown.grid, {&whole, 1}, aspect);
}

}  // namespace neph
