// preset_format.h: constants of the preset file format, shared by its reader and its writer.
#pragma once
#include <string_view>

namespace neph {

inline constexpr std::string_view kPresetType = "nephoscope-look";
inline constexpr int kPresetVersion = 1;

}  // namespace neph
