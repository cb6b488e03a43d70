// validate_command.cpp: trials one by one, each told as soon as it is done.
#include "app/cli/validate_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/cli/common/interrupt.h"
#include "app/cli/common/usage.h"
#include "app/gl/context.h"
#include "app/validate/checks.h"
#include "app/validate/runner.h"
#include "app/validate/scene_file.h"
#include "core/base/resources.h"

namespace neph {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using namespace validate;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// In the order of their names.
std::vector<std::filesystem::path> bundledCases() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(resourcePath("tests/validation"))) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

void append(std::vector<Trial>& trials, std::vector<Trial>&& more) {
    std::ranges::move(more, std::back_inserter(trials));
}

/// Of the files, or of all that there is to prove.
std::vector<Trial> chooseTrials(const ValidateRequest& request) {
    std::vector<Trial> trials;
    std::vector<std::filesystem::path> files(request.files.begin(), request.files.end());
    if (files.empty()) {
        append(trials, transmissionTrials());
        append(trials, singleScatteringTrials());
        append(trials, furnaceTrials());
        append(trials, invarianceTrials());
        append(trials, sphereTrials());
        files = bundledCases();
    }
    for (const std::filesystem::path& file : files) {
        append(trials, trialsOf(loadSceneFile(file), file.string()));
    }
    std::erase_if(trials, [&](const Trial& trial) {
        return (request.quick && !trial.quick) || trial.name.find(request.only) == trial.name.npos;
    });
    return trials;
}

std::string_view wordOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::none:
            break;
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "FAIL";
        case Verdict::noisy:
            return "NOISY";
    }
    return "";
}

class Report {
  public:
    Report(const ValidateRequest& request, std::string renderer)
        : request_(request), renderer_(std::move(renderer)) {
        if (!request_.json) fmt::print("{}\n", renderer_);
    }

    void add(const std::vector<Row>& rows, double seconds) {
        if (rows.empty()) return;
        if (!request_.json) {
            fmt::print("\n{}\n", rows.front().trial);
            if (!rows.front().source.empty()) fmt::print("expected: {}\n", rows.front().source);
            fmt::print("  {:<42}{:>12}{:>12}{:>11}{:>11}\n", "quantity", "expected", "measured",
                       "sigma", "tolerance");
        }
        for (const Row& row : rows) addRow(row);
        if (request_.json) return;
        fmt::print("  {:.1f} s\n", seconds);
        std::fflush(stdout);
    }

    /// The exit status.
    int close(double seconds) {
        if (request_.json) {
            const Json document{{"type", "nephoscope-validation"},
                                {"version", 1},
                                {"program", versionText()},
                                {"renderer", renderer_},
                                {"quick", request_.quick},
                                {"seconds", seconds},
                                {"samples", samples_},
                                {"passed", passed_},
                                {"failed", failed_},
                                {"checks", checks_}};
            fmt::print("{}\n", document.dump(1));
        } else {
            fmt::print("\n{} passed, {} failed; {} paths in {:.0f} s{}\n", passed_, failed_,
                       samples_, seconds,
                       request_.quick ? "; quick: tolerances are ten times as wide" : "");
        }
        return failed_ == 0 ? 0 : 1;
    }

  private:
    void addRow(const Row& row) {
        const Verdict result = verdict(row);
        passed_ += result == Verdict::pass;
        failed_ += result == Verdict::fail || result == Verdict::noisy;
        samples_ += row.samples;
        if (request_.json) {
            Json json{{"case", row.trial},  {"quantity", row.quantity}, {"measured", row.measured},
                      {"sigma", row.sigma}, {"samples", row.samples},   {"source", row.source}};
            if (row.expected) {
                json["expected"] = *row.expected;
                json["tolerance"] = row.tolerance;
                json["passed"] = result == Verdict::pass;
            }
            checks_.push_back(std::move(json));
        } else if (row.expected) {
            fmt::print("  {:<42}{:>12.6f}{:>12.6f}{:>11.6f}{:>11.6f}  {}\n", row.quantity,
                       *row.expected, row.measured, row.sigma, row.tolerance, wordOf(result));
        } else {
            fmt::print("  {:<42}{:>12}{:>12.6f}{:>11.6f}\n", row.quantity, "", row.measured,
                       row.sigma);
        }
    }

    const ValidateRequest& request_;
    std::string renderer_;
    Json checks_ = Json::array();
    int passed_ = 0, failed_ = 0;
    std::uint64_t samples_ = 0;
};

Effort effortOf(const ValidateRequest& request) {
    Effort effort = request.quick ? kQuickEffort : kFullEffort;
    if (request.samples > 0) {
        effort.first = request.samples;
        effort.most = std::max(effort.most, request.samples);
    }
    return effort;
}

/// Whether any was asked for.
bool reportSky(const ValidateRequest& request, Report& report) {
    if (!request.files.empty()) return false;
    const auto start = Clock::now();
    bool any = false;
    for (const std::vector<Row>& rows : skyRows()) {
        if (rows.front().trial.find(request.only) == std::string::npos) continue;
        report.add(rows, any ? 0.0 : secondsSince(start));
        any = true;
    }
    return any;
}

void measureAll(const ValidateRequest& request, render::TraceMeter& meter, Report& report) {
    const Progress goesOn = untilInterrupted();
    const std::vector<Trial> trials = chooseTrials(request);
    if (!reportSky(request, report) && trials.empty()) {
        throw UsageError({.where = request.only.empty() ? "--quick" : "--only " + request.only,
                          .what = "leaves nothing to measure",
                          .hint = "nephoscope validate names all on stderr as it goes"});
    }
    const Effort effort = effortOf(request);
    std::size_t done = 0;
    std::vector<Row> all;
    for (const Trial& trial : trials) {
        fmt::print(stderr, "{} of {}: {}\n", ++done, trials.size(), trial.name);
        const auto start = Clock::now();
        const std::vector<Row> rows = runTrial(meter, trial, effort, goesOn);
        report.add(rows, secondsSince(start));
        all.insert(all.end(), rows.begin(), rows.end());
    }
    if (!request.files.empty() || !request.only.empty()) return;
    if (const auto together = allTogether(all, effort)) report.add({*together}, 0.0);
    fmt::print(stderr, "Scattering angles of every phase function\n");
    const auto start = Clock::now();
    const std::vector<Row> rows = phaseRows(meter, request.quick);
    report.add(rows, secondsSince(start));
}

}  // namespace

int runValidate(const ValidateRequest& request) {
    constexpr int kSignalBase = 128;  // as shells report what a signal has ended
    noteInterrupts();
    const gl::HeadlessContext context;
    render::TraceMeter meter(resourcePath("shaders"));
    Report report(request, meter.deviceName());
    const auto start = Clock::now();
    try {
        measureAll(request, meter, report);
    } catch (const Cancelled&) {
        fmt::print(stderr, "interrupted\n");
        return kSignalBase + interruptSignal();
    }
    return report.close(secondsSince(start));
}

}  // namespace neph
