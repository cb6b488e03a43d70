// output_plan.cpp: from settings to arguments and file names.
#include "app/ui/output/output_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace neph::ui {
namespace {

constexpr glm::ivec2 kHdPx{1920, 1080}, kUhdPx{3840, 2160};
constexpr std::string_view kEndings[] = {".png", ".exr", ".mp4"};

/// "name_0012.png" is an image of the series "name.png".
bool isOfSeries(const std::filesystem::path& file, const std::filesystem::path& series) {
    const std::string name = file.stem().string(), stem = series.stem().string() + "_";
    if (file.extension() != series.extension() || !name.starts_with(stem)) return false;
    const std::string_view number = std::string_view(name).substr(stem.size());
    return number.size() >= 4 &&
           std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

bool taken(const std::filesystem::path& file, bool series) {
    std::error_code fault;
    if (std::filesystem::exists(file, fault)) return true;
    if (!series) return false;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    for (const auto& entry : std::filesystem::directory_iterator(folder, fault)) {
        if (isOfSeries(entry.path(), file)) return true;
    }
    return false;
}

}  // namespace

glm::ivec2 sizeOf(const ExportSettings& settings, const ExportScene& scene) {
    switch (settings.size) {
        case ExportSize::window:
            return scene.windowPx;
        case ExportSize::hd:
            return kHdPx;
        case ExportSize::uhd:
            return kUhdPx;
        case ExportSize::own:
            return settings.ownPx;
    }
    return scene.windowPx;
}

std::vector<std::string> exportArguments(const ExportSettings& settings, const ExportScene& scene,
                                         const std::filesystem::path& session,
                                         const std::filesystem::path& out) {
    const glm::ivec2 sizePx = sizeOf(settings, scene);
    std::vector<std::string> arguments{"render", "--progress", "--session", session.string()};
    const auto add = [&](std::initializer_list<std::string> more) {
        arguments.insert(arguments.end(), more);
    };
    if (scene.split && settings.bothSides) {
        add({"--compare"});
    } else {
        add({"--slot", std::to_string(scene.slot)});
    }
    if (settings.what == ExportWhat::times) add({"--time", "all"});
    if (settings.what == ExportWhat::path) add({"--along-path"});
    const bool video = settings.format == ExportFormat::mp4;
    if (settings.what == ExportWhat::path || (video && settings.what == ExportWhat::times)) {
        add({"--fps", fmt::format("{}", settings.fps)});
    }
    add({"--size", fmt::format("{}x{}", sizePx.x, sizePx.y)});
    add({"--supersample", std::to_string(settings.supersample)});
    if (scene.averages) add({"--samples", std::to_string(settings.samples)});
    if (settings.transparent && !video) add({"--transparent"});
    for (const std::string& reader : scene.readers) add({"--reader", reader});
    add({"--out", out.string()});
    return arguments;
}

std::string exportFault(const ExportSettings& settings, const Session& session) {
    if (session.info() == nullptr) return "There are no data yet.";
    if (settings.format == ExportFormat::mp4) {
        if (!findProgram("ffmpeg")) {
            return "A video needs the program ffmpeg, which is not on the PATH (apt install "
                   "ffmpeg). Images need none.";
        }
        if (settings.what == ExportWhat::image) {
            return "A video is made of all times, or of images along the path.";
        }
    }
    if (settings.what == ExportWhat::path && session.document.path.keys.empty()) {
        return "There is no camera path: set its keys in the camera panel.";
    }
    if (settings.file.empty()) return "A file needs a name.";
    return {};
}

std::filesystem::path defaultExportFile() {
    std::error_code fault;
    std::filesystem::path folder = std::filesystem::current_path(fault);
    if (const char* home = std::getenv("HOME"); home != nullptr) {
        const auto images = std::filesystem::path(home) / "Images";
        if (std::filesystem::is_directory(images, fault)) folder = images;
    }
    return folder / "nephoscope.png";
}

std::filesystem::path withEnding(std::filesystem::path file, ExportFormat format) {
    const std::string ending = file.extension().string();
    const std::string_view wanted = kEndings[static_cast<std::size_t>(format)];
    // What follows another dot is part of the name: "0001-01-01.5 km".
    if (std::ranges::find(kEndings, ending) != std::end(kEndings)) file.replace_extension();
    file += wanted;
    return file;
}

std::filesystem::path freeFile(const std::filesystem::path& file, bool series) {
    std::filesystem::path free = file;
    for (int number = 2; taken(free, series); ++number) {
        free = file.parent_path() /
               fmt::format("{}-{}{}", file.stem().string(), number, file.extension().string());
    }
    return free;
}

}  // namespace neph::ui
