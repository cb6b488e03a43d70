// bench_arguments.cpp: each option of `bench`, the field of BenchRequest that it fills, and the
// sections that it is of.
#include "app/cli/bench/bench_arguments.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "app/cli/bench/bench_command.h"
#include "app/cli/render/render_request.h"

namespace neph {
namespace {

using namespace bench;

constexpr int kMaxCells = 2048;  // a side: what every OpenGL 4.5 driver takes
constexpr int kMinSteps = 16, kMaxSteps = 2048, kMaxMeasured = 1000;

GridRequest parseGrid(const std::string& text) {
    std::vector<int> cells;
    const char* at = text.data();
    const char* end = at + text.size();
    bool whole = false;
    while (!whole) {
        int number = 0;
        const auto [next, fault] = std::from_chars(at, end, number);
        if (fault != std::errc{} || number < 1 || number > kMaxCells) break;
        cells.push_back(number);
        whole = next == end;
        if (!whole && *next != 'x') break;
        at = next + 1;
    }
    if (whole && cells.size() == 1) return {cells[0], {}};
    if (whole && cells.size() == 3) return {0, {cells[0], cells[1], cells[2]}};
    throw UsageError(
        {"--grid", "cannot be read as a grid", text,
         fmt::format("N cells along the longest side, or XxYxZ, each from 1 to {}", kMaxCells),
         ""});
}

Section parseSection(const std::string& name) {
    const auto found = std::ranges::find(kSectionNames, name);
    if (found != kSectionNames.end()) return static_cast<Section>(found - kSectionNames.begin());
    throw UsageError({"--section", "is not known", name,
                      fmt::format("one of {}", fmt::join(kSectionNames, ", ")), ""});
}

constexpr std::string_view kAllNamed = "all";

/// Names of the engines that are measured.
std::vector<std::string_view> engineNames() {
    std::vector<std::string_view> names;
    for (const Engine engine : measuredEngines()) names.push_back(traitsOf(engine).id);
    return names;
}

std::vector<Engine> parseEngine(const std::string& name) {
    if (name == kAllNamed) return measuredEngines();
    for (const Engine engine : measuredEngines()) {
        if (traitsOf(engine).id == name) return {engine};
    }
    throw UsageError({"--engine", "is not known", name,
                      fmt::format("{} or {}", fmt::join(engineNames(), ", "), kAllNamed), ""});
}

/// An option that may be repeated, each text of which is a value of the list.
template <typename Value, typename Parse>
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<Value>& list,
                     Parse parse, const std::string& help) {
    const auto take = [&list, parse](const std::vector<std::string>& texts) {
        list.clear();
        for (const std::string& text : texts) list.push_back(parse(text));
    };
    return command.add_option_function<std::vector<std::string>>(name, take, help)
        ->allow_extra_args(false);
}

/// An option, and the sections that heed it.
struct Heeded {
    const char* option;
    std::vector<Section> by;
};

const std::vector<Heeded>& heeded() {
    using enum Section;
    static const std::vector<Heeded> list{{"--grid", {modes, changes, growth, window}},
                                          {"--engine", {modes, changes, growth, window}},
                                          {"--steps", {modes, growth}},
                                          {"--frames", {modes, changes, growth, reference}},
                                          {"--growth-to", {growth}}};
    return list;
}

bool anyOf(const BenchRequest& request, const std::vector<Section>& sections) {
    return std::ranges::any_of(request.sections, [&](Section section) {
        return std::ranges::find(sections, section) != sections.end();
    });
}

void refuseSeveral(const BenchRequest& request, const char* option, std::size_t count,
                   const std::vector<Section>& by) {
    if (count < 2 || anyOf(request, by)) return;
    throw UsageError({.where = option,
                      .what = "the sections asked for take the first alone",
                      .found = std::to_string(count),
                      .hint = "give one"});
}

void check(const CLI::App& command, const BenchRequest& request) {
    checkSetOnce(request.scene.settings);
    if (request.openOnly) {
        refuseTyped(
            command,
            {"--section", "--size", "--grid", "--engine", "--steps", "--frames", "--growth-to"},
            "no section is measured with --open", "leave out one of the two");
    }
    using enum Section;
    for (const Heeded& each : heeded()) {
        if (command.count(each.option) == 0 || anyOf(request, each.by)) continue;
        std::vector<std::string_view> names;
        for (const Section section : each.by) {
            names.push_back(kSectionNames[static_cast<std::size_t>(section)]);
        }
        throw UsageError({.where = each.option,
                          .what = "no section that is measured heeds it",
                          .expected = fmt::format("--section {}", fmt::join(names, " or ")),
                          .hint = "leave it out"});
    }
    refuseSeveral(request, "--size", request.sizesPx.size(), {modes, window, reference});
    refuseSeveral(request, "--grid", request.grids.size(), {modes});
    if (command.count("--engine") > 0) {
        refuseSeveral(request, "--engine", request.engines.size(), {modes, window});
    }
}

void addSections(CLI::App& command, BenchRequest& request) {
    addList(command, "--section", request.sections, parseSection, "What to measure; may be a list")
        ->type_name(fmt::format("{}", fmt::join(kSectionNames, "|")))
        ->delimiter(',')
        ->default_str("modes,changes");
    addList(command, "--size", request.sizesPx, parseSize, "In pixels; none: each section's own")
        ->type_name("WxH");
    addList(command, "--grid", request.grids, parseGrid,
            "Cells, no coarser than the data; may be repeated")
        ->type_name("LONGEST|XxYxZ")
        ->default_str("128");
    addParsed(command, "--engine", request.engines, parseEngine,
              "Whose frames; changes, growth: the first", std::string(kAllNamed))
        ->type_name(fmt::format("{}|{}", fmt::join(engineNames(), "|"), kAllNamed));
    addNumber(command, "--steps", request.steps, kMinSteps, kMaxSteps,
              "Or slices, of modes and of growth's first grid", "128");
    addNumber(command, "--frames", request.frames, 1, kMaxMeasured, "Measured of each row", "12");
    addNumber(command, "--growth-to", request.growthTo, 1, kMaxCells,
              "Longest side of the last grid of growth", "256")
        ->type_name("CELLS");
}

}  // namespace

Command addBench(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("bench", "Measure frame times, beside a floor");
    const auto request = std::make_shared<BenchRequest>();
    command.add_option("FILE", request->scene.files, "Data; none: the bundled storm");
    addLookOptions(command, request->scene);
    addSections(command, *request);
    command.add_option("--json", request->json, "File for the result; none: stdout")
        ->type_name("FILE");
    command.add_flag("--open", request->openOnly, "Opening and the first image alone");
    addReaderOption(command, request->scene.readers);
    return {&command, [&command, request] {
                check(command, *request);
                return runBench(*request);
            }};
}

}  // namespace neph
