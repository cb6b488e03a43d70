// command_line.cpp: the grammar of the command line, in one place.
#include "app/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "app/cli/bench_command.h"
#include "app/cli/info_command.h"
#include "app/cli/presets_command.h"
#include "app/cli/readers_command.h"
#include "app/cli/render_command.h"
#include "app/workbench.h"
#include "core/names.h"
#include "core/resources.h"

namespace neph {
namespace {

constexpr std::string_view kExamples = R"(Examples:
  nephoscope                                        look at the bundled storm
  nephoscope wrfout_d01_2024-05-06_*                look at your own run, all files as one series
  nephoscope render --out storm.png                 a picture without a display
  nephoscope render wrfout_d01 --time all --out storm.png --preset fig06-physical
  nephoscope render --out storm.exr --set cloud.mixing_scale=0.5 --set sun.elevation=10
  nephoscope render wrfout_d01 --region 20:60,30:70 --memory 2GiB --out core.png
  nephoscope presets show default > mine.json       a preset to edit
  nephoscope info wrfout_d01 --json                 what is in a file
Exit status: 0 done, 1 bad input or failed work, 2 bad usage.
)";

struct Arguments {
    SceneOptions workbench;
    RenderOptions render;
    InfoOptions info;
    BenchOptions bench;
    std::string preset;
    std::vector<std::string> presets;
    std::vector<std::string> readers;
};

void addReaderOption(CLI::App& command, std::vector<std::string>& readers) {
    command.add_option("--reader", readers, "Reader plugin to use; may be repeated")
        ->type_name("LIBRARY|FOLDER")
        ->allow_extra_args(false);  // what follows is a file
}

void addMemoryOption(CLI::App& command, std::string& memory) {
    command.add_option("--memory", memory, "For fields: 2GiB, 512MiB or 50% of the free")
        ->type_name("SIZE|SHARE");
}

void addSceneOptions(CLI::App& command, SceneOptions& options) {
    command.add_option("FILE", options.files,
                       "Files of one series, or a folder; none: the bundled storm");
    command.add_option("--preset", options.preset, "Preset, by name or file")
        ->type_name("NAME|FILE");
    command.add_option("--set", options.assignments, "Set one parameter; may be repeated")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false);
    command.add_option("--camera", options.camera, "Camera of a preset, or a file with one")
        ->type_name("NAME|FILE");
    command.add_option("--time", options.time, "Time index, a:b or all; else the middle one")
        ->type_name("INDEX|a:b|all");
    command.add_option("--region", options.region, "Part of the domain in km; else all of it")
        ->type_name("x0:x1,y0:y1[,z0:z1]");
    addMemoryOption(command, options.memory);
    addReaderOption(command, options.readers);
}

void addRender(CLI::App& app, RenderOptions& options) {
    CLI::App& command = *app.add_subcommand("render", "Render to a file; needs no display");
    addSceneOptions(command, options.scene);
    command.add_option("--out,-o", options.out, "Picture to write")
        ->type_name("P.png|P.exr")
        ->capture_default_str();
    command.add_option("--size", options.size, "In pixels")
        ->type_name("WxH")
        ->capture_default_str();
    command.add_option("--engine", options.engine, "Instead of view.engine: march or slicing")
        ->type_name("NAME");
    command
        .add_option("--quality", options.quality, "Steps a voxel, march; instead of view.quality")
        ->type_name("NUMBER");
    command.add_option("--samples", options.samples, "Pictures averaged, march")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--planes", options.planes, "Slices, slicing; instead of view.planes")
        ->type_name("N");
    command.add_option("--format", options.format, "Pixels of an EXR: half or float")
        ->capture_default_str();
    command.add_flag("--profile", options.profile, "Tell the time of each pass, samples, memory");
}

void addPresets(CLI::App& app, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand("presets", "List, show and check presets");
    command.require_subcommand(0, 1);
    command.add_subcommand("list", "List presets; what `presets` alone does");
    command.add_subcommand("show", "Print a whole preset as JSON")
        ->add_option("PRESET", arguments.preset, "Name or file")
        ->required();
    command.add_subcommand("check", "Check preset files")
        ->add_option("FILE", arguments.presets, "Names or files")
        ->required();
    command.add_subcommand("parameters", "Print the reference of all parameters");
}

void addOthers(CLI::App& app, Arguments& arguments) {
    CLI::App& info = *app.add_subcommand(
        "info", "Describe files: model, grid, times, maxima of each species and where");
    info.add_option("FILE", arguments.info.files,
                    "Files of one series, or a folder; none: the bundled storm");
    info.add_option("--time", arguments.info.time,
                    "Times to read; else all, or of much data the first and the last")
        ->type_name("INDEX|a:b|all");
    addMemoryOption(info, arguments.info.memory);
    info.add_flag("--json", arguments.info.json, "As JSON");
    addReaderOption(info, arguments.info.readers);
    CLI::App& readers = *app.add_subcommand("readers", "List reader plugins");
    addReaderOption(readers, arguments.readers);
}

