// command_line.cpp: the grammar of the command line, in one place.
#include "app/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "app/cli/bench/bench_command.h"
#include "app/cli/common/scene_arguments.h"
#include "app/cli/compare/compare_command.h"
#include "app/cli/info/info_command.h"
#include "app/cli/presets_command.h"
#include "app/cli/readers_command.h"
#include "app/cli/render/render_command.h"
#include "app/cli/render/thumbnails_command.h"
#include "app/cli/validate_command.h"
#include "app/ui/shell/key_table.h"
#include "app/workbench/workbench.h"
#include "core/base/names.h"
#include "core/base/resources.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

constexpr std::string_view kExamples = R"(Examples:
  nephoscope                                        look at the bundled storm
  nephoscope wrfout_d01_2024-05-06_*                look at your own run, all files as one series
  nephoscope render --out storm.png                 a picture without a display
  nephoscope render wrfout_d01 --time all --out storm.png --preset fig06-physical
  nephoscope render --out storm.exr --set cloud.mixing_scale=0.5 --set sun.elevation=10
  nephoscope render wrfout_d01 --region 20:60,30:70 --memory 2GiB --out core.png
  nephoscope render --session s.nephoscope.json --along-path --out flight.mp4
  nephoscope render --preset fig06-physical --preset-b fig05-equal-extinction --out ab.png
  nephoscope compare march.exr reference.exr        how far one picture is from another
  nephoscope presets show default > mine.json       a preset to edit
  nephoscope info wrfout_d01 --json                 what is in a file
Exit status: 0 done, 1 bad input or failed work, 2 bad usage.
)";

struct Arguments {
    SceneOptions workbench;
    std::string session;
    RenderOptions render;
    ComparisonOptions compare;
    InfoOptions info;
    BenchOptions bench;
    ThumbnailOptions thumbnails;
    PresetsOptions presets;
    ValidateOptions validate;
    std::vector<std::string> readers;
};

/// Where the picture starts from, where the camera goes, and what is beside it.
void addSessionOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--session", options.session, "Start from what a session file holds")
        ->type_name("FILE");
    command.add_option("--slot", options.slot, "Of the session; else the one last edited")
        ->type_name("1|2");
    addViewOptions(command, options.observer, options.view);
    command.add_option("--path", options.path, "Pictures along a camera path")->type_name("FILE");
    command.add_flag("--along-path", options.alongPath, "Along the camera path of the session");
    command.add_option("--fps", options.fps, "Pictures a second, of films and paths")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--frames", options.frames, "Pictures along the path; else as --fps says")
        ->type_name("N");
    command.add_flag("--compare", options.compare.slots, "Both slots of the session side by side");
    command.add_option("--preset-b", options.compare.preset, "Beside the picture: another preset")
        ->type_name("NAME|FILE");
    command.add_option("--time-b", options.compare.time, "Beside the picture: another time")
        ->type_name("INDEX");
    command.add_option("--split", options.compare.splitAt, "Share of the width for the first")
        ->type_name("SHARE");
}

/// An option that stands for a parameter, as its row has it.
void addAlias(CLI::App& command, std::string_view option, std::string& text) {
    const OptionAlias& alias = parameterOfOption(option).alias;
    command.add_option(std::string(alias.name), text, std::string(alias.help))
        ->type_name(std::string(alias.takes));
}

/// How well the march and the reference are to draw.
void addSampleOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--samples", options.samples,
                    "Pictures averaged, march: else 8; paths a pixel, reference: else as --error")
        ->type_name("N");
    addAlias(command, "--error", options.error);
    addAlias(command, "--seed", options.seed);
}

