// services.h: what the window does for panels, which know neither GL nor image files.
#pragma once
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/plot/figure.h"
#include "core/plot/table.h"
#include "core/session/session_state.h"

namespace neph::ui {

/// An image as a texture.
struct LoadedImage {
    unsigned texture = 0;  ///< for ImGui; 0 where the file could not be read
    glm::ivec2 sizePx{0};
};

/// Empty in tests.
struct Services {
    std::function<LoadedImage(const std::filesystem::path& png)> loadImage;
    std::function<LoadedImage(const Image8& image)> showImage;
    std::function<void(unsigned texture)> dropImage;
    /// Writes plots side by side, or their numbers, by the name's extension, where the last export
    /// went under a name that is free there, or to the file that an absolute path names; returns
    /// the file. Throws Error.
    std::function<std::string(const std::string& name, const std::vector<plot::Figure>& figures,
                              const plot::Table& table)>
        savePlots;
    /// What a session file would hold now; panels hand it to what runs beside the program.
    std::function<SessionState()> state;
    /// Takes over a session file's state. Another session may be the active one from then on.
    std::function<void(const SessionState&)> restore;
};

}  // namespace neph::ui
