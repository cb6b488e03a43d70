// command_line.cpp: the grammar of the command line, in one place.
#include "app/cli/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>

#include "app/cli/ask/ask_commands.h"
#include "app/cli/bench/bench_arguments.h"
#include "app/cli/common/arguments.h"
#include "app/cli/common/misuse.h"
#include "app/cli/compare/compare_arguments.h"
#include "app/cli/ensemble_command.h"
#include "app/cli/info/info_command.h"
#include "app/cli/presets_arguments.h"
#include "app/cli/readers_command.h"
#include "app/cli/render/render_arguments.h"
#include "app/cli/render/thumbnails_command.h"
#include "app/cli/validate_command.h"
#include "app/ui/shell/key_table.h"
#include "app/workbench/workbench.h"
#include "core/base/names.h"
#include "core/base/resources.h"
#include "core/session/file_kind.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

constexpr std::string_view kExamples = R"(Examples:
  nephoscope                                        look at the bundled storm
  nephoscope wrfout_d01_2024-05-06_*                look at your own run, all files as one series
  nephoscope render --out storm.png                 an image without a display
  nephoscope render wrfout_d01 --time all --out storm.png --preset fig06-physical
  nephoscope render --out storm.exr --set cloud.mixing_scale=0.5 --set sun.elevation=10
  nephoscope render wrfout_d01 --region 20:60,30:70 --memory 2GiB --out core.png
  nephoscope render --session s.nephoscope.json --along-path --out flight.mp4
  nephoscope render --preset fig06-physical --preset-b fig05-equal-extinction --out ab.png
  nephoscope compare march.exr reference.exr        how far one image is from another
  nephoscope presets show default > mine.json       a preset to edit
  nephoscope info wrfout_d01 --json                 what is in a file
  nephoscope probe wrfout_d01 --at 35.2N,97.4W      what is in the column over a place
  nephoscope section wrfout_d01 --from 20,30 --to 80,30 --show w --out w.svg
  nephoscope --members mem01 mem02 mem03            an ensemble: step through, mean, A/B of any two
  nephoscope ensemble mem0* --exceeds 1 -o tau.nc   probability of optical depth > 1
Exit status: 0 done, 1 bad input or failed work, 2 bad usage.
)";

/// The window: what the program is without a command.
Command addWorkbench(CLI::App& app) {
    struct Request {
        WorkbenchRequest window;
        std::string session;
    };
    const auto request = std::make_shared<Request>();
    addSceneOptions(app, request->window.scene);
    app.add_option("--session", request->session, "Open a session; FILE may be one as well")
        ->type_name("FILE");
    app.add_option("--script", request->window.script, "Commands to play into the window")
        ->type_name("FILE");
    return {
        &app, [&app, request] {
            SceneRequest& scene = request->window.scene;
            if (!request->session.empty()) {
                refuseTyped(app, {"FILE", "--members"}, "there is a --session as well",
                            "give one of the two; a session names its data");
                loadSession(request->session);  // says now what is wrong with it
                scene.files = {request->session};
            }
            checkForCommand(app, scene.files);
            checkScene(app, scene, !scene.preset.empty());
            checkOneTime(scene.times);
            if (scene.files.size() == 1 && kindOfFile(scene.files.front()) == FileKind::session) {
                refuseTyped(app,
                            {"--preset", "--set", "--camera", "--time", "--region", "--member"},
                            "a session is opened, which has its own",
                            "leave it out; nephoscope render --session takes it");
            }
            if (scene.members.empty()) {
                refuseTyped(app, {"--member"}, "there is no ensemble", "--members RUN RUN...");
            }
            return runWorkbench(request->window);
        }};
}

