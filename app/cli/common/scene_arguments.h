// scene_arguments.h: the arguments that several commands share: data, look, camera, place.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/common/scene.h"

namespace neph {

void addReaderOption(CLI::App& command, std::vector<std::string>& readers);
void addMemoryOption(CLI::App& command, std::string& memory);

/// All of a scene; FILE is positional.
void addSceneOptions(CLI::App& command, SceneOptions& options);

/// A place or a side to look from, as parseRenderView.
void addViewOptions(CLI::App& command, std::string& observer, std::string& view);

}  // namespace neph
