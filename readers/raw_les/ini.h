// ini.h: MicroHH's .ini files: sections, keys and values. Any text can be parsed, in linear time.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace les {

/// Values by "section/key". The first occurrence of a key counts; comments start with #.
std::map<std::string, std::string> parseIni(std::string_view text);

}  // namespace les
