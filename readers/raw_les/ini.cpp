// ini.cpp: parses an .ini file line by line; a line that is neither section nor key is ignored.
#include "readers/raw_les/ini.h"

#include "readers/les/text.h"

namespace les {

std::map<std::string, std::string> parseIni(std::string_view text) {
    std::map<std::string, std::string> keys;
    std::string section;
    for (std::string_view line : splitLines(text)) {
        line = trimmed(line.substr(0, line.find('#')));
        if (line.starts_with('[') && line.ends_with(']')) {
            section = trimmed(line.substr(1, line.size() - 2));
            continue;
        }
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        keys.emplace(section + "/" + std::string(trimmed(line.substr(0, equals))),
                     trimmed(line.substr(equals + 1)));
    }
    return keys;
}

}  // namespace les
