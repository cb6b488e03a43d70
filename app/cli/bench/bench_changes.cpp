// bench_changes.cpp: from a change to a first image, drawn as in motion, to one in the first light
// that answers the change, and to the full one, with settled light.
//
// Before each change the full image is there and nothing is left to be done. A time is one that
// has been read already. Kinds of change take turns.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

#include "app/cli/bench/bench_sections.h"
#include "core/base/resources.h"
#include "core/image/image_error.h"

namespace neph::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 kSizePx{1280, 720};
// A draft of the workbench on two cores without a GPU: 320 x 180 of 1280 x 720, 96 steps.
constexpr int kDraftDivisor = 4, kDraftSteps = 96;
constexpr std::chrono::milliseconds kLookAgain(1);
constexpr float kScaleStep = 0.8f, kSunStepDeg = 10.0f, kSunRisesDeg = 4.0f;

enum class Change { mixingScale, sunAzimuth, sunElevation, time };
struct Kind {
    Change change;
    std::string_view id;
    std::vector<double> firstMs{}, fullMs{};
    std::vector<double> withoutLightMs{};  // the first, less carrying sunlight through the cloud
    // Of full transport: the image drawn as in motion in new light, and how far it was from settled
    // light, relRMSE in percent.
    std::vector<double> lightMs{}, lightErrorPercent{}, settledMs{};
};

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of carrying sunlight through the cloud.
double lightMs(const render::FrameStats& stats) {
    double sum = 0.0;
    for (const render::PassTime& pass : stats.passes) {
        if (pass.name == "light" || pass.name == "light to medium") sum += pass.milliseconds;
    }
    return sum;
}

/// What is on the screen, and what changes can be made to it.
class Screen {
  public:
    explicit Screen(const Run& run)
        : volumes_{onGrid(run.volume, run.request.grids.front())},
          full_(run.inputs(volumes_.front().grid, run.sizesOr(kSizePx).front(), 0.0)) {
        if (run.otherTime) volumes_.push_back(onGrid(*run.otherTime, run.request.grids.front()));
        full_.look.engine = run.request.engines.front();
        full_.settledLight = false;  // as in the window, where it comes by itself
        renderer_.setVolume(volumes_.front());
    }

    bool hasTimes() const { return volumes_.size() > 1; }
    const render::FrameInputs& full() const { return full_; }
    const RegularGrid& grid() const { return volumes_.front().grid; }

    render::FrameInputs draft() const {
        render::FrameInputs draft = full_;
        draft.sizePx = glm::max(full_.sizePx / kDraftDivisor, glm::ivec2(1));
        draft.planes = kDraftSteps;
        draft.draftLight = true;
        return draft;
    }

    void settle() {
        render::FrameStats stats = renderer_.render(full_);
        while (stats.light && !stats.light->settled) stats = drawNewLight();
    }

    void take(Kind& kind, bool counts) {
        settle();
        Kind measured{kind.change, kind.id};
        const auto start = Clock::now();
        make(kind.change);
        render::FrameInputs inputs = draft();
        inputs.profile = true;
        const render::FrameStats first = renderer_.render(inputs);
        measured.firstMs.push_back(millisecondsSince(start));
        measured.withoutLightMs.push_back(measured.firstMs.back() - lightMs(first));
        if (first.light) followLight(measured, start, first.light->settled);
        renderer_.render(full_);
        measured.fullMs.push_back(millisecondsSince(start));
        if (!counts) return;
        for (const auto times : {&Kind::firstMs, &Kind::withoutLightMs, &Kind::fullMs,
                                 &Kind::lightMs, &Kind::lightErrorPercent, &Kind::settledMs}) {
            (kind.*times)
                .insert((kind.*times).end(), (measured.*times).begin(), (measured.*times).end());
        }
    }

  private:
    render::FrameStats drawNewLight() {
        while (!renderer_.hasNewerLight()) std::this_thread::sleep_for(kLookAgain);
        return renderer_.render(draft());
    }

