// ini.h: MicroHH's .ini files: sections, keys and values. Total and linear in the text.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace raw {

/// By "section/key"; the first of a key counts; comments start with #.
std::map<std::string, std::string> parseIni(std::string_view text);

}  // namespace raw
