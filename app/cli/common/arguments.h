// arguments.h: a command and its grammar, and the arguments that several commands share.
//
// An option's text becomes a value of the request as it is read; what is wrong with it is a
// UsageError that names the option. Options that do not go together are refused after all are read,
// before any work.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/cli/common/scene.h"

namespace neph {

/// A command of the program. `run` checks the options together, does the work and returns the exit
/// status; it holds the request that the grammar fills.
struct Command {
    CLI::App* grammar = nullptr;
    std::function<int()> run;
};

/// An option whose text `parse` makes into the value of `target`; `fallback` is what help shows.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& names, Target& target, Parse parse,
                       const std::string& help, const std::string& fallback = "") {
    CLI::Option* option = command.add_option_function<std::string>(
        names, [&target, parse](const std::string& text) { target = parse(text); }, help);
    return fallback.empty() ? option : option->default_str(fallback);
}

/// A number within bounds.
template <typename Target, typename Number>
CLI::Option* addNumber(CLI::App& command, const std::string& name, Target& target, Number lo,
                       Number hi, const std::string& help, const std::string& fallback = "") {
    return addParsed(
               command, name, target,
               [=](const std::string& text) { return parseNumber<Number>(name, text, lo, hi); },
               help, fallback)
        ->type_name("N");
}

void addReaderOption(CLI::App& command, std::vector<std::string>& readers);

/// --map: a file that says what the variables of an unknown file are.
CLI::Option* addMapOption(CLI::App& command, std::string& map);
/// --members: the runs of an ensemble, in place of FILE.
CLI::Option* addMembersOption(CLI::App& command, std::vector<std::string>& members);
/// Throws UsageError where files are named beside members.
void checkMembers(const CLI::App& command, const std::vector<std::string>& members);
void addMemoryOption(CLI::App& command, std::string& memory);
void addTimeOption(CLI::App& command, std::optional<TimeRange>& times, const std::string& help);
/// --preset and --set.
void addPresetOptions(CLI::App& command, SceneRequest& request);
/// The same with --camera.
void addLookOptions(CLI::App& command, SceneRequest& request);
/// All of a scene; FILE is positional.
void addSceneOptions(CLI::App& command, SceneRequest& request);

/// An option that stands for a parameter, as its row has it, and must act with the engine in use.
CLI::Option* addAlias(CLI::App& command, const std::string& option, SceneRequest& request);

/// Throws UsageError where an option of `names` was typed.
void refuseTyped(const CLI::App& command, std::initializer_list<const char*> names,
                 const std::string& what, const std::string& hint);

/// What no command takes: a parameter set twice, parts of no preset. `anyPreset`: there is one.
void checkScene(const CLI::App& command, const SceneRequest& request, bool anyPreset);

/// Of a command that shows one time. Throws UsageError.
void checkOneTime(const std::optional<TimeRange>& times);

}  // namespace neph
