// arguments.cpp: names and help of what several commands take.
#include "app/cli/common/arguments.h"

#include "core/volume/memory_setting.h"

namespace neph {

void addReaderOption(CLI::App& command, std::vector<std::string>& readers) {
    command.add_option("--reader", readers, "Reader plugin to use; may be repeated")
        ->type_name("LIBRARY|FOLDER")
        ->allow_extra_args(false);  // what follows is a file
}

CLI::Option* addMapOption(CLI::App& command, std::string& map) {
    return command
        .add_option("--map", map,
                    "What the variables of an unknown NetCDF file are (nephoscope-map)")
        ->type_name("FILE");
}

CLI::Option* addMembersOption(CLI::App& command, std::vector<std::string>& members) {
    return command
        .add_option(
            "--members", members,
            "Runs of one grid as an ensemble: each a file, a folder or a quoted pattern; or "
            "one folder that holds them")
        ->type_name("RUN...");
}

void checkMembers(const CLI::App& command, const std::vector<std::string>& members) {
    if (members.empty()) return;
    refuseTyped(command, {"FILE"}, "there are --members as well",
                "give one of the two; each of the members is a run");
}

void addMemoryOption(CLI::App& command, std::string& memory) {
    const auto parse = [](const std::string& text) {
        // Read here for its faults; what a share comes to depends on when it is used.
        asUsage("--memory", [&] { return memoryBudget(text, 0); });
        return text;
    };
    addParsed(command, "--memory", memory, parse, "For fields: 2GiB, 512MiB or 50% of the free")
        ->type_name("SIZE|SHARE");
}

void addTimeOption(CLI::App& command, std::optional<TimeRange>& times, const std::string& help) {
    addParsed(
        command, "--time", times,
        [](const std::string& text) { return parseTimeRange("--time", text); }, help)
        ->type_name("INDEX|a:b|all");
}

void addPresetOptions(CLI::App& command, SceneRequest& request) {
    command.add_option("--preset", request.preset, "Preset, by name or file; else default")
        ->type_name("NAME|FILE");
    const auto take = [&request](const std::vector<std::string>& assignments) {
        for (const std::string& assignment : assignments) {
            request.settings.push_back(parseSetting("--set", assignment));
        }
    };
    command
        .add_option_function<std::vector<std::string>>("--set", take,
                                                       "Set one parameter; may be repeated")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false);
}

void addLookOptions(CLI::App& command, SceneRequest& request) {
    addPresetOptions(command, request);
    command.add_option("--camera", request.camera, "Camera of a preset, or a file with one")
        ->type_name("NAME|FILE");
}

void addSceneOptions(CLI::App& command, SceneRequest& request) {
    command.add_option("FILE", request.files,
                       "Files of one series, or a folder; none: the bundled storm");
    addMembersOption(command, request.members);
    command.add_option("--member", request.member, "Of the ensemble: by name or number, or mean")
        ->type_name("NAME|N|mean");
    addLookOptions(command, request);
    const auto parse = [](const std::string& text) {
        return asUsage("--parts " + text, [&] { return parsePresetParts(text); });
    };
    addParsed(command, "--parts", request.parts, parse,
              "Of the preset: fields,light,view,camera; else all")
        ->type_name("LIST");
    addTimeOption(command, request.times, "Time index, a:b or all; else the middle one");
    addParsed(command, "--region", request.region, parseRegion,
              "Part of the domain in km; else all of it")
        ->type_name("x0:x1,y0:y1[,z0:z1]");
    addMemoryOption(command, request.memory);
    addReaderOption(command, request.readers);
    addMapOption(command, request.map);
}

CLI::Option* addAlias(CLI::App& command, const std::string& option, SceneRequest& request) {
    const auto take = [option, &request](const std::string& text) {
        request.engineSettings.push_back(parseAlias(option, text));
    };
    const OptionAlias& alias = parameterOfOption(option).alias;
    return command.add_option_function<std::string>(option, take, alias.help)
        ->type_name(std::string(alias.takes));
}

void refuseTyped(const CLI::App& command, std::initializer_list<const char*> names,
                 const std::string& what, const std::string& hint) {
    for (const char* name : names) {
        if (command.count(name) > 0) throw UsageError({.where = name, .what = what, .hint = hint});
    }
}

void checkScene(const CLI::App& command, const SceneRequest& request, bool anyPreset) {
    if (!anyPreset) refuseTyped(command, {"--parts"}, "is of a preset", "--preset NAME");
    std::vector<Setting> settings = request.settings;
    settings.insert(settings.end(), request.engineSettings.begin(), request.engineSettings.end());
    checkSetOnce(settings);
    checkMembers(command, request.members);
}

void checkOneTime(const std::optional<TimeRange>& times) {
    if (!times || times->first == times->last) return;
    throw UsageError(
        {times->typed, "is more than the one time that is shown here", "", "INDEX", ""});
}

}  // namespace neph
