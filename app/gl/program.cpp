// program.cpp: compiles, links, dispatches and reloads compute programs.
#include "app/gl/program.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/gl/binding_check.h"
#include "app/gl/shader_source.h"
#include "core/base/error.h"

namespace neph::gl {
namespace {

namespace fs = std::filesystem;

/// The driver's log of a shader or a program.
std::string logOf(GLuint object, bool program) {
    GLint length = 0;
    program ? glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length)
            : glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    program ? glGetProgramInfoLog(object, length, nullptr, text.data())
            : glGetShaderInfoLog(object, length, nullptr, text.data());
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

fs::file_time_type newestOf(const std::vector<fs::path>& files) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const fs::path& file : files) {
        std::error_code ignored;  // an editor may be replacing the file
        newest = std::max(newest, fs::last_write_time(file, ignored));
    }
    return newest;
}

GLuint compile(const ShaderSource& source, const std::string& file) {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    const std::string reason = source.explain(logOf(shader, false));
    glDeleteShader(shader);
    throw Error({"shader " + file, "does not compile", reason, "", ""});
}

}  // namespace

Program::Program(const fs::path& root, const std::string& file,
                 const std::vector<std::string>& defines) {
    const ShaderSource source = loadShader(root, file, defines);
    files_ = source.files;
    newest_ = newestOf(files_);
    const GLuint shader = compile(source, file);
    name_ = glCreateProgram();
    glAttachShader(name_, shader);
    glLinkProgram(name_);
    glDeleteShader(shader);
    GLint ok = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &ok);
    if (!ok) {
        const std::string reason = source.explain(logOf(name_, true));
        glDeleteProgram(name_);
        throw Error({"shader " + file, "does not link", reason, "", ""});
    }
    if (const std::string shared = sharedBinding(name_); !shared.empty()) {
        glDeleteProgram(name_);
        throw Error({"shader " + file, "two of its resources share a binding", shared,
                     "a binding of its own for each", "see shaders/shared/*_layout.glsl"});
    }
    glGetProgramiv(name_, GL_COMPUTE_WORK_GROUP_SIZE, &groupSize_[0]);
}

Program::~Program() {
    glDeleteProgram(name_);
}

void Program::dispatch(glm::ivec3 items) const {
    const glm::ivec3 groups = (items + groupSize_ - 1) / groupSize_;
    glUseProgram(name_);
    glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y),
                      static_cast<GLuint>(groups.z));
}

void Program::dispatchGroups(int count, int first) const {
    constexpr int kMaxGroups = 65535;  // in one direction, on every driver
    glUseProgram(name_);
    for (const int end = first + count; first < end; first += kMaxGroups) {
        setInt(kFirstGroupLocation, first);
        glDispatchCompute(static_cast<GLuint>(std::min(kMaxGroups, end - first)), 1, 1);
    }
}

fs::file_time_type Program::newestOnDisk() const {
    return newestOf(files_);
}

const Program& ProgramCache::get(const std::string& file, const std::vector<std::string>& defines) {
    const std::string key = fmt::format("{}|{}", file, fmt::join(defines, "|"));
    Entry& entry = entries_[key];
    if (!entry.program) {
        entry.file = file;
        entry.defines = defines;
        entry.program = std::make_unique<Program>(root_, file, defines);
    }
    return *entry.program;
}

std::vector<std::string> ProgramCache::reload() {
    std::vector<std::string> problems;
    for (auto& [key, entry] : entries_) {
        if (!entry.program || entry.program->newestOnDisk() <= entry.program->newest()) continue;
        const fs::file_time_type now = entry.program->newestOnDisk();
        if (now == entry.refused) continue;  // reported already
        try {
            entry.program = std::make_unique<Program>(root_, entry.file, entry.defines);
            ++generation_;
        } catch (const Error& error) {
            entry.refused = now;
            problems.push_back(error.message());
        }
    }
    return problems;
}

}  // namespace neph::gl
