// compare_options.cpp: lists of engines, and options that do not go together.
#include "app/cli/compare/compare_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "app/workbench/quality.h"
#include "core/base/atomic_file.h"

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

void checkPng(const std::string& option, const std::string& file) {
    if (file.empty()) return;
    if (std::filesystem::path(file).extension() != ".png") {
        throw UsageError({option, "is a PNG file", file, "NAME.png", ""});
    }
    checkReplaceable(file);
}

}  // namespace

std::vector<ComparedEngine> parseEngines(const std::vector<std::string>& texts) {
    std::vector<ComparedEngine> engines;
    for (const std::string& text : texts) {
        for (const std::string& name : split(text, ',')) {
            std::vector<std::string> parts = split(name, ':');
            parts.front().insert(0, "view.engine=");
            ParameterSet scratch;
            for (const std::string& assignment : parts) {
                try {
                    applyAssignment(scratch, assignment);
                } catch (const Error& error) {
                    ErrorParts told = error.parts();
                    told.where = "--engine " + name;
                    throw UsageError(told);
                }
                const Parameter& row = parameter(assignment.substr(0, assignment.find('=')));
                if (row.invalidates == Stage::data) {
                    throw UsageError({.where = "--engine " + name,
                                      .what = row.id + " changes what is read",
                                      .expected = "the same data for all engines",
                                      .hint = "--set " + assignment});
                }
            }
            engines.push_back({name, std::move(parts)});
        }
    }
    if (engines.size() < 2) {
        throw UsageError({.where = "--engine",
                          .what = "there is nothing to compare with",
                          .expected = "two engines or more, the last of which is the reference",
                          .hint = "--engine march,reference"});
    }
    return engines;
}

std::optional<double> parseOptionalNumber(const std::string& option, const std::string& text) {
    if (text.empty()) return {};
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault == std::errc{} && end == text.data() + text.size() && std::isfinite(value)) {
        return value;
    }
    throw UsageError({option, "cannot be read", text, "a number", ""});
}

SamplePlan planSamples(const ComparisonOptions& options, const ParameterSet& drawn) {
    if (traitsOf(drawn.look.engine).refinement == Refinement::averages) return {ui::kSamples, 0.0};
    return planSamples(options.render, drawn);
}

void checkOptions(const ComparisonOptions& options) {
    const std::optional<double> most = parseOptionalNumber("--error-to", options.errorTo);
    if (most && !(*most > 0.0)) {
        throw UsageError({"--error-to", "is no end of a scale", options.errorTo,
                          "a number of percent above 0", ""});
    }
    parseOptionalNumber("--exposure", options.exposureEv);
    checkPng("--error-picture", options.errorPicture);
    checkPng("--flip-picture", options.flipPicture);
    if (options.engines.empty()) {
        if (options.render.scene.files.size() != 2) {
            throw UsageError({.what = "compare needs two pictures, the second is the reference",
                              .found = fmt::format("{}", options.render.scene.files.size()),
                              .expected = "nephoscope compare A.exr B.exr",
                              .hint = "or engines: --engine march,reference"});
        }
        if (!options.out.empty()) {
            throw UsageError({.where = "--out",
                              .what = "is for the pictures that engines draw",
                              .hint = "--error-picture FILE.png, --flip-picture FILE.png"});
        }
        return;
    }
    if (!options.errorPicture.empty() || !options.flipPicture.empty()) {
        throw UsageError(
            {.where = options.errorPicture.empty() ? "--flip-picture" : "--error-picture",
             .what = "is for two pictures",
             .hint = "--out FOLDER keeps those of all engines"});
    }
    parseEngines(options.engines);
    parseSize(options.render.size);
}

}  // namespace neph
