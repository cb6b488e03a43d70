// film.h: pictures to an MP4 (H.264), through an ffmpeg of the user's.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/progress.h"
#include "core/image/image.h"

namespace neph {

/// Throws Error, which says what to do, where there is no ffmpeg on $PATH.
std::filesystem::path findFfmpeg();

/// 4:2:0 video has even sides: the largest such size within `sizePx`.
glm::ivec2 filmSize(glm::ivec2 sizePx);

class Film {
  public:
    /// Begins to write `file`, of pictures of `sizePx`, both even, shown for 1 / `fps` s each.
    Film(const std::filesystem::path& file, glm::ivec2 sizePx, double fps);
    ~Film() { ffmpeg_.end(); }
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// The next rows of a picture, from the top; the next picture begins where one is whole. Throws
    /// Error with ffmpeg's own words.
    void add(const Image8& band);
    /// Waits for the file; throws Error, or Cancelled.
    void finish(const Progress& progress);

  private:
    [[noreturn]] void fail();

    ChildProcess ffmpeg_;
    std::vector<std::byte> rows_;  // kept for its memory
};

}  // namespace neph
