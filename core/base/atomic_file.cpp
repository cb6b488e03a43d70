// atomic_file.cpp: write to a temporary file, fsync, rename (POSIX).
#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace neph {
namespace {

/// The one error of this file: names the target, never the temporary file.
[[noreturn]] void refuse(const std::filesystem::path& target, int errorNumber) {
    throw Error({target.string(), "cannot be written", std::strerror(errorNumber), "",
                 "name a file in a folder that exists and that you may write to"});
}

/// The temporary file must be in the same folder, because rename() does not cross file systems.
std::filesystem::path folderOf(const std::filesystem::path& target) {
    return target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
}

/// A new empty file beside `target`. mkstemp creates it private, so it gets the usual mode first.
std::filesystem::path createAside(const std::filesystem::path& target) {
    std::string name =
        (folderOf(target) / ("." + target.filename().string().substr(0, 200) + ".XXXXXX")).string();
    const int file = ::mkstemp(name.data());
    if (file < 0) refuse(target, errno);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(file, 0666 & ~mask);
    ::close(file);
    return name;
}

/// Without this, a crash soon after the rename could leave an empty file.
void flushToDisk(const std::filesystem::path& aside, const std::filesystem::path& target) {
    const int file = ::open(aside.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) refuse(target, errno);
    const int failed = ::fsync(file);
    const int errorNumber = errno;
    ::close(file);
    // Some file systems cannot flush single files; that is no reason to lose the result.
    if (failed != 0 && errorNumber != EINVAL && errorNumber != ENOSYS) refuse(target, errorNumber);
}

/// Writes all of `text`; a signal may split it into several calls.
void writeText(const std::filesystem::path& aside, const std::filesystem::path& target,
               std::string_view text) {
    const int file = ::open(aside.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) refuse(target, errno);
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            const int errorNumber = errno;
            ::close(file);
            refuse(target, errorNumber);
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::close(file) != 0) refuse(target, errno);
}

}  // namespace

void checkReplaceable(const std::filesystem::path& target) {
    std::error_code fault;
    if (target.filename().empty() || std::filesystem::is_directory(target, fault)) {
        throw Error({target.string(), "cannot be written", "a folder", "the name of a file", ""});
    }
    const std::filesystem::path folder = folderOf(target);
    const bool isFolder = std::filesystem::is_directory(folder, fault);
    if (!isFolder && fault != std::errc::permission_denied) {
        throw Error({target.string(), "cannot be written", "no folder " + folder.string(), "",
                     "make the folder first"});
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) refuse(target, errno);
}

void replaceFile(const std::filesystem::path& target,
                 const std::function<void(const std::filesystem::path& aside)>& write) {
    checkReplaceable(target);
    const std::filesystem::path aside = createAside(target);
    try {
        write(aside);
        flushToDisk(aside, target);
        if (::rename(aside.c_str(), target.c_str()) != 0) refuse(target, errno);
    } catch (...) {
        ::unlink(aside.c_str());
        throw;
    }
}

void replaceFile(const std::filesystem::path& target, std::string_view text) {
    replaceFile(target,
                [&](const std::filesystem::path& aside) { writeText(aside, target, text); });
}

}  // namespace neph
