// session_files.cpp: opening, saving and restoring sessions, without drawing anything.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/ui/data/session_dialogs.h"
#include "app/ui/shell/ui.h"
#include "core/base/error.h"
#include "core/session/autosave.h"
#include "core/session/file_kind.h"
#include "core/session/moved_data.h"
#include "core/session/recent.h"
#include "core/session/session_file.h"

namespace neph::ui {
namespace {

namespace fs = std::filesystem;

void say(Ui& ui, Message::Kind kind, std::string text) {
    ui.session().say(kind, std::move(text));
}

/// Reads a session and shows it, or asks where its data are.
void openFrom(Ui& ui, const fs::path& file, WaitingSession from) {
    try {
        std::vector<std::string> warnings;
        from.state = loadSession(file, warnings);
        for (std::string& warning : warnings) say(ui, Message::Kind::warning, std::move(warning));
    } catch (const Error& error) {
        say(ui, Message::Kind::error, error.message());
        return;
    }
    from.missing = missingData(from.state);
    if (from.missing.empty()) {
        takeOver(ui, from);
    } else {
        from.line = from.missing.front();
        ui.sessionDialogs.waiting = std::move(from);
    }
}

}  // namespace

void takeOver(Ui& ui, const WaitingSession& from) {
    SessionDialogs& dialogs = ui.sessionDialogs;
    if (ui.services.restore) ui.services.restore(from.state);
    dialogs.adopts = from.crashed;
    dialogs.file = from.file;
    if (!from.file.empty()) {
        const std::string name = from.file.string();
        addRecent(ui.settings.recent, recentEntry(std::array{name}));
    }
    say(ui, Message::Kind::note, "Session " + from.name);
}

void browse(Ui& ui, BrowseFor purpose) {
    std::error_code error;
    fs::path start = fs::current_path(error);
    if (!ui.settings.recent.empty()) {
        const fs::path folder = labelOf(ui.settings.recent.front()).folder;
        if (fs::is_directory(folder, error)) start = folder;
    }
    begin(ui.sessionDialogs.browser, purpose, start);
    ui.askForPath = true;
}

void openFiles(Ui& ui, const std::vector<std::string>& names) {
    const FileKind kind = names.size() == 1 ? kindOfFile(names.front()) : FileKind::data;
    switch (kind) {
        case FileKind::session:
            openSessionFile(ui, names.front());
            break;
        case FileKind::preset:
            applyPreset(ui, names.front());
            break;
        case FileKind::data:
            ui.session().open(names);
            break;
    }
}

void openSessionFile(Ui& ui, const fs::path& file) {
    WaitingSession from;
    from.name = file.filename().string();
    from.file = fs::absolute(file);
    openFrom(ui, file, std::move(from));
}

void saveSessionFile(Ui& ui, const fs::path& file) {
    if (!ui.services.state) return;
    try {
        saveSession(file, ui.services.state());
        ui.sessionDialogs.file = fs::absolute(file);
        const std::string name = file.string();
        addRecent(ui.settings.recent, recentEntry(std::array{name}));
        say(ui, Message::Kind::note, "Saved " + file.string());
    } catch (const Error& error) {
        say(ui, Message::Kind::error, error.message());
    }
}

void answer(WaitingSession& waiting, const std::string& found) {
    const int count = moveData(waiting.state, waiting.missing.front(), found);
    waiting.missing = missingData(waiting.state);
    waiting.told = count == 0 ? "There is nothing of that name." : fmt::format("{} found.", count);
    waiting.line = waiting.missing.empty() ? "" : waiting.missing.front();
}

void leaveOut(const Ui& ui, WaitingSession& waiting) {
    const Session& session = ui.session();
    for (SlotState& slot : waiting.state.slots) {
        const auto gone = std::erase_if(slot.data, [&](const std::string& name) {
            return std::ranges::find(waiting.missing, name) != waiting.missing.end();
        });
        if (gone == 0 || !slot.data.empty()) continue;
        slot.data = session.named();
        slot.region = session.region();
    }
    waiting.missing.clear();
}

bool canReopenLast(const Ui& ui) {
    const Autosave* autosave = ui.sessionDialogs.autosave;
    return autosave != nullptr && (autosave->crashed() != nullptr || autosave->last());
}

bool reopenLast(Ui& ui) {
    if (!canReopenLast(ui)) return false;
    const Autosave& autosave = *ui.sessionDialogs.autosave;
    const bool crashed = autosave.crashed() != nullptr;
    WaitingSession from;
    from.crashed = crashed;
    from.name = "as it was last";
    openFrom(ui, crashed ? autosave.crashed()->file : autosave.last()->file, std::move(from));
    return true;
}

void reloadData(Ui& ui) {
    const Session& session = ui.session();
    const std::vector<std::string> named = session.named();
    ui.session().open(named, session.document.time, session.region());
}

void noteOpened(Ui& ui) {
    SessionDialogs& dialogs = ui.sessionDialogs;
    if (dialogs.autosave != nullptr) {
        if (auto fault = dialogs.autosave->takeFault()) {
            say(ui, Message::Kind::warning, std::move(*fault));
        }
    }
    // What a crash left stays until its data are open: only then is it part of this session.
    const bool opened = ui.session().info() != nullptr && !ui.session().loading();
    if (opened && dialogs.autosave != nullptr && std::exchange(dialogs.adopts, false)) {
        dialogs.autosave->adoptCrashed();
    }
    if (!ui.session().info() || ui.session().named() == dialogs.named) return;
    dialogs.named = ui.session().named();
    addRecent(ui.settings.recent, recentEntry(dialogs.named));
}

bool recentIsThere(Ui& ui, std::size_t index) {
    SessionDialogs& dialogs = ui.sessionDialogs;
    if (dialogs.checked != ui.settings.recent) {
        dialogs.checked = ui.settings.recent;
        dialogs.there.clear();
        for (const std::string& entry : dialogs.checked) dialogs.there.push_back(isThere(entry));
    }
    return dialogs.there.at(index);
}

std::string agoText(double seconds) {
    struct Unit {
        double seconds;
        const char* name;
    };
    constexpr std::array kUnits{Unit{86400.0, "day"}, Unit{3600.0, "hour"}, Unit{60.0, "minute"}};
    for (const Unit& unit : kUnits) {
        const double count = std::floor(seconds / unit.seconds);
        if (count >= 1.0) {
            return fmt::format("{} {}{} ago", count, unit.name, count > 1.0 ? "s" : "");
        }
    }
    return "less than a minute ago";
}

}  // namespace neph::ui