void addBench(CLI::App& app, BenchOptions& options) {
    CLI::App& command = *app.add_subcommand("bench", "Measure frame times, beside a floor");
    command.add_option("FILE", options.files, "Data; none: the bundled storm");
    command.add_option("--section", options.sections, "What to measure; may be a list")
        ->type_name("modes|changes|growth|window")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"modes", "changes", "growth", "window"}))
        ->capture_default_str();
    command.add_option("--size", options.sizes, "In pixels; none: each section's own")
        ->type_name("WxH")
        ->allow_extra_args(false);
    command.add_option("--grid", options.grids, "Cells, no coarser than the data; may be repeated")
        ->type_name("LONGEST|XxYxZ")
        ->allow_extra_args(false)
        ->capture_default_str();
    command.add_option("--engine", options.engine, "Whose frames; changes, growth: the first")
        ->check(CLI::IsMember({"march", "slicing", "both"}))
        ->capture_default_str();
    command.add_option("--steps", options.steps, "Or slices, of modes and of growth's first grid")
        ->check(CLI::Range(16, 2048))
        ->capture_default_str();
    command.add_option("--frames", options.frames, "Measured of each row")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--growth-to", options.growthTo, "Longest side of the last grid of growth")
        ->type_name("CELLS")
        ->check(CLI::Range(1, 2048))
        ->capture_default_str();
    command.add_option("--json", options.json, "File for the result; none: stdout");
    command.add_flag("--open", options.openOnly, "Opening and the first picture alone");
    addReaderOption(command, options.readers);
}

int runPresets(const CLI::App& command, const Arguments& arguments) {
    if (command.got_subcommand("show")) return runPresetsShow(arguments.preset);
    if (command.got_subcommand("check")) return runPresetsCheck(arguments.presets);
    if (command.got_subcommand("parameters")) return runPresetsParameters();
    return runPresetsList();
}

/// A file that is not there may be a command that was mistyped.
void checkForCommand(const CLI::App& app, const SceneOptions& options) {
    if (options.files.empty() || std::filesystem::exists(options.files.front())) return;
    const std::string& name = options.files.front();
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    const std::vector<std::string_view> known(commands.begin(), commands.end());
    const std::string_view near = nearestName(name, known);
    if (near.empty()) return;
    throw UsageError({"", fmt::format("there is no file and no command {}", name), "", "",
                      fmt::format("did you mean nephoscope {}?", near)});
}

int dispatch(const CLI::App& app, const Arguments& arguments) {
    if (app.got_subcommand("render")) return runRender(arguments.render);
    if (app.got_subcommand("info")) return runInfo(arguments.info);
    if (app.got_subcommand("readers")) return runReaders(arguments.readers);
    if (app.got_subcommand("bench")) return runBench(arguments.bench);
    if (app.got_subcommand("presets")) return runPresets(*app.get_subcommand("presets"), arguments);
    checkForCommand(app, arguments.workbench);
    return runWorkbench(arguments.workbench);
}

/// What to try after bad usage: the option nearest to one that is not known, else the help of the
/// command in question.
std::string usageHint(const CLI::App& app) {
    const auto parsed = app.get_subcommands();
    const CLI::App& command = parsed.empty() ? app : *parsed.front();
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    }
    const std::vector<std::string_view> known(options.begin(), options.end());
    for (const std::string& extra : app.remaining(true)) {
        const std::string_view near = extra.starts_with("--") ? nearestName(extra, known) : "";
        if (!near.empty()) return fmt::format("did you mean {}?", near);
    }
    return parsed.empty() ? "nephoscope --help"
                          : fmt::format("nephoscope {} --help", command.get_name());
}

int parseAndRun(int argc, char** argv) {
    Arguments arguments;
    CLI::App app(
        "Nephoscope renders the hydrometeors of weather models as an observer would see "
        "them.",
        "nephoscope");
    app.set_version_flag("--version", fmt::format("nephoscope {}", versionText()));
    app.require_subcommand(0, 1);
    addSceneOptions(app, arguments.workbench);
    addRender(app, arguments.render);
    addPresets(app, arguments);
    addOthers(app, arguments);
    addBench(app, arguments.bench);
    app.footer(std::string(kExamples));  // after the commands, which would take it over
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        if (fault.get_exit_code() == 0) return app.exit(fault);  // --help and --version
        throw UsageError({"", fault.what(), "", "", usageHint(app)});
    }
    return dispatch(app, arguments);
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
