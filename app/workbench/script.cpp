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
    std::string_view command;
    std::size_t least, most;  // words after it
};
constexpr std::size_t kAny = 1000;
constexpr std::array kGrammar{
    Grammar{"wait", 0, 0},        Grammar{"frames", 1, 1},       Grammar{"size", 1, 1},
    Grammar{"action", 1, 1},      Grammar{"key", 1, 1},          Grammar{"text", 1, kAny},
    Grammar{"move", 1, 1},        Grammar{"click", 1, 1},        Grammar{"right", 1, 1},
    Grammar{"double", 1, 1},      Grammar{"drag", 3, 3},         Grammar{"orbit", 2, 2},
    Grammar{"wheel", 2, 2},       Grammar{"open", 1, kAny},      Grammar{"set", 1, 1},
    Grammar{"expect", 1, 1},      Grammar{"expect-place", 1, 1}, Grammar{"expect-file", 1, 1},
    Grammar{"expect-time", 1, 1}, Grammar{"screenshot", 1, 1},   Grammar{"monkey", 2, 2},
};

void check(const ScriptStep& step, const std::string& where) {
    const auto found = std::ranges::find(kGrammar, step.command, &Grammar::command);
    const std::string at = fmt::format("{}, line {}", where, step.line);
    if (found == kGrammar.end()) {
        std::vector<std::string_view> known;
        for (const Grammar& row : kGrammar) known.push_back(row.command);
        const std::string_view near = nearestName(step.command, known);
        throw Error({at, "there is no such command", step.command, "",
                     near.empty() ? "" : fmt::format("did you mean {}?", near)});
    }
    if (step.words.size() >= found->least && step.words.size() <= found->most) return;
    throw Error({at, fmt::format("{} has another number of words after it", step.command),
                 std::to_string(step.words.size()), std::to_string(found->least), ""});
}

}  // namespace

std::vector<ScriptStep> parseScript(std::string_view text, const std::string& where) {
    std::vector<ScriptStep> steps;
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        ScriptStep step{"", {}, number};
        if (!(words >> step.command)) continue;
        step.words.assign(std::istream_iterator<std::string>(words), {});
        check(step, where);
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