Command addThumbnails(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("thumbnails", "Small images of presets");
    const auto request = std::make_shared<ThumbnailRequest>();
    command.add_option("--preset", request->presets, "Name or file; may be repeated; else all")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false);
    command.add_option("--out,-o", request->out, "Else where the preset browser looks for them")
        ->type_name("FOLDER");
    addSizeOption(command, request->sizePx, "In pixels, with --out");
    command.add_flag("--progress", request->progress, "A JSON object per image on stdout");
    return {&command, [&command, request] {
                if (request->out.empty()) {
                    refuseTyped(command, {"--size"}, "the preset browser has a size of its own",
                                "--out FOLDER");
                }
                return runThumbnails(*request);
            }};
}

Command addInfo(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "info", "Describe files: model, grid, times, maxima of each species and where");
    const auto request = std::make_shared<InfoRequest>();
    command.add_option("FILE", request->files,
                       "Files of one series, or a folder; none: the bundled storm");
    addMembersOption(command, request->members);
    addTimeOption(command, request->times,
                  "Times to read; else all, or of much data the first and the last");
    addMemoryOption(command, request->memory);
    command.add_flag("--json", request->json, "As JSON");
    addReaderOption(command, request->readers);
    addMapOption(command, request->map);
    return {&command, [&command, request] {
                checkMembers(command, request->members);
                return runInfo(*request);
            }};
}

Command addReaders(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "readers", "List reader plugins, or say what one took a file's variables for");
    const auto request = std::make_shared<ReadersRequest>();
    CLI::Option* explain =
        command
            .add_option("--explain", request->explain,
                        "Each variable of a file with its role and why, and what was left out")
            ->type_name("FILE")
            ->allow_extra_args(false);
    addMapOption(command, request->map)->needs(explain);
    addReaderOption(command, request->readers);
    return {&command, [request] { return runReaders(*request); }};
}

Command addKeys(CLI::App& app) {
    return {app.add_subcommand("keys", "Print the table of the window's commands and keys"), [] {
                std::fputs(ui::keyTable().c_str(), stdout);
                return 0;
            }};
}

Command addValidate(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "validate", "Prove the path tracer against published results, or measure a scene");
    const auto request = std::make_shared<ValidateRequest>();
    command.add_option("CASE.json", request->files, "Scenes to measure; none: all that is bundled");
    command.add_flag("--quick", request->quick, "In a minute, with tolerances ten times as wide");
    command.add_flag("--json", request->json, "As JSON");
    command.add_option("--only", request->only, "What has this in its name")->type_name("TEXT");
    addNumber<std::uint64_t, std::uint64_t>(command, "--samples", request->samples, 1, 1U << 30U,
                                            "Paths per detector, at least");
    return {&command, [request] { return runValidate(*request); }};
}

int parseAndRun(int argc, char** argv) {
    CLI::App app(
        "Nephoscope renders the hydrometeors of weather models as an observer would see "
        "them.",
        "nephoscope");
    app.set_version_flag("--version", fmt::format("nephoscope {}", versionText()));
    app.require_subcommand(0, 1);
    const Command window = addWorkbench(app);
    const std::vector<Command> commands{
        addRender(app),   addCompare(app), addThumbnails(app), addPresets(app), addInfo(app),
        addEnsemble(app), addProbe(app),   addProfile(app),    addSection(app), addSeries(app),
        addReaders(app),  addKeys(app),    addBench(app),      addValidate(app)};
    app.footer(std::string(kExamples));  // after the commands, which would take it over
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        if (fault.get_exit_code() == 0) return app.exit(fault);  // --help and --version
        throw misuse(app, fault);
    }
    const auto named =
        std::ranges::find_if(commands, [](const Command& each) { return each.grammar->parsed(); });
    if (named == commands.end()) return window.run();
    refuseBefore(app, *named->grammar);
    return named->run();
}

}  // namespace

int runCommandLine(int argc, char** argv) {
    try {
        return parseAndRun(argc, argv);
    } catch (const UsageError& error) {
        fmt::print(stderr, "error: {}\n", error.message());
        return 2;
    } catch (const Error& error) {
        fmt::print(stderr, "error: {}\n", error.message());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "error: there is not enough memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
    }
    return 1;
}

}  // namespace neph
