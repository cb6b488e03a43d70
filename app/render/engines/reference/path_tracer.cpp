// path_tracer.cpp: dispatches of a bounded length, and the sums of what has become whole.
#include "app/render/engines/reference/path_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "app/gl/context.h"

namespace neph::render {
namespace {

// Enough to fill the machine: a processor takes eight at a time and thread, a GPU some hundred
// thousand in all.
constexpr int kLanesInSoftware = 1024, kLanesOnGpu = 131072;
constexpr std::size_t kLaneBytes = kLaneWords * sizeof(glm::uvec4);
// A dispatch is to take so long, that the window stays fluid and no watchdog wakes.
const glm::ivec3 kMostSunDepth{64, 64, 64};  // texels of the depth towards the sun
constexpr double kDispatchMs = 8.0;
constexpr int kFewestRounds = 4, kMostRounds = 4096;
// Scatterings from which chance takes paths out: what comes later is little of the light and most
// of the work.
constexpr float kRouletteFrom = 128.0f;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void fill(gl::Buffer& buffer, std::size_t bytes) {
    const std::vector<std::uint8_t> zeros(bytes);
    buffer.write(zeros.data(), bytes);
}

std::vector<glm::vec4> read(const gl::Texture& texture) {
    const glm::ivec3 size = texture.size();
    std::vector<glm::vec4> values(static_cast<std::size_t>(size.x) *
                                  static_cast<std::size_t>(size.y));
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(glm::vec4)), values.data());
    return values;
}

gl::Texture sunDepthOf(const MediumTextures& medium, bool periodic, const gl::Buffer& block,
                       gl::ProgramCache& programs) {
    const glm::ivec3 size = glm::min(4 * medium.first.size(), kMostSunDepth);
    gl::Texture depth = gl::Texture::make3D(GL_R16F, size);
    depth.setLinear();
    std::vector<std::string> defines = mediumDefines(medium);
    std::replace(defines.begin(), defines.end(), std::string("NOISE 1"), std::string("NOISE 0"));
    defines.push_back(fmt::format("PERIODIC {}", periodic ? 1 : 0));
    const gl::Program& program = programs.get("reference/sun_depth.comp", defines);
    block.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    medium.first.bind(kMedium0Unit);
    if (medium.second) medium.second.bind(kMedium1Unit);
    depth.bindImage(kSunDepthImage, GL_WRITE_ONLY);
    program.dispatch(size);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return depth;
}

void setAir(const AirBands& air, const gl::Program& program) {
    program.setVec3(kTraceMoleculesLocation, glm::vec3(air.moleculesPerM));
    program.setVec3(kTraceHazeLocation, glm::vec3(air.hazePerM));
    program.setFloat(kTraceMoleculesHeightLocation, static_cast<float>(air.moleculesHeightM));
    program.setFloat(kTraceHazeHeightLocation, static_cast<float>(air.hazeHeightM));
    program.setFloat(kTraceHazeAlbedoLocation, static_cast<float>(air.hazeAlbedo));
}

}  // namespace

void PathTracer::restart(const TraceSetup& setup) {
    setup_ = setup;
    lanes_ = 0;  // made again by the next pass
    firstPass_ = 0;
    firstTicket_ = 0;
    counters_ = {};
    progress_ = {};
}

bool PathTracer::isIn(const TraceSetup& setup) const {
    return lanes_ > 0 && firstPass_ == 0 && setup.seed == setup_.seed &&
           setup.periodic == setup_.periodic && setup.air == setup_.air &&
           setup.detectors == setup_.detectors && setup.maxScatterings == setup_.maxScatterings &&
           setup.sunRadiusRad == setup_.sunRadiusRad &&
           std::memcmp(&setup.block, &setup_.block, sizeof(setup.block)) == 0;
}

