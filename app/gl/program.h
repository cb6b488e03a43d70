// program.h: compute programs that can be edited while they are in use: after an edit that does not
// compile, the previous program stays.
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

/// A linked compute program, and the files that it was built from.
class Program {
  public:
    /// Throws Error with file, line and reason if it does not compile or link, or if two of its
    /// textures, images or buffers share a binding. `defines` are as for loadShader().
    Program(const std::filesystem::path& root, const std::string& file,
            const std::vector<std::string>& defines);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Runs enough work groups to cover `items` invocations; the size of a group is the shader's.
    void dispatch(glm::ivec3 items) const;
    /// Runs work groups [first, first + count), in as many dispatches as needed, because drivers
    /// accept 65535 groups per dispatch. The uniform at kFirstGroupLocation is the number of the
    /// first.
    void dispatchGroups(int count, int first = 0) const;
    void setInt(int location, int value) const { glProgramUniform1i(name_, location, value); }
    void setFloat(int location, float value) const { glProgramUniform1f(name_, location, value); }
    void setMat3(int location, const glm::mat3& value) const {
        glProgramUniformMatrix3fv(name_, location, 1, GL_FALSE, &value[0][0]);
    }
    void setIvec2(int location, glm::ivec2 value) const {
        glProgramUniform2i(name_, location, value.x, value.y);
    }
    void setIvec3(int location, glm::ivec3 value) const {
        glProgramUniform3i(name_, location, value.x, value.y, value.z);
    }
    void setVec3(int location, glm::vec3 value) const {
        glProgramUniform3f(name_, location, value.x, value.y, value.z);
    }

    /// Latest modification time of the files: when the program was compiled, and now.
    std::filesystem::file_time_type newest() const { return newest_; }
    std::filesystem::file_time_type newestOnDisk() const;

  private:
    GLuint name_ = 0;
    glm::ivec3 groupSize_{1};
    std::vector<std::filesystem::path> files_;
    std::filesystem::file_time_type newest_;
};

/// Programs by file and defines, each compiled at first use.
class ProgramCache {
  public:
    explicit ProgramCache(std::filesystem::path root) : root_(std::move(root)) {}

    /// Throws Error if the program has never compiled successfully.
    const Program& get(const std::string& file, const std::vector<std::string>& defines = {});

    const std::filesystem::path& root() const { return root_; }

    /// Recompiles programs whose files have changed. Returns the error messages of those that fail;
    /// their previous versions stay in use. References to programs become invalid.
    std::vector<std::string> reload();
    /// Number of programs that reload() has replaced so far.
    int generation() const { return generation_; }

  private:
    struct Entry {
        std::string file;
        std::vector<std::string> defines;
        std::unique_ptr<Program> program;
        std::filesystem::file_time_type refused;  ///< modification time of the last failed edit
    };
    std::filesystem::path root_;
    std::map<std::string, Entry> entries_;
    int generation_ = 0;
};

}  // namespace neph::gl
