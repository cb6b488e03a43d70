// script.cpp: lines into commands with the right number of words.
#include "app/workbench/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/error.h"
#include "core/base/names.h"

namespace neph {
namespace {

struct Grammar {
    std::string_view name;
    ScriptCommand command;
    std::size_t least, most;  // words after it
};
constexpr std::size_t kAny = 1000;
constexpr std::array kGrammar{
    Grammar{"wait", ScriptCommand::wait, 0, 0},
    Grammar{"frames", ScriptCommand::frames, 1, 1},
    Grammar{"size", ScriptCommand::size, 1, 1},
    Grammar{"action", ScriptCommand::action, 1, 1},
    Grammar{"key", ScriptCommand::key, 1, 1},
    Grammar{"text", ScriptCommand::text, 1, kAny},
    Grammar{"move", ScriptCommand::move, 1, 1},
    Grammar{"click", ScriptCommand::click, 1, 1},
    Grammar{"right", ScriptCommand::rightClick, 1, 1},
    Grammar{"double", ScriptCommand::doubleClick, 1, 1},
    Grammar{"drag", ScriptCommand::drag, 3, 3},
    Grammar{"pull", ScriptCommand::pull, 3, 3},
    Grammar{"orbit", ScriptCommand::orbit, 2, 2},
    Grammar{"wheel", ScriptCommand::wheel, 2, 2},
    Grammar{"open", ScriptCommand::open, 1, kAny},
    Grammar{"set", ScriptCommand::set, 1, 1},
    Grammar{"expect", ScriptCommand::expect, 1, 1},
    Grammar{"expect-place", ScriptCommand::expectPlace, 1, 1},
    Grammar{"expect-file", ScriptCommand::expectFile, 1, 1},
    Grammar{"expect-time", ScriptCommand::expectTime, 1, 1},
    Grammar{"expect-member", ScriptCommand::expectMember, 1, 1},
    Grammar{"screenshot", ScriptCommand::screenshot, 1, 1},
    Grammar{"monkey", ScriptCommand::monkey, 2, 2},
};

ScriptCommand parseCommand(const std::string& name, std::size_t words, const std::string& at) {
    const auto found = std::ranges::find(kGrammar, name, &Grammar::name);
    if (found == kGrammar.end()) {
        std::vector<std::string_view> known;
        for (const Grammar& row : kGrammar) known.push_back(row.name);
        const std::string_view near = nearestName(name, known);
        throw Error({at, "there is no such command", name, "",
                     near.empty() ? "" : fmt::format("did you mean {}?", near)});
    }
    if (words >= found->least && words <= found->most) return found->command;
    throw Error({at, fmt::format("{} has another number of words after it", name),
                 std::to_string(words), std::to_string(found->least), ""});
}

}  // namespace

std::vector<ScriptStep> parseScript(std::string_view text, const std::string& where) {
    std::vector<ScriptStep> steps;
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::string name;
        if (!(words >> name)) continue;
        ScriptStep step;
        step.line = number;
        step.words.assign(std::istream_iterator<std::string>(words), {});
        step.command =
            parseCommand(name, step.words.size(), fmt::format("{}, line {}", where, number));
        steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<ScriptStep> loadScript(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw Error({file.string(), "cannot be read", "", "a file of commands", ""});
    std::ostringstream text;
    text << stream.rdbuf();
    return parseScript(text.str(), file.filename().string());
}

}  // namespace neph
