// grads_file.cpp: finds descriptors, and the descriptor of a data file.
#include "readers/raw_les/grads_file.h"

#include <algorithm>
#include <filesystem>

#include "readers/raw_les/grads_contents.h"
#include "readers/raw_les/grads_data.h"

namespace les {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

}  // namespace

int scoreCtl(const std::string& path) {
    constexpr int kOther = 5;
    constexpr int kModelOutput = 80;
    const auto text = findText(path);
    if (!text || !looksLikeCtl(*text)) return 0;
    try {
        const Ctl ctl = parseCtl(*text);
        return ctl.z.count > 1 && ctl.x.count * ctl.y.count > 1 ? kModelOutput : kOther;
    } catch (const Error&) {
        return kOther;
    }
}

std::unique_ptr<plugin::File> openGrads(const std::string& ctlPath) {
    try {
        return makeGrads(ctlPath, parseCtl(readText(ctlPath)));
    } catch (Error& error) {
        if (error.where.empty()) error.where = ctlPath;
        throw;
    }
}

std::vector<std::string> modelCtls(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (entry.path().extension() != ".ctl") continue;
        const auto text = findText(path);
        if (!text || !looksLikeCtl(*text)) continue;
        try {
            if (hasHydrometeor(parseCtl(*text))) found.push_back(path);
        } catch (const Error&) {  // opening it by name reports what is wrong
        }
    }
    std::ranges::sort(found);
    // The same fields interpolated to other levels, beside those of the model.
    std::vector<std::string> wanted;
    for (const std::string& path : found) {
        const bool interpolated =
            path.ends_with("_i.ctl") &&
            std::ranges::binary_search(found, path.substr(0, path.size() - 6) + "_s.ctl");
        if (!interpolated) wanted.push_back(path);
    }
    return wanted;
}

std::optional<std::string> findCtlOf(const std::string& path) {
    constexpr std::size_t kMaxFileNames = 10'000;  // file names tried per descriptor
    std::error_code error;
    const std::string folder = folderOf(path);
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".ctl") continue;
        try {
            const Ctl ctl = parseCtl(readText(entry.path().string()));
            const std::size_t times = ctl.isTemplate ? std::min(ctl.t.count, kMaxFileNames) : 1;
            for (std::size_t i = 0; i < times; ++i) {
                if (fs::path(dataPath(ctl, folder, i)) == path) return entry.path().string();
            }
        } catch (const Error&) {  // another kind of .ctl
        }
    }
    return {};
}

}  // namespace les
