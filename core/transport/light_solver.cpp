// light_solver.cpp: cycles, and the average over them.
#include "core/transport/light_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/transport/balance.h"
#include "core/transport/beam.h"
#include "core/transport/grid_loops.h"

namespace neph {
namespace {

/// The nodes around a point, which is given in nodes, and their shares of what is between them.
struct Between {
    std::array<std::size_t, 8> node{};
    std::array<float, 8> weight{};

    Between(const TransportGrid& grid, const glm::dvec3& at) {
        glm::ivec3 last = grid.nodes - 2;  // that can be the lower of two
        for (int axis = 0; axis < 2; ++axis) last[axis] += grid.periodic(axis) ? 1 : 0;
        const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(at)), glm::ivec3(0), last);
        const glm::vec3 share(glm::clamp(at - glm::dvec3(low), 0.0, 1.0));
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 upper{corner & 1, (corner >> 1) & 1, corner >> 2};
            const glm::vec3 of = glm::mix(1.0f - share, share, glm::vec3(upper));
            const auto i = static_cast<std::size_t>(corner);
            const glm::ivec3 to = (low + upper) % grid.nodes;
            node[i] = grid.index(to.x, to.y, to.z);
            weight[i] = of.x * of.y * of.z;
        }
    }
    /// Where all is on the ground.
    float groundOf(const std::vector<float>& flux) const {
        float sum = 0.0f;
        for (std::size_t corner = 0; corner < 4; ++corner)
            sum += weight[corner] * flux[node[corner]];
        return sum;
    }
};

int momentsFor(const LightScene& scene, const LightSettings& settings) {
    const bool rings = settings.aligned && scene.source == LightSource::sun;
    return rings ? kAlignedMoments : kBroadMoments;
}

/// The grids of the multigrid, the finest first.
std::shared_ptr<const std::vector<TransportLevel>> levelsOf(const LightMedium& medium,
                                                            const LightScene& scene,
                                                            const LightSettings& settings) {
    assert(glm::all(glm::greaterThanEqual(medium.nodes, glm::ivec3(2))));
    assert(glm::all(glm::greaterThan(medium.spacingM, glm::dvec3(0.0))));
    auto levels = std::make_shared<std::vector<TransportLevel>>();
    levels->push_back(
        finestLevel(medium, scene.periodicSides, settings.aligned, momentsFor(scene, settings)));
    while (static_cast<int>(levels->size()) < settings.levels && canCoarsen(levels->back().grid)) {
        levels->push_back(coarsened(levels->back()));
    }
    return levels;
}

void moveTowards(const std::vector<float>& target, float share, std::vector<float>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += share * (target[i] - values[i]);
}

}  // namespace

LightSolver::LightSolver(std::shared_ptr<const std::vector<TransportLevel>> levels,
                         const LightScene& scene, const LightSettings& settings)
    : scene_(scene),
      settings_(settings),
      levels_(std::move(levels)),
      field_(level().emptyField()),
      directions_(settings.seed) {
    restart(scene);
    replacing_ = settings.coldCycles;
}

LightSolver::LightSolver(const LightMedium& medium, const LightScene& scene,
                         const LightSettings& settings)
    : LightSolver(levelsOf(medium, scene, settings), scene, settings) {}

LightSolver::LightSolver(const LightSolver& other, const LightScene& scene,
                         const LightSettings& settings)
    : LightSolver(other.levels_, scene, settings) {
    assert(momentCount() == momentsFor(scene, settings));
}

void LightSolver::restart(const LightScene& scene) {
    assert(scene.source == scene_.source && scene.periodicSides == scene_.periodicSides);
    const bool moved = !hasBeam() || scene.towardsSun != scene_.towardsSun ||
                       scene.sunByLayer != scene_.sunByLayer;
    scene_ = scene;
    if (scene.source == LightSource::sun && moved) beam_ = beamOn(level());
    cycles_ = 0;
    replacing_ = settings_.warmCycles;
    remaining_ = 1.0;
    halfCycles_ = {};
    for (auto& half : halves_) half.assign(level().activeCount, 0.0f);
}

