// actions_file.cpp: the actions of the File menu.
#include <array>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"

namespace neph::ui {
namespace {

void browseFor(Ui& ui, BrowseFor purpose) {
    browse(ui.settings, ui.sessionDialogs, purpose);
}

/// Into the file that is open.
void save(Ui& ui) {
    const std::filesystem::path file = ui.sessionDialogs.file;
    if (file.empty()) {
        browseFor(ui, BrowseFor::saveSession);
    } else {
        saveSessionFile(contextOf(ui), ui.sessionDialogs, file);
    }
}

const std::array kActions{
    Action{.id = "file.open",
           .label = "Open data...",
           .menu = Menu::file,
           .chord = {Key::o, true},
           .help = "Opens the files of one series, or a folder",
           .run = [](Ui& ui) { browseFor(ui, BrowseFor::data); }},
    Action{.id = "file.open_ensemble",
           .label = "Open ensemble...",
           .menu = Menu::file,

           .help = "Runs of one grid as members: a folder that holds them, or several runs",
           .run = [](Ui& ui) { browseFor(ui, BrowseFor::members); }},
    Action{.id = "file.bundled",
           .label = "Open the bundled storm",
           .menu = Menu::file,
           .help = "Opens the supercell that comes with the program",
           .run = [](Ui& ui) { ui.session().open({}); }},
    Action{.id = "file.recent",
           .label = "Open recent...",
           .menu = Menu::file,
           .chord = {Key::r, true, true},
           .help = "Lists data and sessions opened before, newest first",
           .run = [](Ui& ui) { ui.sessionDialogs.showRecent = true; },
           .enabled = [](const Ui& ui) { return !ui.settings.recent.empty(); }},
    Action{.id = "file.reload",
           .label = "Reload data",
           .menu = Menu::file,
           .chord = {Key::r, true},
           .help = "Rereads the open files from disk",
           .run = [](Ui& ui) { reloadData(ui.session()); },
           .enabled = [](const Ui& ui) { return ui.session().info() != nullptr; }},
    Action{.id = "file.open_session",
           .label = "Open session...",
           .menu = Menu::file,
           .chord = {Key::o, true, true},
           .help = "Opens data, looks and cameras that were saved together",
           .run = [](Ui& ui) { browseFor(ui, BrowseFor::session); },
           .separated = true},
    Action{.id = "file.save_session",
           .label = "Save session",
           .menu = Menu::file,
           .chord = {Key::w, true, true},
           .help = "Saves to the open session file, or asks for a name",
           .run = save},
    Action{.id = "file.save_session_as",
           .label = "Save session as...",
           .menu = Menu::file,
           .help = "Saves data, looks, cameras, bookmarks and the path to another file",
           .run = [](Ui& ui) { browseFor(ui, BrowseFor::saveSession); }},
    Action{.id = "file.reopen",
           .label = "Reopen last session",
           .menu = Menu::file,
           .chord = {Key::t, true, true},
           .help = "Restores the session as it was when the program last ended, even by a crash",
           .run = [](Ui& ui) { reopenLast(contextOf(ui), ui.sessionDialogs); },
           .enabled = [](const Ui& ui) { return canReopenLast(ui.sessionDialogs); }},
    Action{.id = "file.quit",
           .label = "Quit",
           .menu = Menu::file,
           .chord = {Key::q, true},
           .help = "Quits; the session can be reopened",
           .run = [](Ui& ui) { ui.requests.quit = true; },
           .separated = true},
};

}  // namespace

std::span<const Action> fileActions() {
    return kActions;
}

}  // namespace neph::ui
