// program.h: compute programs that survive a bad edit.
#pragma once
#include <epoxy/gl.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace neph::gl {

#include "shaders/shared/groups_layout.glsl"

/// A linked compute program and the files it was made of.
class Program {
  public:
    /// Throws Error with file, line and reason when it does not compile or link, or
    /// where two of its textures, images or buffers share a binding.
    Program(const std::filesystem::path& root, const std::string& file,
            const std::vector<std::string>& defines);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Runs enough work groups of `groupSize` to cover `items`.
    void dispatch(glm::ivec3 items) const;
    /// Runs work groups `first` to `first + count` in a row. Drivers take 65535 at a time: the
    /// number of the first is in the uniform at kFirstGroupLocation.
    void dispatchGroups(int count, int first = 0) const;
    void setInt(int location, int value) const { glProgramUniform1i(name_, location, value); }
    void setFloat(int location, float value) const { glProgramUniform1f(name_, location, value); }
    void setVec3(int location, glm::vec3 value) const {
        glProgramUniform3f(name_, location, value.x, value.y, value.z);
    }

    /// Newest change of the files it was made of: when they were compiled, and now.
    std::filesystem::file_time_type newest() const { return newest_; }
    std::filesystem::file_time_type newestOnDisk() const;

  private:
    GLuint name_ = 0;
    glm::ivec3 groupSize_{1};
    std::vector<std::filesystem::path> files_;
    std::filesystem::file_time_type newest_;
};

/// Programs by file and defines, compiled at first use.
class ProgramCache {
  public:
    explicit ProgramCache(std::filesystem::path root) : root_(std::move(root)) {}

    /// Throws Error when it has never compiled.
    const Program& get(const std::string& file, const std::vector<std::string>& defines = {});

    const std::filesystem::path& root() const { return root_; }

    /// Recompiles what changed on disk; returns the error messages of those that fail, which stay
    /// as they were. Programs obtained before are invalid afterwards.
    std::vector<std::string> reload();
    /// How many times anything was replaced by reload().
    int generation() const { return generation_; }

  private:
    struct Entry {
        std::string file;
        std::vector<std::string> defines;
        std::unique_ptr<Program> program;
        std::filesystem::file_time_type refused;  ///< when the last failed edit was seen
    };
    std::filesystem::path root_;
    std::map<std::string, Entry> entries_;
    int generation_ = 0;
};

}  // namespace neph::gl
