// trash.cpp: the note in Trash/info is created first, which reserves the name; then the file is
// moved to Trash/files.
#include "core/base/trash.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>

#include "core/base/error.h"
#include "core/base/resources.h"

namespace neph {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::string found) {
    throw Error({file.string(), "cannot be moved to the trash", std::move(found), "",
                 "remove the file yourself"});
}

/// The home trash of the specification; trash folders of other file systems are not used.
std::filesystem::path trashFolder(const std::filesystem::path& file) {
    const auto data = userDataDir();
    if (!data) refuse(file, "neither XDG_DATA_HOME nor HOME is set");
    return data->parent_path() / "Trash";
}

/// As in a URL: everything but letters, digits and a few signs becomes % and two hexadecimal
/// digits.
std::string percentEncoded(const std::string& path) {
    constexpr std::string_view kPlain = "/-_.~";
    std::string text;
    for (const char c : path) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool plain = letter || (c >= '0' && c <= '9') || kPlain.find(c) != kPlain.npos;
        text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

/// In local time, as the specification requires.
std::string nowText() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&now, &local);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &local);
    return text;
}

/// The .trashinfo file, from which file managers know where to restore the file.
std::string noteOf(const std::filesystem::path& file) {
    return fmt::format("[Trash Info]\nPath={}\nDeletionDate={}\n",
                       percentEncoded(std::filesystem::absolute(file).string()), nowText());
}

/// Creates the note; false if one of that name exists.
bool takeName(const std::filesystem::path& note, const std::string& text,
              const std::filesystem::path& file) {
    const int descriptor = ::open(note.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0 && errno == EEXIST) return false;
    if (descriptor < 0) refuse(file, note.string() + ": " + std::strerror(errno));
    const auto size = static_cast<ssize_t>(text.size());
    const bool written = ::write(descriptor, text.data(), text.size()) == size;
    if (::close(descriptor) == 0 && written) return true;
    ::unlink(note.c_str());
    refuse(file, note.string() + " cannot be written");
}

/// Falls back to copying where the trash is on another file system.
void move(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code fault;
    std::filesystem::rename(from, to, fault);
    if (fault == std::errc::cross_device_link) {
        std::filesystem::copy_file(from, to);
        std::filesystem::remove(from);
    } else if (fault) {
        throw std::filesystem::filesystem_error("", from, to, fault);
    }
}

}  // namespace

std::filesystem::path moveToTrash(const std::filesystem::path& file) {
    const std::filesystem::path trash = trashFolder(file);
    const std::string text = noteOf(file);
    std::error_code fault;
    for (const char* folder : {"files", "info"}) {
        std::filesystem::create_directories(trash / folder, fault);
        if (fault) refuse(file, (trash / folder).string() + ": " + fault.message());
    }
    for (int i = 1;; ++i) {
        const std::string name =
            i == 1 ? file.filename().string()
                   : fmt::format("{} {}{}", file.stem().string(), i, file.extension().string());
        const std::filesystem::path kept = trash / "files" / name;
        const std::filesystem::path note = trash / "info" / (name + ".trashinfo");
        if (std::filesystem::exists(std::filesystem::symlink_status(kept, fault))) continue;
        if (!takeName(note, text, file)) continue;
        try {
            move(file, kept);
        } catch (const std::filesystem::filesystem_error& error) {
            std::filesystem::remove(note, fault);
            refuse(file, error.code().message());
        }
        return kept;
    }
}

}  // namespace neph
