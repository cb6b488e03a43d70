// session_files.h: opening and saving: what the dialogues keep between frames, and what menus,
// dropped files and the dialogues themselves do with a file.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/panel/panel_context.h"
#include "app/ui/widgets/file_browser.h"
#include "core/session/session_state.h"

namespace neph {
class Autosave;
}

namespace neph::ui {

/// A session that waits to be told where its data are.
struct WaitingSession {
    SessionState state;
    std::string name;                  ///< for the dialogue
    std::filesystem::path file;        ///< it came from; empty: autosaved
    bool crashed = false;              ///< left by a crash: forgotten once it is taken over
    std::vector<std::string> missing;  ///< names of data
    std::string line;                  ///< as typed: where the first of them is now
    std::string told;                  ///< what came of the last answer
};

struct SessionDialogs {
    Autosave* autosave = nullptr;  ///< of the window; nullptr: nothing is kept
    bool offersCrashed = false;    ///< restoring what a crash left is offered
    std::string crashText;         ///< of the offer; made once
    bool adopts = false;           ///< what a crash left is being opened
    std::filesystem::path file;    ///< session last opened or saved; empty: none
    FileBrowser browser;
    bool opensBrowser = false;  ///< in the next frame
    bool showRecent = false;    ///< opens the list in the next frame
    std::optional<WaitingSession> waiting;
    std::vector<std::string> named;    ///< of the open data, when last looked at
    std::vector<std::string> checked;  ///< recent entries that `there` is about
    std::vector<bool> there;
};

/// Asks for a file: opens the browser in the next frame.
void browse(const Settings& settings, SessionDialogs& dialogs, BrowseFor purpose);

/// Opens what was named or dropped: one session, or data; a preset is left to the presets' room.
/// Faults become messages.
void openFiles(const PanelContext& context, SessionDialogs& dialogs,
               const std::vector<std::string>& names);
/// Opens an entry of the recent ones: data, an ensemble, a session or a preset.
void openRecent(const PanelContext& context, SessionDialogs& dialogs, const std::string& entry);
/// Opens each of `runs` as a member of an ensemble, or the members in the one folder that is named.
void openMembers(const PanelContext& context, const std::vector<std::string>& runs);
void openSessionFile(const PanelContext& context, SessionDialogs& dialogs,
                     const std::filesystem::path& file);
void saveSessionFile(const PanelContext& context, SessionDialogs& dialogs,
                     const std::filesystem::path& file);

/// Shows a session whose data are all there.
void takeOver(const PanelContext& context, SessionDialogs& dialogs, const WaitingSession& from);
/// Names `found` for the first of the missing data.
void answer(WaitingSession& waiting, const std::string& found);
/// Look and camera on the data that are open, in place of those that are missing.
void leaveOut(const Session& session, WaitingSession& waiting);

/// The session left by a crash, else that of the last proper end. False when there is none.
bool reopenLast(const PanelContext& context, SessionDialogs& dialogs);
bool canReopenLast(const SessionDialogs& dialogs);
/// Opens the open data again, at the same time, as they are on disk now.
void reloadData(Session& session);

/// Remembers what was opened; call once per frame.
void noteOpened(const PanelContext& context, SessionDialogs& dialogs);
/// Whether an entry of `recent` is still there.
bool recentIsThere(SessionDialogs& dialogs, const std::vector<std::string>& recent,
                   std::size_t index);

/// "3 minutes ago".
std::string agoText(double seconds);

}  // namespace neph::ui
