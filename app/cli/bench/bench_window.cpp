// bench_window.cpp: an orbit at the size of the window as the workbench draws it, then rest.
//
// The quality control is the workbench's own; panels and the window itself are left out.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "app/cli/bench/bench_sections.h"
#include "app/workbench/quality.h"
#include "core/base/resources.h"

namespace neph::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 kWindowPx{1280, 720};  // of the workbench
constexpr int kWarmUpFrames = 20, kOrbitFrames = 60;
constexpr double kTurnDeg = 2.0;                       // a frame, as a user does
constexpr auto kWait = std::chrono::milliseconds(50);  // between looks at rest, as the workbench
constexpr double kLongestRestS = 60.0;                 // a machine this slow is given up

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A window without panels.
class Window {
  public:
    Window(const Run& run, glm::ivec2 sizePx, Engine engine)
        : run_(run), sizePx_(sizePx), volume_(onGrid(run.volume, run.request.grids.front())) {
        look_ = run.parameters.look;
        look_.engine = engine;
        renderer_.setVolume(volume_);
    }

    /// Draws what the workbench would draw after `restS` seconds without a change, if anything.
    void draw(double turnDeg, double restS) {
        if (restS == 0.0) drawn_.reset();
        const ui::Draft wanted = quality_.draft(restS, sizePx_, traitsOf(look_.engine).leastDetail);
        const auto next = ui::nextDraft(drawn_, wanted, false);
        if (!next) return;
        const render::FrameStats stats = renderer_.render(inputsOf(*next, turnDeg));
        const bool prepared =
            stats.bakedMedium || (stats.marchedLight && !traitsOf(look_.engine).lightFollowsCamera);
        if (!prepared) quality_.measured(*next, stats.milliseconds, sizePx_);
        drawn_ = next;
        steps_ = stats.planes;
    }
    const ui::Draft& drawn() const { return *drawn_; }
    int steps() const { return steps_; }

  private:
    render::FrameInputs inputsOf(const ui::Draft& draft, double turnDeg) const {
        render::FrameInputs inputs = run_.inputs(volume_.grid, draft.sizePx, turnDeg);
        inputs.camera.aspect = static_cast<double>(sizePx_.x) / sizePx_.y;
        inputs.look = look_;
        ui::thin(inputs, draft);
        return inputs;
    }

    const Run& run_;
    glm::ivec2 sizePx_;
    SpeciesVolume volume_;
    Look look_;
    render::Renderer renderer_{resourcePath("shaders")};
    ui::QualityControl quality_;
    std::optional<ui::Draft> drawn_;  // none: the camera has moved
    int steps_ = 0;
};

/// From the last frame in motion to the full image; null where it does not come.
Json restMilliseconds(Window& window, double turnDeg) {
    const auto start = Clock::now();
    while (secondsSince(start) < kLongestRestS) {
        window.draw(turnDeg, std::max(secondsSince(start), 1e-3));
        if (window.drawn().step == ui::kFullStep) return secondsSince(start) * 1000.0;
        std::this_thread::sleep_for(kWait);
    }
    return {};
}

Json measureEngine(const Run& run, glm::ivec2 sizePx, Engine engine) {
    Window window(run, sizePx, engine);
    double turnDeg = 0.0;
    const auto orbit = [&] { window.draw(turnDeg += kTurnDeg, 0.0); };
    for (int frame = 0; frame < kWarmUpFrames; ++frame) orbit();
    std::vector<double> milliseconds, widths, heights, steps;
    const auto start = Clock::now();
    for (int frame = 0; frame < kOrbitFrames; ++frame) {
        const auto begun = Clock::now();
        orbit();
        milliseconds.push_back(secondsSince(begun) * 1000.0);
        widths.push_back(window.drawn().sizePx.x);
        heights.push_back(window.drawn().sizePx.y);
        steps.push_back(window.steps());
    }
    const double fps = kOrbitFrames / secondsSince(start);
    Json json{{"engine", traitsOf(engine).id},
              {"size", toJson(sizePx)},
              {"frames", kOrbitFrames},
              {"fps", fps},
              {"motion_size", {medianOf(widths), medianOf(heights)}},
              {"motion_steps", medianOf(steps)}};
    json.update(timesOf(milliseconds));
    json["rest_to_full_ms"] = restMilliseconds(window, turnDeg);
    return json;
}

void print(const Json& row) {
    fmt::print(stderr, "{:<8} {:>8} {:>8} {:>8} {:>8} {:>12} {:>7} {:>13}\n",
               row["engine"].get<std::string>(), cell(row["fps"]), cell(row["median_ms"]),
               cell(row["min_ms"]), cell(row["max_ms"]),
               cell(row["motion_size"][0], 0) + " x " + cell(row["motion_size"][1], 0),
               cell(row["motion_steps"], 0), cell(row["rest_to_full_ms"], 0));
}

}  // namespace

Json measureWindow(const Run& run) {
    Json rows = Json::array();
    for (const glm::ivec2 sizePx : run.sizesOr(kWindowPx)) {
        fmt::print(stderr, "\nwindow: an orbit at {} with adaptive quality, without panels\n",
                   textOf(sizePx));
        fmt::print(stderr, "{:<8} {:>8} {:>8} {:>8} {:>8} {:>12} {:>7} {:>13}\n", "engine", "fps",
                   "median", "min", "max", "in motion", "steps", "rest to full");
        for (const Engine engine : run.request.engines) {
            rows.push_back(measureEngine(run, sizePx, engine));
            print(rows.back());
        }
    }
    return {{"without_panels", rows}};
}

}  // namespace neph::bench
