// preset_placeholder.cpp: the camera of the preset, before the bundled storm.
#include "app/ui/presets/preset_placeholder.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/presets/preset_card.h"
#include "core/camera/camera.h"
#include "core/look/backdrop.h"
#include "core/look/haze.h"

namespace neph::ui {
namespace {

/// As large as the bundled storm, of which thumbnails are.
const RegularGrid kStormGrid{{110, 120, 60}, {0.0, 0.0, 0.0}, {1000.0, 1000.0, 335.5}};

/// Height in the image where the view is level with the horizon, [-1, 1] and beyond; by halving.
double horizonNdc(const Camera& camera, double horizonUp) {
    double lower = -1.0, upper = 1.0;
    for (int i = 0; i < 20; ++i) {
        const double middle = (lower + upper) / 2.0;
        (camera.rayDir({0.0, middle}).z < horizonUp ? lower : upper) = middle;
    }
    return (lower + upper) / 2.0;
}

/// Index of a corner of a mesh.
std::size_t cornerOf(int column, int row) {
    constexpr std::size_t kCorners = PresetPlaceholder::kColumns + 1;
    return static_cast<std::size_t>(row) * kCorners + static_cast<std::size_t>(column);
}

/// Colours between two heights of the image, from the top.
template <typename Mesh>
Mesh meshOf(const Camera& camera, double top, double bottom, auto colourOf) {
    constexpr int kAcross = PresetPlaceholder::kColumns;
    constexpr int kRows = static_cast<int>(std::tuple_size_v<Mesh>) / (kAcross + 1) - 1;
    Mesh mesh{};
    for (int j = 0; j <= kRows; ++j) {
        for (int i = 0; i <= kAcross; ++i) {
            const glm::dvec2 ndc{2.0 * i / kAcross - 1.0,
                                 std::lerp(top, bottom, static_cast<double>(j) / kRows)};
            mesh[cornerOf(i, j)] = colourOf(camera.rayDir(ndc));
        }
    }
    return mesh;
}

ImU32 packed(const glm::vec3& colour) {
    return ImGui::GetColorU32(ImVec4(colour.r, colour.g, colour.b, 1.0f));
}

template <typename Mesh>
void drawMesh(const Mesh& mesh, glm::vec2 lower, glm::vec2 upper) {
    constexpr int kAcross = PresetPlaceholder::kColumns;
    constexpr int kRows = static_cast<int>(std::tuple_size_v<Mesh>) / (kAcross + 1) - 1;
    if (upper.y <= lower.y) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](int i, int j) {
        return glm::mix(lower, upper, glm::vec2(i, j) / glm::vec2(kAcross, kRows));
    };
    const auto colour = [&](int i, int j) { return packed(mesh[cornerOf(i, j)]); };
    for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i < kAcross; ++i) {
            const glm::vec2 a = at(i, j), b = at(i + 1, j + 1);
            list.AddRectFilledMultiColor({a.x, a.y}, {b.x, b.y}, colour(i, j), colour(i + 1, j),
                                         colour(i + 1, j + 1), colour(i, j + 1));
        }
    }
}

}  // namespace

PresetPlaceholder placeholderOf(const Preset& preset) {
    const Camera camera = placeCamera(preset.camera.value_or(CameraPose{}), kStormGrid,
                                      static_cast<double>(kThumbnailAspect));
    const Backdrop backdrop(lookAsDrawn(preset.look, {}), camera.eyeWorld.z);
    const double level =
        preset.look.groundVisible ? horizonNdc(camera, backdrop.horizonUp()) : -1.0;
    PresetPlaceholder made;
    made.horizon = static_cast<float>((1.0 - level) / 2.0);
    made.sky = meshOf<decltype(made.sky)>(camera, 1.0, level,
                                          [&](const glm::dvec3& ray) { return backdrop.sky(ray); });
    made.ground = meshOf<decltype(made.ground)>(camera, level, -1.0, [&](const glm::dvec3& ray) {
        return backdrop.ground(ray).value_or(glm::vec3(0.0f));
    });
    return made;
}

void drawPlaceholder(const PresetPlaceholder& placeholder, glm::vec2 lower, glm::vec2 upper) {
    const float edge = std::lerp(lower.y, upper.y, placeholder.horizon);
    drawMesh(placeholder.sky, lower, {upper.x, edge});
    drawMesh(placeholder.ground, {lower.x, edge}, upper);
}

}  // namespace neph::ui
