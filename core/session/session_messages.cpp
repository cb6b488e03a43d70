// session_messages.cpp: what a session tells the user, and the steps of its history.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/look/haze.h"
#include "core/session/session.h"

namespace neph {
namespace {

constexpr std::size_t kMaxMessages = 200;

}  // namespace

/// Replaces the messages about the time that was shown before; each names its time. What the
/// request entails for every time has been said.
void Session::sayOfTime(const HeldVolume& held, const VolumeRequest& request) {
    std::erase_if(messages, &Message::ofTime);
    saidHaze_ = document.look.haze;
    const auto add = [this](Message::Kind kind, const std::string& text) {
        messages.push_back({kind, text, ++lastSerial_, true});
    };
    const std::vector<std::string>& lasting = request.radii.notes;
    for (const std::string& note : held.volume->notes) {
        if (std::ranges::find(lasting, note) == lasting.end()) add(Message::Kind::note, note);
    }
    const std::string haze = hazeNote(document.look, held.summary.where, held.volume->timeLabel,
                                      held.summary.noHumidity, held.summary.noAerosol);
    if (!haze.empty()) add(Message::Kind::note, haze);
    if (held.summary.empty()) {
        add(Message::Kind::warning,
            fmt::format("{}: there is no hydrometeor at this time", held.volume->timeLabel));
    }
}

void Session::say(Message::Kind kind, std::string text) {
    if (!messages.empty() && messages.back().kind == kind && messages.back().text == text) return;
    messages.push_back({kind, std::move(text), ++lastSerial_});
    if (messages.size() > kMaxMessages) messages.erase(messages.begin());
}

/// Adds messages that have not been shown for these data before.
void Session::sayNew(const std::vector<std::string>& notes, Message::Kind kind) {
    for (const std::string& note : notes) {
        if (toldNotes_.insert(note).second) say(kind, note);
    }
}

bool Session::undo() {
    if (!history.undo(document)) return false;
    say(Message::Kind::note, "Undone: " + history.redoLabel());
    return true;
}

bool Session::redo() {
    if (!history.redo(document)) return false;
    say(Message::Kind::note, "Done again: " + history.undoLabel());
    return true;
}

bool Session::jumpTo(std::size_t steps) {
    if (!history.jumpTo(document, steps)) return false;
    say(Message::Kind::note, steps == 0 ? "Back at the start" : "Back at: " + history.undoLabel());
    return true;
}

}  // namespace neph
