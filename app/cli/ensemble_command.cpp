// ensemble_command.cpp: reads the members, and tells or writes what they have in common.
#include "app/cli/ensemble_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <numeric>
#include <utility>

#include "app/cli/common/interrupt.h"
#include "app/image_io/figure_file.h"
#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/base/resources.h"
#include "core/look/haze.h"
#include "core/look/old_metres.h"
#include "core/volume/ensemble_drawing.h"
#include "core/volume/ensemble_file.h"

namespace neph {
namespace {

constexpr double kMostThreshold = 1e6;
constexpr std::array<std::pair<const char*, EnsembleMap>, 3> kMapNames{
    {{"probability", EnsembleMap::probability},
     {"mean", EnsembleMap::mean},
     {"spread", EnsembleMap::spread}}};

EnsembleMap parseMap(const std::string& text) {
    for (const auto& [name, map] : kMapNames) {
        if (text == name) return map;
    }
    throw UsageError({"--show", "is not known", text, "probability, mean or spread", ""});
}

std::filesystem::path parseOut(const std::string& text) {
    const std::string ending = std::filesystem::path(text).extension().string();
    if (ending == ".nc" || ending == ".csv" || ending == ".png" || ending == ".svg") {
        return text;
    }
    throw UsageError({"--out " + text, "has no ending of a map",
                      ending.empty() ? "no ending" : ending, ".nc, .csv, .png or .svg", ""});
}

std::string sourceText() {
    return fmt::format("Nephoscope {}", versionText());
}

/// Share of the columns for which `holds`, in percent.
template <typename Holds>
std::string shareText(const std::vector<float>& values, const Holds& holds) {
    const auto count = static_cast<double>(std::ranges::count_if(values, holds));
    return numberText(100.0 * count / static_cast<double>(values.size()), 3) + " %";
}

double meanOver(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void printFigures(const EnsembleDepths& depths, double threshold) {
    const std::vector<float> probability = mapOf(depths, EnsembleMap::probability, threshold);
    const std::vector<float> mean = mapOf(depths, EnsembleMap::mean, threshold);
    fmt::print("Time     {}\nMembers  {}: {}\n", depths.timeLabel, depths.members.size(),
               fmt::join(depths.members, ", "));
    if (!depths.without.empty()) {
        fmt::print("Without  {}: no such time\n", fmt::join(depths.without, ", "));
    }
    fmt::print("Columns  {} x {} of {:.6g} x {:.6g} m\n", depths.grid.size.x, depths.grid.size.y,
               depths.grid.spacingM.x, depths.grid.spacingM.y);
    fmt::print(
        "Optical depth > {}\n"
        "  in any member        {} of the columns\n"
        "  in half of them      {}\n"
        "  in all of them       {}\n"
        "  mean probability     {} %\n",
        numberText(threshold, 6), shareText(probability, [](float p) { return p > 0.0f; }),
        shareText(probability, [](float p) { return p >= 0.5f; }),
        shareText(probability, [](float p) { return p >= 1.0f; }),
        numberText(100.0 * meanOver(probability), 3));
    fmt::print("Mean optical depth {} over the domain, {} at most\n", numberText(meanOver(mean), 3),
               numberText(static_cast<double>(*std::ranges::max_element(mean)), 3));
}

void writeMap(const EnsembleRequest& request, const EnsembleDepths& depths) {
    const std::string ending = request.out.extension().string();
    if (ending == ".nc") {
        replaceFile(request.out, ensembleNetcdf(depths, request.threshold, sourceText()));
    } else if (ending == ".csv") {
        replaceFile(request.out, ensembleCsv(depths, request.threshold, sourceText()));
    } else {
        Sheet sheet;
        sheet.sizePt = {640.0, 560.0};
        sheet.figures = {{ensembleFigure(depths, request.shown, request.threshold),
                          {glm::dvec2(0.0), sheet.sizePt}}};
        sheet.metadata = {{"Software", sourceText()},
                          {"nephoscope.data", fmt::format("{}; members {}", depths.timeLabel,
                                                          fmt::join(depths.members, ", "))}};
        writeSheet(request.out, sheet);
    }
    fmt::print(stderr, "wrote {}\n", request.out.string());
}

void check(const CLI::App& command, const EnsembleRequest& request) {
    checkSetOnce(request.scene.settings);
    checkOneTime(request.scene.times);
    if (request.out.extension() != ".png" && request.out.extension() != ".svg") {
        refuseTyped(command, {"--show"}, "is of a plot",
                    "leave it out: .nc and .csv hold all maps");
    }
    if (!request.out.empty()) checkReplaceable(request.out);
}

}  // namespace

void runEnsemble(const EnsembleRequest& request, const Progress& progress) {
    const SceneRequest& asked = request.scene;
    Scene scene = makeScene(asked);
    // The renderer's memory is no bound here: nothing is drawn.
    const MemoryBudget budget = chooseBudget(asked.memory, MemoryBudget{}.gpu, scene.warnings);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
    const std::shared_ptr<Dataset> dataset =
        openData({}, asked.members, PluginHost::standard(asked.readers, asked.map), progress);
    const DatasetInfo& info = dataset->info();
    for (const std::string& note : info.notes) fmt::print(stderr, "note: {}\n", note);
    Look& look = scene.document.look;
    bringToCells(look, std::exchange(scene.inMetres, 0), meanCellM(info.spacingM));
    const VolumeRequest wanted{asked.region, budget, planRadii(look, info)};
    for (const std::string& note : wanted.radii.notes) fmt::print(stderr, "note: {}\n", note);
    const int time = timesOf(asked.times, info).front();
    const EnsembleDepths depths =
        readEnsembleDepths(*ensembleOf(*dataset), time, wanted, look, {}, progress);
    fmt::print(stderr, "note: optical depths are as images have them: {}\n", depths.scale);
    printFigures(depths, request.threshold);
    if (!request.out.empty()) writeMap(request, depths);
}

Command addEnsemble(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "ensemble", "Probability that the optical depth exceeds a threshold, over several runs");
    const auto request = std::make_shared<EnsembleRequest>();
    SceneRequest& scene = request->scene;
    command
        .add_option("RUN", scene.members,
                    "Runs of one grid: each a file, a folder or a quoted pattern; or one folder "
                    "that holds them")
        ->required();
    addPresetOptions(command, scene);
    addTimeOption(command, scene.times, "Time index; else the middle one");
    addNumber(command, "--exceeds", request->threshold, 0.0, kMostThreshold,
              "Optical depth that is exceeded", "1");
    addParsed(command, "--show", request->shown, parseMap,
              "Map of a PNG: probability, mean or spread", "probability")
        ->type_name("MAP");
    addParsed(command, "--out,-o", request->out, parseOut, "Maps as a file; else figures alone")
        ->type_name("P.nc|P.csv|P.png|P.svg");
    addParsed(command, "--region", scene.region, parseRegion,
              "Part of the domain in km; else all of it")
        ->type_name("x0:x1,y0:y1[,z0:z1]");
    addMemoryOption(command, scene.memory);
    addReaderOption(command, scene.readers);
    addMapOption(command, scene.map);
    return {&command, [&command, request] {
                check(command, *request);
                noteInterrupts();
                try {
                    runEnsemble(*request, untilInterrupted());
                } catch (const Cancelled&) {
                    return 128 + interruptSignal();
                }
                return 0;
            }};
}

}  // namespace neph
