// video.h: images to an MP4 (H.264), through an ffmpeg of the user's.
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
glm::ivec2 videoSize(glm::ivec2 sizePx);

class Video {
  public:
    /// Begins to write `file`, of images of `sizePx`, both even, shown for 1 / `fps` s each.
    Video(const std::filesystem::path& file, glm::ivec2 sizePx, double fps);
    ~Video() { ffmpeg_.end(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// The next rows of an image, from the top; the next image begins where one is whole. Throws
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
