// light_work.cpp: one cycle of each source in turn, until all have settled.
#include "core/transport/light_work.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/transport/source_moments.h"

namespace neph {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostThreads = 16;
// Cycles that are averaged; the light of the sky is a twentieth of that of the sun.
constexpr std::array<int, kLightParts> kAveragedCycles{8, 4, 4};
constexpr double kWorthACoarseStart = 5000;  // nodes
constexpr int kCoarseCycles = 3;
/// At which the light around clouds is collected; and for a first look.
constexpr std::size_t kNodesAround = 60000, kFirstNodesAround = 12000;
// While cycles are averaged, every so many of them are worth showing.
constexpr int kShownOf = 4;

LightSettings settingsOf(LightPart part) {
    LightSettings settings;
    settings.aligned = true;  // one scaling for all, by which the eye sees
    settings.threads = static_cast<int>(workerCount(kMostThreads));
    settings.seed += static_cast<std::uint64_t>(part);
    return settings;
}

/// `layers` of nodes, `layerM` apart.
LightScene sceneOf(const LightRequest& request, LightPart part, int layers, double layerM) {
    LightScene scene;
    scene.towardsSun = request.towardsSun;
    scene.groundAlbedo = request.groundHidden ? 0.0 : request.groundAlbedo;
    // Air below a cloud lights it as ground does.
    if (request.dome) {
        const SkyDome& dome = *request.dome;
        scene.groundAlbedo = dome.airClear * scene.groundAlbedo + dome.airAlbedo;
    }
    scene.periodicSides = request.periodicSides;
    if (part == LightPart::sun) {
        for (int k = 0; request.dome && k < layers; ++k) {
            const double altitudeM = request.lowestM + k * layerM;
            scene.sunByLayer.push_back(static_cast<float>(request.dome->sunAt(altitudeM)));
        }
        return scene;
    }
    scene.source = LightSource::sky;
    scene.sky.horizon = part == LightPart::horizon ? 1.0 : 0.0;
    scene.sky.zenith = part == LightPart::zenith ? 1.0 : 0.0;
    scene.sky.dome = request.dome;
    scene.sky.pattern = part == LightPart::horizon ? 0 : 1;
    if (!request.groundHidden) return scene;
    scene.groundRadiance =
        request.dome ? request.dome->patterns[scene.sky.pattern].atHorizon() : scene.sky.horizon;
    return scene;
}

}  // namespace

