// bench_changes.cpp: from a change to a first image, drawn as in motion, and to the full one, with
// settled light.
//
// Before each change the full image is there and nothing is left to be done. A time is one that
// has been read already. Kinds of change take turns.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "app/cli/bench/bench_sections.h"
#include "core/base/resources.h"

namespace neph::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 kSizePx{1280, 720};
// A draft of the workbench on two cores without a GPU: 320 x 180 of 1280 x 720, 96 steps.
constexpr int kDraftDivisor = 4, kDraftSteps = 96;
constexpr float kScaleStep = 0.8f, kSunStepDeg = 10.0f;

enum class Change { mixingScale, sun, time };
struct Kind {
    Change change;
    std::string_view id;
    std::vector<double> firstMs{}, fullMs{};
};

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What is on the screen, and what changes can be made to it.
class Screen {
  public:
    explicit Screen(const Run& run)
        : volumes_{onGrid(run.volume, run.request.grids.front())},
          full_(run.inputs(volumes_.front().grid, run.sizesOr(kSizePx).front(), 0.0)) {
        if (run.otherTime) volumes_.push_back(onGrid(*run.otherTime, run.request.grids.front()));
        full_.look.engine = run.request.engines.front();
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
        draft.settledLight = false;
        return draft;
    }

    void settle() { renderer_.render(full_); }

    void take(Kind& kind, bool counts) {
        settle();
        const auto start = Clock::now();
        make(kind.change);
        renderer_.render(draft());
        const double firstMs = millisecondsSince(start);
        renderer_.render(full_);
        if (!counts) return;
        kind.firstMs.push_back(firstMs);
        kind.fullMs.push_back(millisecondsSince(start));
    }

  private:
    void make(Change change) {
        Look& look = full_.look;
        float& scale = look.of(Species::cloud).mixingScale;
        switch (change) {
            case Change::mixingScale:
                scale = scale == 1.0f ? kScaleStep : 1.0f;
                break;
            case Change::sun:
                look.sunAzimuthDeg += kSunStepDeg;
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
};

}  // namespace

Json measureChanges(const Run& run) {
    Screen screen(run);
    std::vector<Kind> kinds{{Change::mixingScale, "mixing-scale"}, {Change::sun, "sun-azimuth"}};
    if (screen.hasTimes()) kinds.push_back({Change::time, "time"});
    for (int round = -1; round < run.request.frames; ++round) {
        for (Kind& kind : kinds) screen.take(kind, round >= 0);
    }
    const render::FrameInputs draft = screen.draft();
    fmt::print(stderr, "\nchanges: first image {} of {} steps, full {}, {} cells, {}\n",
               textOf(draft.sizePx), draft.planes, textOf(screen.full().sizePx),
               textOf(screen.grid().size), traitsOf(screen.full().look.engine).id);
    fmt::print(stderr, "{:<14} {:>10} {:>8} {:>8} {:>10} {:>8} {:>8}\n", "change", "first ms",
               "min", "max", "full ms", "min", "max");
    Json rows = Json::array();
    for (const Kind& kind : kinds) {
        const Json first = timesOf(kind.firstMs), full = timesOf(kind.fullMs);
        fmt::print(stderr, "{:<14} {:>10} {:>8} {:>8} {:>10} {:>8} {:>8}\n", kind.id,
                   cell(first["median_ms"]), cell(first["min_ms"]), cell(first["max_ms"]),
                   cell(full["median_ms"]), cell(full["min_ms"]), cell(full["max_ms"]));
        rows.push_back({{"change", kind.id}, {"first", first}, {"full", full}});
    }
    return {{"engine", traitsOf(screen.full().look.engine).id},
            {"grid", toJson(screen.grid().size)},
            {"first_size", toJson(draft.sizePx)},
            {"first_steps", draft.planes},
            {"full_size", toJson(screen.full().sizePx)},
            {"frames", run.request.frames},
            {"rows", rows}};
}

}  // namespace neph::bench