void addRender(CLI::App& app, RenderOptions& options) {
    CLI::App& command = *app.add_subcommand("render", "Render to a file; needs no display");
    addSceneOptions(command, options.scene);
    command.add_option("--out,-o", options.out, "Picture to write, or film of all pictures")
        ->type_name("P.png|P.exr|P.mp4")
        ->capture_default_str();
    command.add_option("--size", options.size, "In pixels")
        ->type_name("WxH")
        ->capture_default_str();
    addAlias(command, "--engine", options.engine);
    addAlias(command, "--quality", options.quality);
    addSampleOptions(command, options);
    addAlias(command, "--planes", options.planes);
    command.add_option("--format", options.format, "Pixels of an EXR: half or float")
        ->capture_default_str();
    command.add_option("--supersample", options.supersample, "Rays a pixel, a side: 1 to 4")
        ->type_name("N")
        ->capture_default_str();
    command.add_flag("--transparent", options.transparent, "Without sky and ground");
    command.add_flag("--profile", options.profile, "Tell the time of each pass, samples, memory");
    command.add_flag("--progress", options.progress, "A JSON object a picture on stdout");
    addSessionOptions(command, options);
}

void addCompare(CLI::App& app, ComparisonOptions& options) {
    CLI::App& command = *app.add_subcommand("compare", "How far pictures are from a reference");
    RenderOptions& render = options.render;
    addSceneOptions(command, render.scene);
    command.get_option("FILE")->description("A and B, PNG or EXR, B is the reference; or data");
    command
        .add_option("--engine", options.engines,
                    "Draw the data with these; the last is the reference")
        ->type_name("NAME[:ID=VALUE]...,NAME...")
        ->allow_extra_args(false);
    addViewOptions(command, render.observer, render.view);
    command.add_option("--size", render.size, "In pixels, of what engines draw")
        ->type_name("WxH")
        ->capture_default_str();
    addAlias(command, "--planes", render.planes);
    addSampleOptions(command, render);
    command.add_flag("--json", options.json, "As JSON");
    command.add_option("--error-picture", options.errorPicture, "Relative errors as colours")
        ->type_name("FILE.png");
    command.add_flag("--signed", options.bothSigns, "What is too bright or too dark, in those");
    command.add_option("--error-to", options.errorTo, "End of their scale; else what fits")
        ->type_name("PERCENT");
    command.add_option("--flip-picture", options.flipPicture, "FLIP as colours")
        ->type_name("FILE.png");
    command.add_option("--exposure", options.exposureEv, "Of FLIP; else all the reference has")
        ->type_name("EV");
    command.add_option("--out,-o", options.out, "Keep what engines draw, and pictures of errors")
        ->type_name("FOLDER");
}

void addThumbnails(CLI::App& app, ThumbnailOptions& options) {
    CLI::App& command = *app.add_subcommand("thumbnails", "Small pictures of presets");
    command.add_option("--preset", options.presets, "Name or file; may be repeated; else all")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false);
    command.add_option("--out,-o", options.out, "Else where the preset browser looks for them")
        ->type_name("FOLDER");
    command.add_option("--size", options.size, "In pixels, with --out")->type_name("WxH");
    command.add_flag("--progress", options.progress, "A JSON object a picture on stdout");
}

void addPresetFiles(CLI::App& presets, PresetsOptions& options) {
    CLI::App& save = *presets.add_subcommand("save", "Save a look and camera as one of yours");
    save.add_option("NAME", options.preset, "Its name")->required();
    save.add_option("--preset", options.scene.preset, "To start from; else default")
        ->type_name("NAME|FILE");
    save.add_option("--set", options.scene.assignments, "Set one parameter; may be repeated")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false);
    save.add_option("--camera", options.scene.camera, "Camera of a preset, or a file with one")
        ->type_name("NAME|FILE");
    save.add_flag("--replace", options.replace, "Replace one of yours of that name");
    CLI::App& duplicate = *presets.add_subcommand("duplicate", "Copy a preset to one of yours");
    duplicate.add_option("PRESET", options.preset, "Name or file")->required();
    duplicate.add_option("NAME", options.other, "Of the copy; else one that is free");
    CLI::App& rename = *presets.add_subcommand("rename", "Rename one of yours");
    rename.add_option("PRESET", options.preset, "Its name")->required();
    rename.add_option("NAME", options.other, "Its new name")->required();
    CLI::App& describe = *presets.add_subcommand("describe", "Other words for one of yours");
    describe.add_option("PRESET", options.preset, "Its name")->required();
    for (CLI::App* command : {&save, &describe}) {
        command->add_option("--title", options.title, "One line")->type_name("TEXT");
        command->add_option("--description", options.description, "More")->type_name("TEXT");
    }
    presets.add_subcommand("delete", "Move some of yours to the trash")
        ->add_option("PRESET", options.several, "Names")
        ->required();
}

