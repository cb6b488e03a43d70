// compare_arguments.cpp: each option of `compare`, the field of CompareRequest that it fills, and
// what does not go together.
#include "app/cli/compare/compare_arguments.h"

#include <cmath>
#include <limits>
#include <memory>

#include "app/cli/compare/compare_command.h"
#include "app/cli/compare/compare_request.h"
#include "app/cli/render/render_arguments.h"
#include "core/base/atomic_file.h"

namespace neph {
namespace {

constexpr double kPerPercent = 0.01;
constexpr const char* kDrawing = "Of the data that are drawn, with --engine or --with-member";

double parseFinite(const std::string& option, const std::string& text, double above) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = fault == std::errc{} && end == text.data() + text.size();
    if (whole && std::isfinite(value) && value > above) return value;
    throw UsageError({option, "cannot take this value", text,
                      above == 0.0 ? "a number of percent above 0" : "a number", ""});
}

std::filesystem::path parsePng(const std::string& option, const std::string& text) {
    if (std::filesystem::path(text).extension() == ".png") return text;
    throw UsageError({option, "is a PNG file", text, "NAME.png", ""});
}

/// Returns the options that are of no use for two images.
std::vector<CLI::Option*> addDrawing(CLI::App& command, CompareRequest& request) {
    RenderRequest& render = request.render;
    addSceneOptions(command, render.scene);
    CLI::Option* files = command.get_option("FILE");
    files->description("A and B, PNG or EXR, B is the reference; or data");
    addViewOptions(command, render.from);
    addSizeOption(command, render.sizePx, "In pixels");
    addSampleOptions(command, render, "Samples per pixel, reference: else as --error");
    command.add_option("--out,-o", request.out, "Keep what engines draw, and images of errors")
        ->type_name("FOLDER");
    std::vector<CLI::Option*> drawing;
    for (CLI::Option* option : command.get_options()) {
        if (option == files || option == command.get_help_ptr()) continue;
        option->group(kDrawing);
        drawing.push_back(option);
    }
    const auto takeEngines = [&request](const std::vector<std::string>& texts) {
        request.engines = parseEngines(texts);
    };
    command
        .add_option_function<std::vector<std::string>>(
            "--engine", takeEngines, "Draw the data with these; the last is the reference")
        ->type_name("NAME[:ID=VALUE]...,NAME...")
        ->allow_extra_args(false);
    command
        .add_option("--with-member", request.render.beside.member,
                    "Draw --member of the ensemble and this one, which is the reference")
        ->type_name("NAME|N|mean");
    return drawing;
}

void addFigures(CLI::App& command, CompareRequest& request) {
    command.add_flag("--json", request.json, "As JSON");
    const auto png = [](const char* option) {
        return [option](const std::string& text) { return parsePng(option, text); };
    };
    addParsed(command, "--error-image", request.errorImage, png("--error-image"),
              "Relative errors of two images as colours")
        ->type_name("FILE.png");
    command.add_flag("--signed", request.bothSigns, "What is too bright or too dark, in those");
    const auto share = [](const std::string& text) {
        return kPerPercent * parseFinite("--error-to", text, 0.0);
    };
    addParsed(command, "--error-to", request.errorTo, share, "End of their scale; else what fits")
        ->type_name("PERCENT");
    addParsed(command, "--flip-image", request.flipImage, png("--flip-image"),
              "FLIP of two images as colours")
        ->type_name("FILE.png");
    const auto exposure = [](const std::string& text) {
        return parseFinite("--exposure", text, std::numeric_limits<double>::lowest());
    };
    addParsed(command, "--exposure", request.exposureEv, exposure,
              "Of FLIP; else all the reference has")
        ->type_name("EV");
}

void checkFiles(const CLI::App& command, const CompareRequest& request,
                const std::vector<CLI::Option*>& drawing) {
    refuseTyped(command, {"--out"}, "is for the images that engines draw",
                "--error-image FILE.png, --flip-image FILE.png");
    for (const CLI::Option* option : drawing) {
        if (option->count() == 0) continue;
        throw UsageError({.where = option->get_name(),
                          .what = "two images are compared, and nothing is drawn",
                          .hint = "leave it out, or --engine march,reference FILE..."});
    }
    if (request.render.scene.files.size() != 2) {
        throw UsageError({.what = "compare needs two images, the second is the reference",
                          .found = fmt::format("{}", request.render.scene.files.size()),
                          .expected = "nephoscope compare A.exr B.exr",
                          .hint = "or engines: --engine march,reference"});
    }
    if (request.errorImage.empty()) {
        refuseTyped(command, {"--signed", "--error-to"}, "there is no image of errors",
                    "--error-image FILE.png");
    }
    for (const auto& file : {request.errorImage, request.flipImage}) {
        if (!file.empty()) checkReplaceable(file);
    }
}

void checkEngines(const CLI::App& command, const CompareRequest& request) {
    refuseTyped(command, {"--error-image", "--flip-image"}, "is for two images",
                "--out FOLDER keeps those of all engines");
    if (request.out.empty()) {
        refuseTyped(command, {"--signed", "--error-to"}, "there is no image of errors",
                    "--out FOLDER");
    }
    const SceneRequest& scene = request.render.scene;
    if (!request.engines.empty()) {
        refuseTyped(command, {"--with-member"}, "--engine compares engines on one member",
                    "give one of the two; --set view.engine=NAME draws both members");
    } else if (scene.members.empty()) {
        refuseTyped(command, {"--with-member"}, "there is no ensemble", "--members RUN RUN...");
    }
    checkScene(command, scene, !scene.preset.empty());
    for (const Setting& setting : scene.settings) {
        if (request.engines.empty()) break;
        if (setting.row != &parameter("view.engine")) continue;
        throw UsageError({.where = "--set view.engine",
                          .what = "--engine names the engines",
                          .hint = "leave it out"});
    }
    checkView(request.render.from);
    checkOneTime(scene.times);
}

}  // namespace

Command addCompare(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("compare", "How far images are from a reference");
    const auto request = std::make_shared<CompareRequest>();
    const std::vector<CLI::Option*> drawing = addDrawing(command, *request);
    addFigures(command, *request);
    return {&command, [&command, request, drawing] {
                request->render.sampling.error = command.count("--error") > 0;
                if (!request->draws()) {
                    checkFiles(command, *request, drawing);
                } else {
                    checkEngines(command, *request);
                }
                return runCompare(*request);
            }};
}

}  // namespace neph
