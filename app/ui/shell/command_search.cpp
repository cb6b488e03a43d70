// command_search.cpp: words against words; a few hundred names need no index.
#include "app/ui/shell/command_search.h"

#include <algorithm>

#include "app/ui/widgets/words.h"

namespace neph::ui {
namespace {

constexpr int kInMore = 1, kWithinWord = 2, kWithinMore = 3;  // worse and worse

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) > 127;
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    bool within = false;
    for (const char c : lower(text)) {
        if (isLetter(c) && !within) words.emplace_back();
        within = isLetter(c);
        if (within) words.back() += c;
    }
    return words;
}

bool begins(const std::string& word, const std::vector<std::string>& known) {
    return std::ranges::any_of(known, [&](const std::string& k) { return k.starts_with(word); });
}

bool within(const std::string& word, const std::vector<std::string>& known) {
    return std::ranges::any_of(known, [&](const std::string& k) { return k.find(word) != k.npos; });
}

std::vector<Command> allCommands() {
    std::vector<Command> all;
    for (const Action& action : actions()) all.push_back({&action, nullptr});
    for (const Parameter& row : parameterTable()) all.push_back({nullptr, &row});
    return all;
}

/// Place among `recent`; behind all of them where it is none.
std::size_t ageOf(const Command& command, std::span<const std::string> recent) {
    return static_cast<std::size_t>(std::ranges::find(recent, command.id()) - recent.begin());
}

}  // namespace

std::string Command::label() const {
    if (action != nullptr) return std::string(action->label);
    if (!parameter->species) return parameter->label;
    return std::string(info(*parameter->species).label) + ": " + parameter->label;
}

std::string Command::where() const {
    return action != nullptr ? std::string(menuName(action->menu)) : parameter->group;
}

int matchOf(std::string_view text, std::string_view label, std::string_view more) {
    const std::vector<std::string> named = wordsOf(label), besides = wordsOf(more);
    int worse = 0;
    for (const std::string& word : wordsOf(text)) {
        if (begins(word, named)) continue;
        if (begins(word, besides)) {
            worse += kInMore;
        } else if (within(word, named)) {
            worse += kWithinWord;
        } else if (within(word, besides)) {
            worse += kWithinMore;
        } else {
            return -1;
        }
    }
    return worse;
}

std::vector<Command> findCommands(std::string_view text, std::span<const std::string> recent) {
    struct Found {
        Command command;
        int worse;
        std::size_t age;
    };
    std::vector<Found> found;
    const bool nothing = wordsOf(text).empty();
    for (const Command& command : allCommands()) {
        const std::size_t age = ageOf(command, recent);
        if (nothing && command.action == nullptr && age == recent.size()) continue;
        const std::string more = command.where() + " " + std::string(command.id());
        const int worse = matchOf(text, command.label(), more);
        if (worse >= 0) found.push_back({command, worse, age});
    }
    std::ranges::stable_sort(found, [](const Found& a, const Found& b) {
        return a.worse != b.worse ? a.worse < b.worse : a.age < b.age;
    });
    std::vector<Command> commands;
    for (const Found& each : found) commands.push_back(each.command);
    return commands;
}

}  // namespace neph::ui
