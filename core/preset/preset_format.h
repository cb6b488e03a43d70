// preset_format.h: how a preset is spelled in its file; shared by its reader and its writer.
#pragma once
#include <string_view>

namespace neph {

inline constexpr std::string_view kPresetType = "nephoscope-look";
inline constexpr int kPresetVersion = 1;

}  // namespace neph
