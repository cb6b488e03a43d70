// shader_source.h: a GLSL file with its includes put in, and the way back from a line to the file
// it came from.
//
// Mesa loses the file numbers of #line in some errors, so includes are flattened here and errors
// mapped back.
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
    std::vector<std::filesystem::path> files;  ///< everything read, the main file first
    std::vector<SourceLine> lines;             ///< origin of each line of `text`

    /// Replaces "0:12(3)" and "0(12)" line references in a driver's log by file names and lines.
    std::string explain(const std::string& driverLog) const;
};

/// Reads `root / file`; `#include "x"` is looked up beside the including file, then under `root`,
/// then beside `root`; each file once. `defines` ("NOISE 1") go below #version. Throws Error for a
/// missing file.
ShaderSource loadShader(const std::filesystem::path& root, const std::filesystem::path& file,
                        const std::vector<std::string>& defines);

}  // namespace neph::gl
