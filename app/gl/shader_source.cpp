// shader_source.cpp: flattens includes and maps compiler messages back to files and lines.
#include "app/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/base/error.h"

namespace neph::gl {
namespace {

namespace fs = std::filesystem;

/// Appends a file and, recursively, its includes to a ShaderSource.
class Flattener {
  public:
    Flattener(fs::path root, const std::vector<std::string>& defines, ShaderSource& out)
        : root_(std::move(root)), defines_(defines), out_(out) {}

    void add(const fs::path& file) {
        std::ifstream stream(file);
        if (!stream) throw Error({file.string(), "shader file cannot be read", "", "", ""});
        const int index = static_cast<int>(out_.files.size());
        out_.files.push_back(fs::weakly_canonical(file));
        std::string line;
        for (int number = 1; std::getline(stream, line); ++number) {
            if (const std::string target = included(line); !target.empty()) {
                include(file, target, number);
            } else if (!line.starts_with("#pragma once")) {
                emit(line, {index, number});
                if (line.starts_with("#version")) emitDefines({index, number});
            }
        }
    }

  private:
    /// The target if `line` is an #include directive; otherwise empty.
    static std::string included(const std::string& line) {
        static const std::regex pattern(R"re(^\s*#include\s+"([^"]+)")re");
        std::smatch match;
        return std::regex_search(line, match, pattern) ? match[1].str() : std::string();
    }

    void include(const fs::path& from, const std::string& target, int line) {
        for (const fs::path& dir : {from.parent_path(), root_, root_.parent_path()}) {
            const fs::path candidate = fs::weakly_canonical(dir / target);
            if (!fs::is_regular_file(candidate)) continue;
            const bool seen =
                std::find(out_.files.begin(), out_.files.end(), candidate) != out_.files.end();
            if (!seen) add(candidate);
            return;
        }
        throw Error({fmt::format("{}:{}", from.string(), line),
                     fmt::format("included file {} does not exist", target), "", "", ""});
    }

    void emitDefines(SourceLine origin) {
        for (const std::string& define : defines_) emit("#define " + define, origin);
    }

    void emit(const std::string& line, SourceLine origin) {
        out_.text += line + "\n";
        out_.lines.push_back(origin);
    }

    fs::path root_;
    const std::vector<std::string>& defines_;
    ShaderSource& out_;
};

}  // namespace

ShaderSource loadShader(const fs::path& root, const fs::path& file,
                        const std::vector<std::string>& defines) {
    ShaderSource source;
    Flattener(root, defines, source).add(root / file);
    return source;
}

std::string ShaderSource::explain(const std::string& driverLog) const {
    // Mesa writes "0:12(3): error: …", NVIDIA "0(12) : error …".
    static const std::regex pattern(R"(^0(?::(\d+)\(\d+\)|\((\d+)\)))");
    std::istringstream in(driverLog);
    std::string out, line;
    while (std::getline(in, line)) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) {
            const std::size_t number = std::stoul(match[1].matched ? match[1] : match[2]);
            if (number >= 1 && number <= lines.size()) {
                const SourceLine origin = lines[number - 1];
                const auto& name = files[static_cast<std::size_t>(origin.file)];
                line = fmt::format("{}:{}{}", name.filename().string(), origin.line,
                                   match.suffix().str());
            }
        }
        out += (out.empty() ? "" : "\n") + line;
    }
    return out;
}

}  // namespace neph::gl