    /// Draws as in motion, whenever there is newer light, until it has settled.
    /// `settled`: it has by now, which little light does before the first image is drawn.
    void followLight(Kind& kind, Clock::time_point start, bool settled) {
        ImageF firstLight;
        if (settled) {
            kind.lightMs.push_back(millisecondsSince(start));
            firstLight = renderer_.readLinear();
        }
        while (!settled) {
            settled = drawNewLight().light->settled;
            if (kind.lightMs.empty()) {
                kind.lightMs.push_back(millisecondsSince(start));
                firstLight = renderer_.readLinear();
            }
        }
        kind.settledMs.push_back(millisecondsSince(start));
        const ImageF image = renderer_.readLinear();
        kind.lightErrorPercent.push_back(100.0 * imageErrors({firstLight}, {image}).relRmse);
    }

    void make(Change change) {
        Look& look = full_.look;
        float& scale = look.of(Species::cloud).mixingScale;
        switch (change) {
            case Change::mixingScale:
                scale *= std::exchange(scaleStep_, 1.0f / scaleStep_);
                break;
            case Change::sunAzimuth:
                look.sunAzimuthDeg += kSunStepDeg;
                break;
            case Change::sunElevation:
                look.sunElevationDeg += std::exchange(riseDeg_, -riseDeg_);
                break;
            case Change::time:
                shown_ = 1 - shown_;
                renderer_.setVolume(volumes_[shown_]);
                break;
        }
    }

    render::Renderer renderer_{resourcePath("shaders")};
    std::vector<SpeciesVolume> volumes_;
    render::FrameInputs full_;
    std::size_t shown_ = 0;
    float scaleStep_ = kScaleStep, riseDeg_ = kSunRisesDeg;
};

/// A row of the result, and a line for the user.
Json rowOf(const Kind& kind) {
    Json row{{"change", kind.id},
             {"first", timesOf(kind.firstMs)},
             {"first_without_light", timesOf(kind.withoutLightMs)},
             {"full", timesOf(kind.fullMs)}};
    Json error;
    if (!kind.lightMs.empty()) {
        error = medianOf(kind.lightErrorPercent);
        row["in_new_light"] = timesOf(kind.lightMs);
        row["in_new_light_percent_from_settled"] = error;
        row["settled"] = timesOf(kind.settledMs);
    }
    const auto median = [&row](const char* key) {
        return cell(row.contains(key) ? row[key]["median_ms"] : Json());
    };
    fmt::print(stderr, "{:<14} {:>10} {:>13} {:>13} {:>8} {:>12} {:>10}\n", kind.id,
               median("first"), median("first_without_light"), median("in_new_light"), cell(error),
               median("settled"), median("full"));
    return row;
}

}  // namespace

Json measureChanges(const Run& run) {
    Screen screen(run);
    std::vector<Kind> kinds{{Change::mixingScale, "mixing-scale"},
                            {Change::sunAzimuth, "sun-azimuth"},
                            {Change::sunElevation, "sun-elevation"}};
    if (screen.hasTimes()) kinds.push_back({Change::time, "time"});
    for (int round = -1; round < run.request.frames; ++round) {
        for (Kind& kind : kinds) screen.take(kind, round >= 0);
    }
    const render::FrameInputs draft = screen.draft();
    fmt::print(stderr, "\nchanges: first image {} of {} steps, full {}, {} cells, {}\n",
               textOf(draft.sizePx), draft.planes, textOf(screen.full().sizePx),
               textOf(screen.grid().size), traitsOf(screen.full().look.engine).id);
    fmt::print(stderr, "{:<14} {:>10} {:>13} {:>13} {:>8} {:>12} {:>10}  (medians, ms)\n", "change",
               "first", "less light", "in new light", "+- %", "settled", "full");
    Json rows = Json::array();
    for (const Kind& kind : kinds) rows.push_back(rowOf(kind));
    return {{"engine", traitsOf(screen.full().look.engine).id},
            {"grid", toJson(screen.grid().size)},
            {"first_size", toJson(draft.sizePx)},
            {"first_steps", draft.planes},
            {"full_size", toJson(screen.full().sizePx)},
            {"frames", run.request.frames},
            {"rows", rows}};
}

}  // namespace neph::bench
