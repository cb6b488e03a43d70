// bench_request.h: what `nephoscope bench` is asked for. Filled once, by bench_arguments.cpp.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/common/scene.h"
#include "core/look/look.h"

namespace neph::bench {

enum class Section : int { modes, changes, growth, window, reference };
/// Spelling of each on the command line and in the result.
inline constexpr std::array<std::string_view, 5> kSectionNames{"modes", "changes", "growth",
                                                               "window", "reference"};

/// Cells asked for: of the longest side, or of each; one of the two is zero.
struct GridRequest {
    int longest = 0;
    glm::ivec3 size{0};
};

/// Engines of which one frame is an image.
std::vector<Engine> measuredEngines();

struct BenchRequest {
    SceneRequest scene;
    std::vector<Section> sections{Section::modes, Section::changes};
    std::vector<glm::ivec2> sizesPx;  ///< none: each section's own
    std::vector<GridRequest> grids{{128, {}}};
    std::vector<Engine> engines = measuredEngines();
    int steps = 128;        ///< or slices, along the diagonal of what is occupied; [Riley03] §5
    int frames = 12;        ///< measured of each row, evenly round the storm
    int growthTo = 256;     ///< cells along the longest side of the largest grid of `growth`
    std::string json;       ///< file for the result; empty: stdout
    bool openOnly = false;  ///< opening and the first image alone
};

}  // namespace neph::bench
