// presets_arguments.cpp: each option of `presets` and the field of PresetsRequest that it fills.
#include "app/cli/presets_arguments.h"

#include <memory>

#include "app/cli/presets_command.h"

namespace neph {
namespace {

/// A subcommand; when it is named, it is what the request asks for.
CLI::App& add(CLI::App& presets, PresetsRequest& request, PresetsAction action, const char* name,
              const char* help) {
    CLI::App& command = *presets.add_subcommand(name, help);
    command.parse_complete_callback([&request, action] { request.action = action; });
    return command;
}

void addTexts(CLI::App& command, PresetsRequest& request) {
    command.add_option("--title", request.title, "One line")->type_name("TEXT");
    command.add_option("--description", request.description, "More")->type_name("TEXT");
}

void addReading(CLI::App& presets, PresetsRequest& request) {
    using enum PresetsAction;
    add(presets, request, list, "list", "List presets; what `presets` alone does");
    add(presets, request, show, "show", "Print a whole preset as JSON")
        .add_option("PRESET", request.preset, "Name or file")
        ->required();
    add(presets, request, check, "check", "Check preset files")
        .add_option("FILE", request.several, "Names or files")
        ->required();
    CLI::App& two = add(presets, request, diff, "diff", "In what two presets differ");
    two.add_option("A", request.preset, "Name or file")->required();
    two.add_option("B", request.other, "Name or file")->required();
    add(presets, request, parameters, "parameters", "Print the reference of all parameters");
}

void addKeeping(CLI::App& presets, PresetsRequest& request) {
    using enum PresetsAction;
    CLI::App& own = add(presets, request, save, "save", "Save a look and camera as one of yours");
    own.add_option("NAME", request.preset, "Its name")->required();
    addLookOptions(own, request.scene);
    own.add_flag("--replace", request.replace, "Replace one of yours of that name");
    addTexts(own, request);
    CLI::App& copy = add(presets, request, duplicate, "duplicate", "Copy a preset to one of yours");
    copy.add_option("PRESET", request.preset, "Name or file")->required();
    copy.add_option("NAME", request.other, "Of the copy; else one that is free");
    CLI::App& renamed = add(presets, request, rename, "rename", "Rename one of yours");
    renamed.add_option("PRESET", request.preset, "Its name")->required();
    renamed.add_option("NAME", request.other, "Its new name")->required();
    CLI::App& described =
        add(presets, request, describe, "describe", "Other words for one of yours");
    described.add_option("PRESET", request.preset, "Its name")->required();
    addTexts(described, request);
    add(presets, request, remove, "delete", "Move some of yours to the trash")
        .add_option("PRESET", request.several, "Names")
        ->required();
}

}  // namespace

Command addPresets(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("presets", "List, show, compare and keep presets");
    command.require_subcommand(0, 1);
    const auto request = std::make_shared<PresetsRequest>();
    addReading(command, *request);
    addKeeping(command, *request);
    return {&command, [request] {
                checkSetOnce(request->scene.settings);
                if (request->action == PresetsAction::describe && !request->title &&
                    !request->description) {
                    throw UsageError({.where = "presets describe",
                                      .what = "there is nothing to change",
                                      .hint = "--title TEXT, --description TEXT"});
                }
                return runPresets(*request);
            }};
}

}  // namespace neph
