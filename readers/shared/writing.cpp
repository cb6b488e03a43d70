// writing.cpp: the age of the last change, and the locks that the kernel lists.
#include "readers/shared/writing.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <ctime>
#include <fstream>
#include <sstream>

namespace shared {
namespace {

// A model that writes a time every few minutes touches its file at least this often while it
// writes one; a choice.
constexpr double kRecentSeconds = 120.0;

/// The process that holds a lock for writing on the file; nothing if none is listed. Lines of
/// /proc/locks: "1: FLOCK  ADVISORY  WRITE 4711 fe:00:131234 0 EOF".
std::optional<long> writerOf(const struct stat& file) {
    const std::string wanted =
        fmt::format("{:02x}:{:02x}:{}", major(file.st_dev), minor(file.st_dev), file.st_ino);
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        std::istringstream words(line);
        std::string number, kind, mode, access, place;
        long process = 0;
        words >> number >> kind >> mode >> access >> process >> place;
        if (words && access == "WRITE" && place == wanted) return process;
    }
    return {};
}

}  // namespace

std::optional<std::string> beingWritten(const std::string& path) {
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0) return {};
    if (const auto process = writerOf(file)) {
        return fmt::format("process {} has locked it for writing", *process);
    }
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    const double age = static_cast<double>(now.tv_sec - file.st_mtim.tv_sec) +
                       1e-9 * static_cast<double>(now.tv_nsec - file.st_mtim.tv_nsec);
    if (age < 0.0 || age > kRecentSeconds) return {};
    return fmt::format("it changed {:.0f} s ago", age);
}

}  // namespace shared