/// The fields of one medium.
struct LightWork::Solution {
    /// Starts from `start`, if there is one. `medium` is that of the request, or a coarser one.
    Solution(const LightRequest& first, const LightMedium& medium, const Solution* start)
        : request(first) {
        makeSolvers(medium);
        for (std::size_t i = 0; i < kLightParts; ++i) {
            if (start != nullptr) solvers[i]->startFrom(*start->solvers[i]);
            const LightSettings& settings = solvers[i]->settings();
            toSettle[i] =
                kAveragedCycles[i] + (start != nullptr ? settings.warmCycles : settings.coldCycles);
        }
        sunFirst = start != nullptr;
        if (start != nullptr) around = start->around;
        albedo = filledAlbedo(solvers[0]->level());
        const auto& place = solvers[0]->level().place;
        for (std::size_t node = 0; node < place.size(); ++node) {
            if (place[node] >= 0) nodes.push_back(static_cast<std::uint32_t>(node));
        }
    }
    void makeSolvers(const LightMedium& medium) {
        const auto make = [&](LightPart part, const auto& from) {
            solvers[static_cast<std::size_t>(part)] = std::make_unique<LightSolver>(
                from, sceneOf(request, part, medium.nodes.z, medium.spacingM.z), settingsOf(part));
        };
        const auto makeSome = [&](std::size_t piece, std::size_t, const Progress&) {
            if (piece == 0) {
                make(LightPart::sun, medium);
            } else {
                make(LightPart::horizon, medium);
                make(LightPart::zenith, *solvers[static_cast<std::size_t>(LightPart::horizon)]);
            }
        };
        shareOut(2, workerCount(2), makeSome);
    }
    void change(const LightRequest& to) {
        for (std::size_t i = 0; i < kLightParts; ++i) {
            const auto part = static_cast<LightPart>(i);
            const TransportGrid& grid = solvers[i]->level().grid;
            LightScene scene = sceneOf(to, part, grid.nodes.z, grid.spacingM.z);
            if (part != LightPart::sun) {
                const LightScene& before = solvers[i]->scene();
                scene.towardsSun = before.towardsSun;
                if (scene.sky == before.sky && scene.groundAlbedo == before.groundAlbedo &&
                    scene.groundRadiance == before.groundRadiance) {
                    continue;
                }
            }
            solvers[i]->restart(scene);
            toSettle[i] = settingsOf(part).warmCycles + kAveragedCycles[i];
        }
        request = to;
        sunFirst = true;
    }
    bool settled() const {
        bool all = true;
        for (std::size_t i = 0; i < kLightParts; ++i) all &= isSettled(i);
        return all;
    }
    bool isSettled(std::size_t part) const {
        return solvers[part]->cyclesDone() >= (nodes.empty() ? 1 : toSettle[part]);
    }
    /// Returns whether the outcome is worth showing.
    bool cycle() {
        for (std::size_t i = 0; i < kLightParts; ++i) {
            if (!isSettled(i)) solvers[i]->cycle();
            // The light of the sky that is there does for a first look.
            if (std::exchange(sunFirst, false)) return true;
        }
        const int averaged = solvers[0]->cyclesDone() - (toSettle[0] - kAveragedCycles[0]);
        return averaged <= 0 || averaged % kShownOf == 0 || settled();
    }
    std::shared_ptr<const LightState> state(bool whole) {
        if (!around || (whole && settled())) lookAround(whole ? kNodesAround : kFirstNodesAround);
        auto made = std::make_shared<LightState>();
        made->request = request;
        made->size = solvers[0]->level().grid.nodes;
        made->spacingM = solvers[0]->level().grid.spacingM;
        made->cycles = solvers[0]->cyclesDone();
        made->settled = whole && settled();
        made->remaining = solvers[0]->remaining();
        made->chance = solvers[0]->chance();
        made->underResolved = solvers[0]->underResolved();
        made->nodes = nodes;
        made->around = around;
        made->balanced = balancedAlbedo(solvers[0]->level(), albedo);
        const int degrees = solvers[0]->level().degreeCount;
        for (std::size_t i = 0; i < kLightParts; ++i) {
            made->source[i] = sourceMoments(*solvers[i], albedo, degrees);
            made->groundFlux[i] = solvers[i]->groundFlux();
            made->bytes += solvers[i]->bytes();
        }
        return made;
    }

    void lookAround(std::size_t mostNodes) {
        auto made = std::make_shared<std::array<LightAround, kLightParts>>();
        shareOut(kLightParts, workerCount(kLightParts),
                 [&](std::size_t i, std::size_t, const Progress&) {
                     (*made)[i] = lightAround(*solvers[i], mostNodes);
                 });
        around = std::move(made);
    }

    LightRequest request;
    std::array<std::unique_ptr<LightSolver>, kLightParts> solvers;
    std::array<int, kLightParts> toSettle{};
    bool sunFirst = false;  ///< the next cycle is of the sun alone
    std::vector<float> albedo;
    std::vector<std::uint32_t> nodes;
    std::shared_ptr<const std::array<LightAround, kLightParts>> around;
};

LightWork::LightWork(std::function<void()> wake)
    : wake_(std::move(wake)), worker_([this](const std::stop_token& stop) { run(stop); }) {}

LightWork::~LightWork() {
    worker_.request_stop();
    changed_.notify_all();
}

void LightWork::ask(const LightRequest& request) {
    {
        const std::lock_guard lock(mutex_);
        if (asked_ == request) return;
        asked_ = request;
        taken_ = false;
        outOfMemory_ = false;
    }
    changed_.notify_all();
}

std::shared_ptr<const LightState> LightWork::latest() const {
    const std::lock_guard lock(mutex_);
    checkMemory();
    return latest_;
}