void PathTracer::prepare(const MediumTextures& medium, gl::ProgramCache& programs) {
    lanes_ = gl::deviceMemory().software ? kLanesInSoftware : kLanesOnGpu;
    rounds_ = kFewestRounds;
    const auto paths = static_cast<std::size_t>(pathsAPass());
    fill(lanesBuffer_, static_cast<std::size_t>(lanes_) * kLaneBytes);
    fill(results_, paths * kPassesAtOnce * sizeof(glm::vec4));
    countersBuffer_.write(&counters_, sizeof(counters_));
    for (gl::Texture* sums : {halves_.data(), &halves_[1], &squares_}) {
        if (sums->size() != glm::ivec3(sizePx(), 1)) {
            *sums = gl::Texture::make2D(GL_RGBA32F, sizePx());
        }
        glClearTexImage(sums->name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    block_.write(&setup_.block, sizeof(setup_.block));
    sunDepth_ = sunDepthOf(medium, setup_.periodic, block_, programs);
}

const gl::Program& PathTracer::tracing(const MediumTextures& medium, const PathMedium& paths,
                                       const gl::Texture* noise, gl::ProgramCache& programs) {
    std::vector<std::string> defines = mediumDefines(medium);
    defines.push_back(fmt::format("PERIODIC {}", setup_.periodic ? 1 : 0));
    defines.push_back(fmt::format("AIR {}", setup_.air ? 1 : 0));
    defines.push_back(fmt::format("DETECTORS {}", setup_.detectors != nullptr ? 1 : 0));
    defines.push_back(fmt::format("LOBE_CLASS {}", paths.lobeClass));
    const gl::Program& program = programs.get("reference/trace.comp", defines);
    program.setInt(kTraceLanesLocation, lanes_);
    program.setInt(kTracePathsLocation, pathsAPass());
    program.setInt(kTraceFirstTicketLocation, static_cast<int>(firstTicket_));
    program.setInt(kTraceFirstPassLocation, firstPass_);
    program.setInt(kTraceSeedLocation, setup_.seed);
    program.setInt(kTraceMaxScatteringsLocation, setup_.maxScatterings);
    program.setVec3(kTraceCellLocation, glm::vec3(paths.cellM));
    program.setVec3(kTraceVoxelLocation, glm::vec3(paths.voxelM));
    const double sine = std::sin(0.5 * setup_.sunRadiusRad);
    program.setFloat(kTraceDiscLocation, static_cast<float>(2.0 * sine * sine));
    program.setFloat(kTraceRouletteLocation, kRouletteFrom);
    if (setup_.air) setAir(*setup_.air, program);
    block_.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    medium.first.bind(kMedium0Unit);
    if (medium.second) medium.second.bind(kMedium1Unit);
    if (noise) noise->bind(kNoiseUnit);
    paths.cells.bind(kCellsUnit);
    paths.tables.phases.bind(kPhasesUnit);
    paths.tables.scattering.bind(kScatteringUnit);
    sunDepth_.bind(kSunDepthUnit);
    lanesBuffer_.bind(GL_SHADER_STORAGE_BUFFER, kLanesBuffer);
    countersBuffer_.bind(GL_SHADER_STORAGE_BUFFER, kCountersBuffer);
    results_.bind(GL_SHADER_STORAGE_BUFFER, kResultsBuffer);
    if (setup_.detectors != nullptr)
        setup_.detectors->bind(GL_SHADER_STORAGE_BUFFER, kDetectorsBuffer);
    return program;
}

/// One dispatch; leaves the machine idle, and the counts in `counters_`.
void PathTracer::carry(const gl::Program& program) {
    const auto start = std::chrono::steady_clock::now();
    program.setInt(kTraceRoundsLocation, rounds_);
    program.dispatch({lanes_, 1, 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(countersBuffer_.name(), 0, sizeof(counters_), &counters_);
    progress_.collisions += counters_.collisions;
    progress_.scatterings += counters_.scatterings;
    progress_.faults += counters_.faults;
    counters_.collisions = counters_.scatterings = counters_.faults = 0;
    countersBuffer_.write(&counters_, sizeof(counters_));
    const double took = millisecondsSince(start);
    progress_.seconds += 1e-3 * took;
    const double wanted = rounds_ * std::clamp(kDispatchMs / std::max(took, 0.01), 0.5, 2.0);
    rounds_ = std::clamp(static_cast<int>(wanted), kFewestRounds, kMostRounds);
}

/// Adds the oldest pass to its half.
void PathTracer::gather(gl::ProgramCache& programs, const gl::Texture& mean) {
    const int slot = firstPass_ % kPassesAtOnce;
    const auto half = static_cast<std::size_t>(firstPass_ % 2);
    const gl::Program& program = programs.get("reference/gather.comp");
    program.setInt(kGatherFirstResultLocation, slot * pathsAPass());
    program.setFloat(kGatherPerPathLocation, 1.0f / static_cast<float>(firstPass_ + 1));
    results_.bind(GL_SHADER_STORAGE_BUFFER, kResultsBuffer);
    halves_[half].bindImage(kGatherHalfImage, GL_READ_WRITE);
    squares_.bindImage(kGatherSquaresImage, GL_READ_WRITE);
    halves_[1 - half].bindImage(kGatherOtherImage, GL_READ_ONLY);
    mean.bindImage(kGatherMeanImage, GL_WRITE_ONLY);
    program.dispatch({sizePx(), 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    counters_.finished[slot] = 0;
    countersBuffer_.write(&counters_, sizeof(counters_));
    firstTicket_ += static_cast<std::uint32_t>(pathsAPass());
    ++firstPass_;
}

void PathTracer::pass(const MediumTextures& medium, const PathMedium& paths,
                      const gl::Texture* noise, gl::ProgramCache& programs, const gl::Texture& mean,
                      const Progress& progress) {
    if (lanes_ == 0) prepare(medium, programs);
    const gl::Program& program = tracing(medium, paths, noise, programs);
    const std::uint32_t& finished = counters_.finished[firstPass_ % kPassesAtOnce];
    while (finished < static_cast<std::uint32_t>(pathsAPass())) {
        if (!goOn(progress, static_cast<double>(finished) / pathsAPass())) throw Cancelled{};
        carry(program);
    }
    gather(programs, mean);
}

double PathTracer::relativeError(gl::ProgramCache& programs) {
    if (firstPass_ < 2) return std::numeric_limits<double>::infinity();
    const auto rows = static_cast<std::size_t>(sizePx().y);
    std::vector<glm::vec2> sums(rows);
    if (rows_.bytes() < rows * sizeof(glm::vec2)) fill(rows_, rows * sizeof(glm::vec2));
    const gl::Program& program = programs.get("reference/error.comp");
    program.setFloat(kErrorPathsLocation, static_cast<float>(firstPass_));
    halves_[0].bindImage(kErrorHalfAImage, GL_READ_ONLY);
    squares_.bindImage(kErrorSquaresImage, GL_READ_ONLY);
    halves_[1].bindImage(kErrorHalfBImage, GL_READ_ONLY);
    rows_.bind(GL_SHADER_STORAGE_BUFFER, kErrorRowsBuffer);
    program.dispatch({sizePx().y, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glGetNamedBufferSubData(rows_.name(), 0, static_cast<GLsizeiptr>(rows * sizeof(glm::vec2)),
                            sums.data());
    double mean = 0.0, variance = 0.0;
    for (const glm::vec2& sum : sums) {
        mean += static_cast<double>(sum.x);
        variance += static_cast<double>(sum.y);
    }
    const double values = 3.0 * pathsAPass();
    return mean > 0.0 ? std::sqrt(variance / values) / (mean / values) : 0.0;
}

ReferenceProgress PathTracer::progress(gl::ProgramCache& programs) {
    ReferenceProgress all = progress_;
    all.samples = firstPass_;
    all.relativeError = relativeError(programs);
    return all;
}

TraceSums PathTracer::readSums() const {
    return {{read(halves_[0]), read(halves_[1])}, read(squares_)};
}

std::size_t PathTracer::bytes() const {
    return lanesBuffer_.bytes() + results_.bytes() + halves_[0].bytes() + halves_[1].bytes() +
           squares_.bytes();
}

}  // namespace neph::render
