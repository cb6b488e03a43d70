// noise.cpp: bakes a tile of detail noise, slab by slab on all cores.
#include "core/optics/noise.h"

#include <algorithm>
#include <thread>
#include <vector>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

/// Every step-th slab from `first` on, so that threads share the work without locks.
void bakeSlabs(NoiseCharacter character, Array3f& tile, int first, int step) {
    const auto size = static_cast<float>(tile.size.x);
    for (int z = first; z < tile.size.z; z += step) {
        for (int y = 0; y < tile.size.y; ++y) {
            for (int x = 0; x < tile.size.x; ++x) {
                const glm::vec3 p = (glm::vec3(x, y, z) + 0.5f) / size;
                tile.at(x, y, z) =
                    character == NoiseCharacter::billow ? glsl::billow(p) : glsl::wisp(p);
            }
        }
    }
}

}  // namespace

Array3f bakeNoise(NoiseCharacter character, int size) {
    Array3f tile(glm::ivec3(size), 0.0f);
    const int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::jthread> threads;
    threads.reserve(static_cast<std::size_t>(workers));
    for (int i = 0; i < workers; ++i) {
        threads.emplace_back([&, i] { bakeSlabs(character, tile, i, workers); });
    }
    threads.clear();  // joins
    return tile;
}

}  // namespace neph