LevelBeam LightSolver::beamOn(const TransportLevel& level) const {
    LevelBeam beam;
    if (scene_.source != LightSource::sun) return beam;
    const std::size_t columns = level.grid.columnCount();
    beam.atNodes = beamIrradiance(level, scene_.towardsSun, settings_.threads);
    beam.onGround = beam.atNodes;
    beam.onGround.resize(std::min(beam.atNodes.size(), columns));
    if (level.thick()) {
        beam.underResolved =
            blendDeposit(level, scene_.towardsSun, settings_.threads, beam.atNodes);
    }
    // What the air takes of it on its way to each layer.
    const std::vector<float>& sun = scene_.sunByLayer;
    if (sun.empty()) return beam;
    const double perLayer = level.grid.spacingM.z / levels_->front().grid.spacingM.z;
    for (std::size_t i = 0; i < beam.atNodes.size(); ++i) {
        const auto layer = std::lround(perLayer * static_cast<double>(i / columns));
        beam.atNodes[i] *= sun[std::min(static_cast<std::size_t>(layer), sun.size() - 1)];
    }
    for (float& light : beam.onGround) light *= sun.front();
    return beam;
}

void LightSolver::startFrom(const LightSolver& other) {
    assert(other.scene_.source == scene_.source && other.momentCount() == momentCount());
    const TransportLevel& to = level();
    const glm::dvec3 perNode = to.grid.spacingM / other.level().grid.spacingM;
    const auto moments = static_cast<std::size_t>(momentCount());
    forEachNode(to.grid, [&](const glm::ivec3& node, std::size_t index) {
        const Between between(other.level().grid, glm::dvec3(node) * perNode);
        if (node.z == 0) field_.groundFlux[index] = between.groundOf(other.groundFlux());
        if (to.place[index] < 0) return;
        float* sum = &field_.moments[static_cast<std::size_t>(to.place[index]) * moments];
        std::fill_n(sum, moments, 0.0f);
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::span<const float> from = other.momentsAt(between.node[corner]);
            for (std::size_t q = 0; q < from.size(); ++q) {
                sum[q] += between.weight[corner] * from[q];
            }
        }
    });
    replacing_ = settings_.warmCycles;
}

Swept LightSolver::sweepFine(const LightField& field, const LightDirections& directions) const {
    return swept(sweepInput(level(), field, beam_), directions, settings_.threads);
}

SweepInput LightSolver::sweepInput(const TransportLevel& level, const LightField& field,
                                   const LevelBeam& beam) const {
    SweepInput input;
    input.level = &level;
    input.field = &field;
    input.sunTravel = -scene_.towardsSun;
    const double sine = std::max(scene_.towardsSun.z, 0.0);  // of light on the ground
    if (hasBeam()) input.beam = beam.atNodes.data();
    if (scene_.source == LightSource::sky) input.sky = scene_.sky;
    const double sun = scene_.sunByLayer.empty() ? 1.0 : static_cast<double>(scene_.sunByLayer[0]);
    const double farFlux = hasBeam() ? sine * sun : input.sky.irradiance();
    const double perFlux = scene_.groundAlbedo / std::numbers::pi;
    const auto upwards = [&](double flux) {
        return static_cast<float>(scene_.groundRadiance + perFlux * flux);
    };
    input.farGroundRadiance = upwards(farFlux);
    for (std::size_t i = 0; i < field.groundFlux.size(); ++i) {
        const double direct = hasBeam() ? sine * static_cast<double>(beam.onGround[i]) : 0.0;
        input.groundRadiance.push_back(upwards(direct + static_cast<double>(field.groundFlux[i])));
    }
    return input;
}

void LightSolver::cycle() {
    const bool rings = momentCount() == kAlignedMoments;
    const LightDirections directions =
        rings ? directions_.rings(-scene_.towardsSun) : directions_.turnedIcosahedron();
    const MultigridPass pass{&directions, -scene_.towardsSun, scene_.groundAlbedo,
                             settings_.sweepsPerLevel, settings_.threads};
    if (level().thick()) {
        average(thickCycle(directions, pass));
        return;
    }
    LightField next = sweepFine(field_, directions).field;
    remaining_ = correctByMultigrid(*levels_, pass, field_, next);
    average(next);
}

