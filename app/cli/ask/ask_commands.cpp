// ask_commands.cpp: the options of the commands that ask data.
#include "app/cli/ask/ask_commands.h"

#include <fmt/format.h>

#include <memory>

#include "app/cli/ask/ask_run.h"
#include "app/cli/render/render_request.h"
#include "core/base/atomic_file.h"

namespace neph {
namespace {

void addData(CLI::App& command, AskedData& data, const std::string& times) {
    command.add_option("FILE", data.files,
                       "Files of one series, or a folder; none: the bundled storm");
    addTimeOption(command, data.times, times);
    addReaderOption(command, data.readers);
    addMapOption(command, data.map);
}

NamedPlace placeOfOption(const std::string& option, const std::string& text) {
    if (const auto place = parsePlace(text)) return *place;
    throw UsageError({option, "is not a place", text,
                      "latitude and longitude as 35.2N,97.4W, or x and y in km from the domain's "
                      "south-west corner as 55,28",
                      ""});
}

template <typename Target>
CLI::Option* addPlace(CLI::App& command, const std::string& name, Target& place,
                      const std::string& help) {
    return addParsed(
               command, name, place,
               [name](const std::string& text) { return placeOfOption(name, text); }, help)
        ->type_name("LAT,LON|X,Y");
}

Quantity quantityOfOption(const std::string& option, const std::string& text) {
    if (const auto quantity = quantityOf(text)) return *quantity;
    throw UsageError({option, "is not known", text, "one of " + quantityIds(), ""});
}

std::filesystem::path parseOutFile(const std::string& text, bool netcdf) {
    const std::filesystem::path file(text);
    const std::string kind = file.extension().string();
    const bool plotOrTable = kind == ".svg" || kind == ".png" || kind == ".csv";
    if (plotOrTable || (netcdf && kind == ".nc")) return file;
    throw UsageError(
        {"--out", "has no extension that is written", text,
         fmt::format("a name that ends in .svg, .png{}", netcdf ? ", .csv or .nc" : " or .csv"),
         ""});
}

void addFiles(CLI::App& command, AskedFiles& files, const std::string& fallback,
              bool netcdf = false) {
    command
        .add_option_function<std::vector<std::string>>(
            "--out,-o",
            [&files, netcdf](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    files.out.push_back(parseOutFile(text, netcdf));
                }
            },
            "Plot or table to write; may be repeated")
        ->type_name(netcdf ? "P.svg|P.png|P.csv|P.nc" : "P.svg|P.png|P.csv")
        ->allow_extra_args(false)
        ->default_str(fallback);
    addParsed(command, "--size", files.sizePx, parseSize, "Of the plot, in points",
              "the plot's own")
        ->type_name("WxH");
}

void finishFiles(AskedFiles& files, const char* fallback) {
    if (files.out.empty()) files.out = {fallback};
    for (const std::filesystem::path& file : files.out) checkReplaceable(file);
}

ParcelSource parseSource(const std::string& text) {
    if (text == "surface") return ParcelSource::surface;
    if (text == "mixed-layer") return ParcelSource::mixedLayer;
    if (text == "most-unstable") return ParcelSource::mostUnstable;
    throw UsageError(
        {"--parcel", "is not known", text, "surface, mixed-layer or most-unstable", ""});
}

std::vector<Quantity> parseContours(const std::string& text) {
    std::vector<Quantity> quantities;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        quantities.push_back(quantityOfOption("--contours", text.substr(from, comma - from)));
        from = comma + 1;
    }
    return quantities;
}

/// "a:b", either of which may be left out.
ColourLimits parseLimits(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) {
        throw UsageError({"--limits", "cannot be read", text, "A:B, as in 0:10", ""});
    }
    constexpr double kMost = 1e9;
    ColourLimits limits;
    const std::string from = text.substr(0, colon), to = text.substr(colon + 1);
    if (!from.empty()) limits.from = parseNumber<double>("--limits", from, -kMost, kMost);
    if (!to.empty()) limits.to = parseNumber<double>("--limits", to, -kMost, kMost);
    if (limits.from && limits.to && *limits.from >= *limits.to) {
        throw UsageError({"--limits", "are not in order", text, "the lower one first", ""});
    }
    return limits;
}

SeriesKind parseKind(const std::string& text) {
    std::string known;
    for (int i = 0; i < kSeriesKinds; ++i) {
        const auto kind = static_cast<SeriesKind>(i);
        if (text == idOf(kind)) return kind;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", idOf(kind));
    }
    throw UsageError({"--show", "is not known", text, "one of " + known, ""});
}

}  // namespace

Command addProbe(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "probe", "Tell what is in the column over a place: hydrometeors, air, instability, shear");
    const auto request = std::make_shared<ProbeRequest>();
    addData(command, request->data, "Time");
    addPlace(command, "--at", request->place, "Where")->required();
    command.add_flag("--json", request->json, "As JSON");
    return {&command, [request] {
                checkOneTime(request->data.times);
                return runProbe(*request);
            }};
}

Command addProfile(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "profile", "Plot the column over a place: skew-T log-p, hodograph, hydrometeors");
    const auto request = std::make_shared<ProfileRequest>();
    addData(command, request->data, "Time");
    addPlace(command, "--at", request->place, "Where")->required();
    addParsed(command, "--parcel", request->source, parseSource,
              "Whose way is shown: surface, mixed-layer or most-unstable", "mixed-layer")
        ->type_name("PARCEL");
    addFiles(command, request->files, "profile.svg");
    return {&command, [request] {
                checkOneTime(request->data.times);
                finishFiles(request->files, "profile.svg");
                return runProfile(*request);
            }};
}

Command addSection(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "section", "Plot a vertical section along a line, or a horizontal one at a height");
    const auto request = std::make_shared<SectionRequest>();
    addData(command, request->data, "Time");
    CLI::Option* from = addPlace(command, "--from", request->from, "Start of the line");
    CLI::Option* to = addPlace(command, "--to", request->to, "End of the line");
    constexpr double kLowestM = -500.0, kHighestM = 1e5;
    CLI::Option* height = addNumber(command, "--height", request->heightM, kLowestM, kHighestM,
                                    "Of a horizontal section, above sea level, m");
    from->needs(to)->excludes(height);
    to->needs(from)->excludes(height);
    addParsed(
        command, "--show", request->shown,
        [](const std::string& text) { return quantityOfOption("--show", text); },
        "In colours: " + quantityIds(), "condensate")
        ->type_name("QUANTITY");
    addParsed(command, "--contours", request->contours, parseContours,
              "As contours over it; may be a list")
        ->type_name("QUANTITY,...");
    addParsed(command, "--limits", request->limits, parseLimits, "Of the colours")
        ->type_name("A:B");
    addFiles(command, request->files, "section.svg");
    return {&command, [request] {
                checkOneTime(request->data.times);
                if (!request->from && !request->heightM) {
                    throw UsageError({"section", "of where is not said", "",
                                      "--from PLACE --to PLACE, or --height METRES", ""});
                }
                finishFiles(request->files, "section.svg");
                return runSection(*request);
            }};
}

Command addSeries(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "series", "Plot or print maxima, storm top, base, cover and masses over time");
    const auto request = std::make_shared<SeriesRequest>();
    addData(command, request->data, "Times to read; else all");
    addParsed(command, "--show", request->kind, parseKind,
              "One plot: contents, updraft, heights, masses or cover; else all")
        ->type_name("KIND");
    addFiles(command, request->files, "series.svg", true);
    return {&command, [request] {
                finishFiles(request->files, "series.svg");
                return runSeries(*request);
            }};
}

}  // namespace neph
