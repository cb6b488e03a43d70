// video.cpp: raw frames down a pipe.
#include "app/cli/render/video.h"

#include <fmt/format.h>

#include <chrono>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include "core/base/error.h"

namespace neph {
namespace {

/// H.264 at a quality at which its losses are hard to see (18 of 51), in the colours of HD video
/// [BT709] with the encoding of the frames (IEC 61966-2-1); the index at the front, so that it
/// plays before all is there.
std::vector<std::string> arguments(const std::filesystem::path& file, glm::ivec2 sizePx,
                                   double fps) {
    std::istringstream words(fmt::format(
        "-hide_banner -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i - -an "
        "-vf scale=out_color_matrix=bt709:out_range=tv -c:v libx264 -preset medium -crf 18 "
        "-pix_fmt yuv420p -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1 "
        "-movflags +faststart -f mp4",
        sizePx.x, sizePx.y, fps));
    std::vector<std::string> list{std::istream_iterator<std::string>(words), {}};
    list.push_back(file.string());
    return list;
}

}  // namespace

std::filesystem::path findFfmpeg() {
    if (const auto found = findProgram("ffmpeg")) return *found;
    throw Error({.what = "a video needs the program ffmpeg, which is not on the PATH",
                 .hint = "apt install ffmpeg, or write images: --out frames.png"});
}

glm::ivec2 videoSize(glm::ivec2 sizePx) {
    return sizePx / 2 * 2;
}

Video::Video(const std::filesystem::path& file, glm::ivec2 sizePx, double fps)
    : ffmpeg_(findFfmpeg(), arguments(file, sizePx, fps), {.niceness = 0, .takesInput = true}) {}

void Video::add(const Image8& band) {
    rows_.clear();
    rows_.reserve(band.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < band.rgba.size(); ++i) {
        if (i % 4 != 3) rows_.push_back(static_cast<std::byte>(band.rgba[i]));
    }
    if (!ffmpeg_.write(rows_)) fail();
}

void Video::finish(const Progress& progress) {
    ffmpeg_.closeInput();
    while (ffmpeg_.poll()) {
        if (!goOn(progress, 1.0)) throw Cancelled{};
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (ffmpeg_.status() != 0) fail();
}

void Video::fail() {
    ffmpeg_.cancel();
    const int status = ffmpeg_.wait();
    const std::string words = ffmpeg_.lastWords();
    throw Error({.where = "ffmpeg",
                 .what = fmt::format("the video could not be made; ffmpeg ended with {}", status),
                 .found = words,
                 .hint = "or write images: --out frames.png"});
}

}  // namespace neph
