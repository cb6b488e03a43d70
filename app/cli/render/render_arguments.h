// render_arguments.h: the grammar of `nephoscope render`, and of what `compare` shares with it.
#pragma once
#include "app/cli/common/arguments.h"
#include "app/cli/render/render_request.h"

namespace neph {

Command addRender(CLI::App& app);

/// A place or a side to look from.
void addViewOptions(CLI::App& command, RenderView& from);
/// Throws UsageError where both are given.
void checkView(const RenderView& from);

void addSizeOption(CLI::App& command, glm::ivec2& sizePx, const std::string& help);

/// --planes of slicing, and --samples, --error and --seed.
void addSampleOptions(CLI::App& command, RenderRequest& request, const std::string& samplesHelp);

}  // namespace neph
