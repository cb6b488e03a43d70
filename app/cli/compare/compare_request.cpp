// compare_request.cpp: lists of engines.
#include "app/cli/compare/compare_request.h"

#include "app/workbench/quality.h"

namespace neph {
namespace {

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = text.find(at);
        parts.emplace_back(text.substr(0, end));
        if (end == text.npos) return parts;
        text.remove_prefix(end + 1);
    }
}

ComparedEngine parseEngine(const std::string& name) {
    std::vector<std::string> parts = split(name, ':');
    parts.front().insert(0, "view.engine=");
    ComparedEngine engine{name, {}};
    for (const std::string& assignment : parts) {
        engine.settings.push_back(
            asUsage("--engine " + name, [&] { return parseSetting("--engine", assignment); }));
        const Parameter& row = *engine.settings.back().row;
        if (row.invalidates == Stage::data) {
            throw UsageError({.where = "--engine " + name,
                              .what = row.id + " changes what is read",
                              .expected = "the same data for all engines",
                              .hint = "--set " + assignment});
        }
    }
    asUsage("--engine " + name, [&] { checkSetOnce(engine.settings); });
    return engine;
}

}  // namespace

std::vector<ComparedEngine> parseEngines(const std::vector<std::string>& texts) {
    std::vector<ComparedEngine> engines;
    for (const std::string& text : texts) {
        for (const std::string& name : split(text, ',')) engines.push_back(parseEngine(name));
    }
    if (engines.size() >= 2) return engines;
    throw UsageError({.where = "--engine",
                      .what = "there is nothing to compare with",
                      .expected = "two engines or more, the last of which is the reference",
                      .hint = "--engine march,reference"});
}

SamplePlan planSamples(const CompareRequest& request, const ParameterSet& drawn) {
    if (traitsOf(drawn.look.engine).refinement == Refinement::averages) return {ui::kSamples, 0.0};
    return planSamples(request.render.sampling, drawn);
}

}  // namespace neph