/// With the mutex held.
void LightWork::checkMemory() const {
    if (!outOfMemory_) return;
    const glm::ivec3 nodes = asked_->medium->nodes;
    throw Error({.what = "there is not enough memory to solve the light of this image",
                 .found = fmt::format("{} x {} x {} voxels of light", nodes.x, nodes.y, nodes.z),
                 .hint = "lower view.light_voxels, or use light.transport=translucent"});
}

std::shared_ptr<const LightState> LightWork::wait(bool settled, const Progress& progress) const {
    std::unique_lock lock(mutex_);
    while (true) {
        checkMemory();
        const bool answers = latest_ && latest_->request == asked_;
        if (answers && (latest_->settled || !settled)) return latest_;
        const double done = answers ? latest_->cycles : 0;
        changed_.wait_for(lock, 5ms);
        lock.unlock();
        if (!goOn(progress, done / (LightSettings{}.coldCycles + kAveragedCycles[0]))) {
            throw Cancelled{};
        }
        lock.lock();
    }
}

/// What was asked since the last call; waits for it where there is nothing else to do.
std::optional<LightRequest> LightWork::take(bool idle, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    if (idle) changed_.wait(lock, stop, [&] { return !taken_; });
    if (taken_) return {};
    taken_ = true;
    return asked_;
}

void LightWork::publish(std::shared_ptr<const LightState> state) {
    {
        const std::lock_guard lock(mutex_);
        latest_ = std::move(state);
    }
    changed_.notify_all();
    if (wake_) wake_();
}

/// A first light on half the resolution, which is worth showing long before that of the whole; null
/// where there are few nodes anyway, or something else was asked for meanwhile.
std::unique_ptr<LightWork::Solution> LightWork::coarseStart(const LightRequest& request) {
    const glm::ivec3 nodes = request.medium->nodes;
    if (static_cast<double>(nodes.x) * nodes.y * nodes.z < kWorthACoarseStart) return {};
    auto coarse = std::make_unique<Solution>(
        request, halved(*request.medium, request.periodicSides), nullptr);
    for (int cycle = 0; cycle < kCoarseCycles; ++cycle) {
        if (!isNewest(request)) return {};
        coarse->cycle();
        if (cycle > 0) publish(coarse->state(false));
    }
    return coarse;
}

/// The same nodes may start from the light that is there.
std::unique_ptr<LightWork::Solution> LightWork::solutionFor(const LightRequest& request,
                                                            std::unique_ptr<Solution> before) {
    const bool same = before && before->request.periodicSides == request.periodicSides &&
                      before->request.medium->nodes == request.medium->nodes &&
                      before->request.medium->spacingM == request.medium->spacingM;
    if (!request.warm || !same) before = coarseStart(request);
    if (!isNewest(request)) return before;
    return std::make_unique<Solution>(request, *request.medium, before.get());
}

bool LightWork::isNewest(const LightRequest& request) const {
    const std::lock_guard lock(mutex_);
    return asked_ == request;
}

void LightWork::run(const std::stop_token& stop) {
    std::unique_ptr<Solution> solution;
    while (!stop.stop_requested()) {
        const auto asked = take(!solution || solution->settled(), stop);
        if (stop.stop_requested()) return;
        try {
            step(solution, asked);
        } catch (const std::bad_alloc&) {
            solution.reset();
            const std::lock_guard lock(mutex_);
            outOfMemory_ = taken_;
        }
    }
}

/// Takes over what was asked for, if anything, and gets a cycle further.
void LightWork::step(std::unique_ptr<Solution>& solution,
                     const std::optional<LightRequest>& asked) {
    const bool same = asked && solution && solution->request.medium == asked->medium &&
                      solution->request.periodicSides == asked->periodicSides;
    if (same && asked->warm) {
        solution->change(*asked);
    } else if (asked) {
        solution = solutionFor(*asked, std::move(solution));
    }
    if (!solution || !isNewest(solution->request)) return;
    if (solution->cycle()) publish(solution->state(true));
}

}  // namespace neph
