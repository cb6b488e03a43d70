// session_files.cpp: opening, saving and restoring sessions, without drawing anything.
#include "app/ui/data/session_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/session/autosave.h"
#include "core/session/file_kind.h"
#include "core/session/moved_data.h"
#include "core/session/recent.h"
#include "core/session/session_file.h"

namespace neph::ui {
namespace {

namespace fs = std::filesystem;

/// Reads a session and shows it, or asks where its data are.
void openFrom(const PanelContext& context, SessionDialogs& dialogs, const fs::path& file,
              WaitingSession from) {
    try {
        std::vector<std::string> warnings;
        from.state = loadSession(file, warnings);
        for (std::string& warning : warnings) {
            context.session().say(Message::Kind::warning, std::move(warning));
        }
    } catch (const Error& error) {
        context.session().say(Message::Kind::error, error.message());
        return;
    }
    from.missing = missingData(from.state);
    if (from.missing.empty()) {
        takeOver(context, dialogs, from);
    } else {
        from.line = from.missing.front();
        dialogs.waiting = std::move(from);
    }
}

}  // namespace

void takeOver(const PanelContext& context, SessionDialogs& dialogs, const WaitingSession& from) {
    if (context.services.restore) context.services.restore(from.state);
    dialogs.adopts = from.crashed;
    dialogs.file = from.file;
    if (!from.file.empty()) {
        const std::string name = from.file.string();
        addRecent(context.settings.recent, recentEntry(std::array{name}));
    }
    context.session().say(Message::Kind::note,
                          from.file.empty() ? "Reopened the last session" : "Session " + from.name);
}

void browse(const Settings& settings, SessionDialogs& dialogs, BrowseFor purpose) {
    std::error_code error;
    fs::path start = fs::current_path(error);
    if (!settings.recent.empty()) {
        const fs::path folder = labelOf(settings.recent.front()).folder;
        if (fs::is_directory(folder, error)) start = folder;
    }
    begin(dialogs.browser, purpose, start);
    dialogs.opensBrowser = true;
}

void openFiles(const PanelContext& context, SessionDialogs& dialogs,
               const std::vector<std::string>& names) {
    const FileKind kind = names.size() == 1 ? kindOfFile(names.front()) : FileKind::data;
    switch (kind) {
        case FileKind::session:
            openSessionFile(context, dialogs, names.front());
            break;
        case FileKind::preset:
            context.requests.preset = names.front();
            break;
        case FileKind::data:
            context.session().open(names);
            break;
    }
}

void openRecent(const PanelContext& context, SessionDialogs& dialogs, const std::string& entry) {
    if (namesRuns(entry)) {
        openMembers(context, namesIn(entry));
    } else {
        openFiles(context, dialogs, namesIn(entry));
    }
}

void openMembers(const PanelContext& context, const std::vector<std::string>& runs) {
    context.session().openAs({.named = runs, .members = true});
}

void openSessionFile(const PanelContext& context, SessionDialogs& dialogs, const fs::path& file) {
    WaitingSession from;
    from.name = file.filename().string();
    from.file = fs::absolute(file);
    openFrom(context, dialogs, file, std::move(from));
}

void saveSessionFile(const PanelContext& context, SessionDialogs& dialogs, const fs::path& file) {
    if (!context.services.state) return;
    try {
        saveSession(file, context.services.state());
        dialogs.file = fs::absolute(file);
        const std::string name = file.string();
        addRecent(context.settings.recent, recentEntry(std::array{name}));
        context.session().say(Message::Kind::note, "Saved " + file.string());
    } catch (const Error& error) {
        context.session().say(Message::Kind::error, error.message());
    }
}

void answer(WaitingSession& waiting, const std::string& found) {
    const int count = moveData(waiting.state, waiting.missing.front(), found);
    waiting.missing = missingData(waiting.state);
    waiting.told =
        count == 0 ? "Nothing by that name was found there." : fmt::format("{} found.", count);
    waiting.line = waiting.missing.empty() ? "" : waiting.missing.front();
}

void leaveOut(const Session& session, WaitingSession& waiting) {
    for (SlotState& slot : waiting.state.slots) {
        const auto gone = std::erase_if(slot.data, [&](const std::string& name) {
            return std::ranges::find(waiting.missing, name) != waiting.missing.end();
        });
        if (gone == 0 || !slot.data.empty()) continue;
        slot.data = session.named();
        slot.members = session.namesMembers();
        slot.region = session.region();
    }
    waiting.missing.clear();
}

bool canReopenLast(const SessionDialogs& dialogs) {
    const Autosave* autosave = dialogs.autosave;
    return autosave != nullptr && (autosave->crashed() != nullptr || autosave->last());
}

bool reopenLast(const PanelContext& context, SessionDialogs& dialogs) {
    if (!canReopenLast(dialogs)) return false;
    const Autosave& autosave = *dialogs.autosave;
    const bool crashed = autosave.crashed() != nullptr;
    WaitingSession from;
    from.crashed = crashed;
    from.name = "The last session";
    openFrom(context, dialogs, crashed ? autosave.crashed()->file : autosave.last()->file,
             std::move(from));
    return true;
}

void reloadData(Session& session) {
    session.openAs({.named = session.named(),
                    .members = session.namesMembers(),
                    .time = session.document.time,
                    .member = session.document.member,
                    .region = session.region(),
                    .keepsView = true});
}

void noteOpened(const PanelContext& context, SessionDialogs& dialogs) {
    if (dialogs.autosave != nullptr) {
        if (auto fault = dialogs.autosave->takeFault()) {
            context.session().say(Message::Kind::warning, std::move(*fault));
        }
    }
    // What a crash left stays until its data are open: only then is it part of this session.
    const Session& session = context.session();
    const bool opened = session.info() != nullptr && !session.loading();
    if (opened && dialogs.autosave != nullptr && std::exchange(dialogs.adopts, false)) {
        dialogs.autosave->adoptCrashed();
    }
    if (!session.info() || session.named() == dialogs.named) return;
    dialogs.named = session.named();
    addRecent(context.settings.recent, recentEntry(dialogs.named, session.namesMembers()));
}

bool recentIsThere(SessionDialogs& dialogs, const std::vector<std::string>& recent,
                   std::size_t index) {
    if (dialogs.checked != recent) {
        dialogs.checked = recent;
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
