// profile_text.h: numbers of an image's cost put into words and units, once for window and
// terminal.
#pragma once
#include <string>

#include "app/render/renderer.h"
#include "app/ui/widgets/profile.h"

namespace neph {

/// Of an image that was drawn with FrameInputs::profile; the renderer tells device and memory.
ui::Profile profileOf(const render::FrameStats& stats, const render::FrameInputs& inputs,
                      const render::Renderer& renderer);

/// Lines in aligned columns, each ended.
std::string profileText(const ui::Profile& profile);

/// Adds times and counts of one more sample of the same image.
void addSample(render::FrameStats& all, const render::FrameStats& sample);

}  // namespace neph
