// misuse.cpp: finding the option that is at fault and the commands that take it.
#include "app/cli/common/misuse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "core/base/names.h"

namespace neph {
namespace {

/// The command that was named last: `presets save` of `nephoscope presets save`.
const CLI::App& innermost(const CLI::App& app) {
    const auto named = app.get_subcommands();
    return named.empty() ? app : innermost(*named.front());
}

/// "nephoscope presets save"
std::string fullName(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name()
                             : fmt::format("{} {}", fullName(*parent), command.get_name());
}

/// "--time" of "--time=3".
std::string nameOf(const std::string& typed) {
    return typed.substr(0, typed.find('='));
}

bool takes(const CLI::App& command, const std::string& option) {
    return command.get_option_no_throw(option) != nullptr;
}

void addTakers(const CLI::App& command, const std::string& option,
               std::vector<std::string>& names) {
    const bool window = command.get_parent() == nullptr;
    if (takes(command, option)) names.push_back(window ? "the window" : fullName(command));
    for (const CLI::App* sub : command.get_subcommands({})) addTakers(*sub, option, names);
}

std::string nearestOption(const CLI::App& command, const std::string& option) {
    std::vector<std::string> options;
    for (const CLI::Option* each : command.get_options()) {
        for (const std::string& name : each->get_lnames()) options.push_back("--" + name);
    }
    const std::vector<std::string_view> known(options.begin(), options.end());
    return std::string(nearestName(option, known));
}

std::string hintFor(const CLI::App& app, const CLI::App& command, const std::string& option) {
    if (!option.starts_with('-')) return fullName(command) + " --help";
    std::vector<std::string> takers;
    addTakers(app, option, takers);
    if (!takers.empty()) return fmt::format("taken by {}", fmt::join(takers, ", "));
    const std::string near = nearestOption(command, option);
    return near.empty() ? fullName(command) + " --help" : fmt::format("did you mean {}?", near);
}

/// What stands before a command would be the window's, which does not open.
UsageError before(const CLI::App& app, const CLI::App& command, const std::string& option) {
    const bool file = !option.starts_with('-');
    if (!file && !takes(command, option)) {
        return UsageError({.where = option,
                           .what = fmt::format("stands before the command {}, which does not "
                                               "take it",
                                               command.get_name()),
                           .hint = hintFor(app, command, option)});
    }
    return UsageError(
        {.where = option,
         .what = fmt::format("stands before the command {}", command.get_name()),
         .expected = fmt::format("{} {}", fullName(command), option),
         .hint = file ? fmt::format("a file of the name {0} is ./{0}", command.get_name()) : ""});
}

/// An option that was given more often than it takes values.
const CLI::Option* repeated(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const auto most = static_cast<std::size_t>(option->get_items_expected_max());
        if (option->count() > most && option->get_expected_max() != 0) return option;
    }
    const auto named = command.get_subcommands();
    return named.empty() ? nullptr : repeated(*named.front());
}

UsageError unexpected(const CLI::App& app) {
    const CLI::App& command = innermost(app);
    const CLI::App* at = &app;
    while (at != &command && at->remaining(false).empty()) at = at->get_subcommands().front();
    const std::string option = nameOf(at->remaining(false).front());
    if (at != &command) return before(app, command, option);
    return UsageError({.where = option,
                       .what = fmt::format("{} does not take this", fullName(command)),
                       .hint = hintFor(app, command, option)});
}

}  // namespace

UsageError misuse(const CLI::App& app, const CLI::ParseError& fault) {
    if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr) return unexpected(app);
    if (const CLI::Option* option = repeated(app)) {
        return UsageError({.where = option->get_name(),
                           .what = "is given more than once",
                           .found = fmt::format("{}", fmt::join(option->results(), ", ")),
                           .hint = "give it once"});
    }
    return UsageError({"", fault.what(), "", "", fullName(innermost(app)) + " --help"});
}

void refuseBefore(const CLI::App& app, const CLI::App& command) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->count() == 0) continue;
        const bool positional = option->get_positional();
        throw before(app, innermost(command),
                     positional ? option->results().front() : option->get_name());
    }
}

void checkForCommand(const CLI::App& app, const std::vector<std::string>& files) {
    if (files.empty() || std::filesystem::exists(files.front())) return;
    const std::string& name = files.front();
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    const std::vector<std::string_view> known(commands.begin(), commands.end());
    const std::string_view near = nearestName(name, known);
    if (near.empty()) return;
    throw UsageError({"", fmt::format("there is no file and no command {}", name), "", "",
                      fmt::format("did you mean nephoscope {}?", near)});
}

}  // namespace neph
