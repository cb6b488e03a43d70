// file_browser.h: choosing files by a line that is typed and a list of what lies where it leads:
// the logic of it, without a window.
//
// The line up to its last slash is the folder that is listed; what follows narrows the list. A
// path that is typed behind another one ("/data//home/me", "/data/~/run") takes its place.
#pragma once
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace neph::ui {

enum class BrowseFor { data, session, saveSession, moved, members };

struct FileEntry {
    std::string name;
    bool folder = false;
    std::uint64_t bytes = 0;
    std::time_t changed = 0;
    std::optional<bool> fits;  ///< what is looked for; not looked at yet when none
};

struct FileBrowser {
    BrowseFor purpose = BrowseFor::data;
    std::string line;
    std::filesystem::path folder;       ///< that is listed
    std::vector<FileEntry> entries;     ///< of it, folders first, without hidden ones
    std::set<std::string> chosen;       ///< names in `folder`, where several are
    int marked = -1;                    ///< row under the arrow keys, of shownEntries
    int anchor = -1;                    ///< where a range begins
    bool narrows = false;               ///< the line was typed: the list shows what agrees with it
    bool replaces = false;              ///< the file is there, and replacing it was asked for
    bool selectsName = false;           ///< what is typed next replaces the file's name
    bool focus = false, toEnd = false;  ///< of the line, in the next frame
    bool awaitsKeys = false;            ///< the line has asked for the keyboard
    std::string early;                  ///< typed as the line got the keyboard
    int earlyAt = 0;                    ///< where in the line it belongs
    std::string fault;
    std::vector<std::string> extensions;  ///< of files that readers take, as they say
};

/// Begins with the folder looked at last, or `start`.
void begin(FileBrowser& browser, BrowseFor purpose, const std::filesystem::path& start);

/// The path behind the line: "~" is the home folder.
std::filesystem::path pathOf(const FileBrowser& browser);

/// Lists the folder that the line leads to, where it is another one or `again`.
void refresh(FileBrowser& browser, bool again = false);

/// Indices into `entries`.
std::vector<int> shownEntries(const FileBrowser& browser);

/// Where a path that was typed behind another begins in the line; 0 where none was.
std::size_t laterPath(const std::string& line);

/// The part of the line that names the file, as places in it: behind the last slash; without the
/// ending of a session that is saved. The end is where typing goes on.
struct NamePart {
    std::size_t from = 0, to = 0;
};
NamePart namePart(const FileBrowser& browser);

/// Takes what was typed while the line had not the keyboard.
void typeOn(FileBrowser& browser, const std::string& typed);

/// The line, as far as all entries that go on from it agree.
std::string completed(const FileBrowser& browser);

/// Whether an entry is what is looked for; looks into the file once.
bool fits(FileBrowser& browser, FileEntry& entry);

/// Takes an entry: alone, added or taken away with `add`, with all since the last one by `range`.
void choose(FileBrowser& browser, int shown, bool add, bool range);

/// Goes to the folder above.
void goUp(FileBrowser& browser);

/// What is to be opened or written, or none where the line leads into a folder that is listed then,
/// where `fault` says what is wrong, or where replacing a file is to be asked for first.
std::optional<std::vector<std::string>> accept(FileBrowser& browser);

}  // namespace neph::ui
