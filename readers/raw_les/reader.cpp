// reader.cpp: entry point of the raw reader: recognises which of the three formats a path has, and
// reports what to open instead of a file that is only part of a data set.
#include <filesystem>
#include <functional>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/brick_file.h"
#include "readers/raw_les/grads_file.h"
#include "readers/raw_les/microhh_case.h"

namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

constexpr int kPart = 5;    // part of a data set: opening it reports what to open
constexpr int kWhole = 80;  // a folder with exactly one data set

bool isFolder(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// Descriptors in a folder. A single one is the data set; of several, the user must choose.
std::vector<std::string> descriptors(const std::string& folder) {
    std::vector<std::string> found = les::modelCtls(folder);
    for (std::string& sidecar : les::sidecars(folder)) found.push_back(std::move(sidecar));
    return found;
}

int scoreOf(const std::string& path) {
    if (const int score = les::scoreMicrohh(path); score > 0) return score;
    if (isFolder(path)) {
        const std::size_t count = descriptors(path).size();
        return count == 1 ? kWhole : count > 1 ? kPart : 0;
    }
    if (const int score = les::scoreCtl(path); score > 0) return score;
    if (const int score = les::scoreSidecar(path); score > 0) return score;
    return les::findCtlOf(path) ? kPart : 0;
}

std::unique_ptr<plugin::File> openPath(const std::string& path) {
    if (les::scoreMicrohh(path) > 0) return les::openMicrohh(path);
    if (isFolder(path)) {
        const auto found = descriptors(path);
        if (found.size() == 1) return openPath(found.front());
        throw les::Error{found.empty() ? "contains no descriptor of raw model output"
                                       : "contains several descriptors of model output",
                         les::joined(found), "one .ctl or one nephoscope-brick sidecar",
                         found.empty() ? "" : "open one of them"};
    }
    if (les::scoreSidecar(path) > 0) return les::openBrick(path);
    if (les::scoreCtl(path) > 0) return les::openGrads(path);
    const auto ctl = les::findCtlOf(path);
    throw les::Error{"contains numbers without a header",
                     {},
                     "the descriptor of such a file",
                     ctl ? "open " + *ctl : "open its .ctl"};
}

int score(const char* path) {
    return scoreOf(path);
}

std::unique_ptr<plugin::File> open(const char* path) {
    return openPath(path);
}

constexpr plugin::Reader kReader{
    "raw_les",
    "1.1",
    "raw LES output (CM1 and other GrADS .ctl, MicroHH case, nephoscope-brick)",
    "ctl ini json",
    &score,
    &open};

}  // namespace

NEPHOSCOPE_READER(kReader)
