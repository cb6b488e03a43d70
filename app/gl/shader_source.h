// shader_source.h: a GLSL file with its includes inserted, and a map from its lines to the files
// that they come from.
//
// Mesa omits the file number of #line in some messages. So includes are flattened here, and the
// lines of messages are mapped back.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace neph::gl {

struct SourceLine {
    int file = 0;  ///< index into ShaderSource::files
    int line = 0;  ///< from 1
};

struct ShaderSource {
    std::string text;
    std::vector<std::filesystem::path> files;  ///< all files read, the main file first
    std::vector<SourceLine> lines;             ///< origin of each line of `text`

    /// Replaces line references such as "0:12(3)" and "0(12)" in a driver's log by file and line.
    std::string explain(const std::string& driverLog) const;
};

/// Reads `root / file`. `#include "x"` is searched in the folder of the including file, then in
/// `root`, then in the folder of `root`; each file is included once. `defines` ("NOISE 1") are
/// inserted below #version. Throws Error for a missing file.
ShaderSource loadShader(const std::filesystem::path& root, const std::filesystem::path& file,
                        const std::vector<std::string>& defines);

}  // namespace neph::gl