/// Nodes follow their balance, and a second sweep finds what is left for coarser grids.
LightField LightSolver::thickCycle(const LightDirections& directions, const MultigridPass& pass) {
    // Mean radiance over irradiance / pi, or over radiance: more is a node that overshoots.
    constexpr double kBrightest = 1.7;
    const TransportLevel& fine = level();
    const float* beam = hasBeam() ? beam_.atNodes.data() : nullptr;
    LightField next = field_;
    {
        const Swept sums = sweepFine(field_, directions);
        relax(missingFrom(fine, sums, field_, beam), resistanceOf(fine, sums), next);
    }
    if (levels_->size() > 1) {
        const LightField missing = missingFrom(fine, sweepFine(next, directions), next, beam);
        remaining_ = correctThick(*levels_, pass, missing, next);
    }
    const bool sky = scene_.source == LightSource::sky;
    limitBalanced(fine, kBrightest * (sky ? 1.0 : 1.0 / std::numbers::pi), next);
    return next;
}

/// The cycles that replace the field are not part of the average, but for the last of them.
void LightSolver::average(const LightField& next) {
    const int averaged = cycles_++ - replacing_;
    const float share = averaged < 0 ? 1.0f : 1.0f / static_cast<float>(averaged + 2);
    moveTowards(next.moments, share, field_.moments);
    moveTowards(next.groundFlux, share, field_.groundFlux);
    if (averaged < 0) return;
    const auto half = static_cast<std::size_t>(averaged % 2);
    const float halfShare = 1.0f / static_cast<float>(++halfCycles_[half]);
    const auto moments = static_cast<std::size_t>(momentCount());
    for (std::size_t i = 0; i < halves_[half].size(); ++i) {
        halves_[half][i] += halfShare * (next.moments[i * moments] - halves_[half][i]);
    }
}

double LightSolver::chance() const {
    if (halfCycles_[1] == 0) return -1.0;
    const TransportLevel& fine = level();
    double spread = 0.0, whole = 0.0;
    for (std::size_t node = 0; node < fine.place.size(); ++node) {
        if (fine.place[node] < 0) continue;
        const auto i = static_cast<std::size_t>(fine.place[node]);
        const auto weight = static_cast<double>(fine.weightAt(node));
        const double half = 0.5 * static_cast<double>(halves_[0][i] - halves_[1][i]);
        const double mean = 0.5 * static_cast<double>(halves_[0][i] + halves_[1][i]);
        spread += weight * half * half;
        whole += weight * mean * mean;
    }
    return whole > 0.0 ? std::sqrt(spread / whole) : 0.0;
}

std::span<const float> LightSolver::momentsAt(std::size_t node) const {
    const std::int32_t place = level().place[node];
    if (place < 0) return {};
    const auto moments = static_cast<std::size_t>(momentCount());
    return {&field_.moments[static_cast<std::size_t>(place) * moments], moments};
}

std::vector<float> LightSolver::momentsOfAllNodes() const {
    std::vector<float> all;
    all.reserve(level().place.size() * static_cast<std::size_t>(momentCount()));
    for (std::size_t node = 0; node < level().place.size(); ++node) {
        const std::span<const float> moments = momentsAt(node);
        all.insert(all.end(), moments.begin(), moments.end());
        if (moments.empty()) all.resize(all.size() + static_cast<std::size_t>(momentCount()));
    }
    return all;
}

std::size_t LightSolver::bytes() const {
    std::size_t shared = 0,
                own = beam_.atNodes.size() + beam_.onGround.size() + 2 * halves_[0].size();
    for (const TransportLevel& level : *levels_) {
        shared += level.bytes();
        own += level.activeCount * static_cast<std::size_t>(level.momentCount);
    }
    return sizeof(float) * own + shared / static_cast<std::size_t>(levels_.use_count()) +
           sweptBytes(level());
}

}  // namespace neph