void addPresets(CLI::App& app, PresetsOptions& options) {
    CLI::App& command = *app.add_subcommand("presets", "List, show, compare and keep presets");
    command.require_subcommand(0, 1);
    command.add_subcommand("list", "List presets; what `presets` alone does");
    command.add_subcommand("show", "Print a whole preset as JSON")
        ->add_option("PRESET", options.preset, "Name or file")
        ->required();
    command.add_subcommand("check", "Check preset files")
        ->add_option("FILE", options.several, "Names or files")
        ->required();
    CLI::App& diff = *command.add_subcommand("diff", "In what two presets differ");
    diff.add_option("A", options.preset, "Name or file")->required();
    diff.add_option("B", options.other, "Name or file")->required();
    command.add_subcommand("parameters", "Print the reference of all parameters");
    addPresetFiles(command, options);
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
    app.add_subcommand("keys", "Print the table of the window's commands and keys");
}

void addBench(CLI::App& app, BenchOptions& options) {
    CLI::App& command = *app.add_subcommand("bench", "Measure frame times, beside a floor");
    command.add_option("FILE", options.files, "Data; none: the bundled storm");
    command.add_option("--section", options.sections, "What to measure; may be a list")
        ->type_name("modes|changes|growth|window|reference")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"modes", "changes", "growth", "window", "reference"}))
        ->capture_default_str();
    command.add_option("--size", options.sizes, "In pixels; none: each section's own")
        ->type_name("WxH")
        ->allow_extra_args(false);
    command.add_option("--grid", options.grids, "Cells, no coarser than the data; may be repeated")
        ->type_name("LONGEST|XxYxZ")
        ->allow_extra_args(false)
        ->capture_default_str();
    command.add_option("--engine", options.engine, "Whose frames; changes, growth: the first")
        ->check(CLI::IsMember(benchEngines()))
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

void addValidate(CLI::App& app, ValidateOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "validate", "Prove the path tracer against published results, or measure a scene");
    command.add_option("CASE.json", options.files, "Scenes to measure; none: all that is bundled");
    command.add_flag("--quick", options.quick, "In a minute, with tolerances ten times as wide");
    command.add_flag("--json", options.json, "As JSON");
    command.add_option("--only", options.only, "What has this in its name")->type_name("TEXT");
    command.add_option("--samples", options.samples, "Paths a detector, at least")
        ->type_name("N")
        ->check(CLI::Range(1, 1 << 30));
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
    if (app.got_subcommand("compare")) return runCompare(arguments.compare);
    if (app.got_subcommand("thumbnails")) return runThumbnails(arguments.thumbnails);
    if (app.got_subcommand("info")) return runInfo(arguments.info);
    if (app.got_subcommand("readers")) return runReaders(arguments.readers);
    if (app.got_subcommand("bench")) return runBench(arguments.bench);
    if (app.got_subcommand("validate")) return runValidate(arguments.validate);
    if (app.got_subcommand("keys")) {
        std::fputs(ui::keyTable().c_str(), stdout);
        return 0;
    }
    if (app.got_subcommand("presets")) {
        const auto chosen = app.get_subcommand("presets")->get_subcommands();
        return runPresets(chosen.empty() ? "list" : chosen.front()->get_name(), arguments.presets);
    }
    checkForCommand(app, arguments.workbench);
    SceneOptions workbench = arguments.workbench;
    if (!arguments.session.empty()) {
        loadSession(arguments.session);  // says now what is wrong with it
        workbench.files = {arguments.session};
    }
    return runWorkbench(workbench);
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
    app.add_option("--session", arguments.session, "Open a session; FILE may be one as well")
        ->type_name("FILE");
    app.add_option("--script", arguments.workbench.script, "Commands to play into the window")
        ->type_name("FILE");
    addRender(app, arguments.render);
    addCompare(app, arguments.compare);
    addThumbnails(app, arguments.thumbnails);
    addPresets(app, arguments.presets);
    addOthers(app, arguments);
    addBench(app, arguments.bench);
    addValidate(app, arguments.validate);
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
