// reference.cpp: the paths' setting, and the layers that can be read besides the image.
#include "app/render/engines/reference/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "app/render/frame/rows.h"

namespace neph::render {
namespace {

// Of a voxel: between their centres a ray's extinction is a cubic, whose integral the midpoints of
// a quarter have to a hundredth of its change.
constexpr double kDepthStepVoxels = 0.25;

ImageF imageOf(const std::vector<glm::vec4>& sums, glm::ivec2 size, int paths) {
    ImageF image;
    image.size = size;
    image.pixels = fromTop(sums, static_cast<std::size_t>(size.x));
    for (glm::vec4& pixel : image.pixels) pixel /= static_cast<float>(std::max(paths, 1));
    return image;
}

/// Means of the even and of the odd paths.
std::array<ImageF, 2> meansOf(const TraceSums& sums, glm::ivec2 size, int paths) {
    return {imageOf(sums.halves[0], size, (paths + 1) / 2),
            imageOf(sums.halves[1], size, paths / 2)};
}

std::vector<glm::vec3> variances(const TraceSums& sums, glm::ivec2 size, int paths) {
    std::vector<glm::vec3> out(sums.squares.size(),
                               glm::vec3(std::numeric_limits<float>::infinity()));
    if (paths < 2) return out;
    const auto n = static_cast<float>(paths);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::vec3 mean = glm::vec3(sums.halves[0][i] + sums.halves[1][i]) / n;
        const glm::vec3 spread = glm::vec3(sums.squares[i]) / n - mean * mean;
        out[i] = glm::max(spread, glm::vec3(0.0f)) / (n - 1.0f);
    }
    return fromTop(out, static_cast<std::size_t>(size.x));
}

std::vector<float> firstDistances(const TraceSums& sums, glm::ivec2 size) {
    std::vector<float> out(sums.squares.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float met = sums.halves[0][i].w + sums.halves[1][i].w;
        if (met > 0.0f) out[i] = sums.squares[i].w / met;
    }
    return fromTop(out, static_cast<std::size_t>(size.x));
}

FrameBlock blockOf(const FrameInputs& inputs, const RegularGrid& grid, const MediumTextures& medium,
                   const SkyTextures& sky) {
    FrameBlock block = makeFrameBlock(inputs, grid, medium.bricks, medium.plan, SlicePlan{}, sky);
    block.ground = glm::vec4(groundAlbedo(inputs.look), block.ground.w);
    return block;
}

std::string periodicDefine(const MediumTextures& medium) {
    return fmt::format("PERIODIC {}", medium.plan.repeats ? 1 : 0);
}

float depthStepM(const RegularGrid& grid) {
    const glm::dvec3 voxelM = grid.spacingM;
    return static_cast<float>(kDepthStepVoxels * std::min({voxelM.x, voxelM.y, voxelM.z}));
}

void addSunDisc(const FrameRequest& frame, const MediumTextures& medium,
                const RenderContext& context) {
    if (!context.sky.hasAir() || !frame.inputs.look.sunDisc) return;
    std::vector<std::string> defines = mediumDefines(medium);
    defines.push_back(periodicDefine(medium));
    const gl::Program& program = context.programs.get("reference/sun_disc.comp", defines);
    program.setFloat(kSunDiscStepLocation, depthStepM(context.volume.grid));
    frame.linear.bindImage(kSunDiscImage, GL_READ_WRITE);
    program.dispatch({frame.inputs.sizePx, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

std::optional<AirBands> airOf(const Look& look, const SkyTextures& sky) {
    if (!sky.hasAir() || look.referenceAir == ReferenceAir::tables) return std::nullopt;
    return airBandsOf(sky.air());
}

}  // namespace

void ReferenceEngine::prepare(const Look& look, RenderContext& context) {
    prepareClasses(look, context);
}

void ReferenceEngine::render(const FrameRequest& frame, RenderContext& context) {
    context.timer.pass("paths");
    const FrameInputs& inputs = frame.inputs;
    const RegularGrid& grid = context.volume.grid;
    const MediumTextures& medium = context.medium.as<MediumTextures>();
    const gl::Texture* noise = filteredNoise(medium.plan, context);
    if (pathsOf_ != context.medium.version()) {
        paths_ = {};  // the old one need not be held beside the new
        tracer_ = {};
        paths_ =
            makePathMedium(medium, grid, cellVoxelsFor(grid.size), 1.0, noise, context.programs);
        pathsOf_ = context.medium.version();
    }
    if (frame.sample == 0) {
        // A first pass that yielded goes on.
        const TraceSetup setup{.block = blockOf(inputs, grid, medium, context.sky),
                               .periodic = sidesRepeat(inputs.look),
                               .air = airOf(inputs.look, context.sky),
                               .seed = inputs.sampling.seed};
        if (!tracer_.isIn(setup)) tracer_.restart(setup);
    }
    tracer_.pass(medium, paths_, noise, context.programs, frame.linear, context.progress);
    addSunDisc(frame, medium, context);  // reads what the paths read
    if (frame.sample > 0) return;
    std::vector<std::string> defines = mediumDefines(medium);
    defines.push_back(periodicDefine(medium));
    measureSunShown(inputs, defines, context);
}

void ReferenceEngine::describe(const FrameInputs&, RenderContext& context) {
    context.stats.reference = tracer_.progress(context.programs);
    if (tracer_.passes() == 1 && tracer_.faults() > 0) {
        context.messages.push_back(fmt::format(
            "{} paths of the reference brought no number and count as dark", tracer_.faults()));
    }
}

std::array<ImageF, 2> ReferenceEngine::halves(glm::ivec2 sizePx) const {
    const int paths = tracer_.passes();
    if (paths < 2) return {};
    return meansOf(tracer_.readSums(), sizePx, paths);
}

std::optional<FrameLayers> ReferenceEngine::layers(const FrameInputs& inputs,
                                                   RenderContext& context) {
    const VolumeTextures& volume = context.volume;
    const MediumTextures& medium = context.medium.as<MediumTextures>();
    const glm::ivec2 size = inputs.sizePx;
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const int paths = tracer_.passes();
    const TraceSums sums = tracer_.readSums();
    FrameLayers layers;
    layers.size = size;
    layers.samples = paths;
    std::array<ImageF, 2> halves = meansOf(sums, size, paths);
    layers.halfA = std::move(halves[0]);
    layers.halfB = std::move(halves[1]);
    layers.varianceOfMean = variances(sums, size, paths);
    layers.firstScatterM = firstDistances(sums, size);

    const gl::Program& program = context.programs.get(
        "reference/species_depths.comp",
        {fmt::format("NOISE {}", isNoisy(medium.plan) ? 1 : 0), periodicDefine(medium)});
    const FrameBlock block = blockOf(inputs, volume.grid, medium, context.sky);
    gl::Buffer uniforms, depths;
    uniforms.write(&block, sizeof(block));
    uniforms.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    std::vector<float> values(count * kSpeciesCount);
    depths.write(values.data(), values.size() * sizeof(float));
    depths.bind(GL_SHADER_STORAGE_BUFFER, kDepthsBuffer);
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto i = static_cast<std::size_t>(s);
        volume.held[i].bind(static_cast<GLuint>(kHeldUnit + s));
        program.setFloat(kExtinctionPerHeldLocation + s,
                         medium.plan.extinctionPerHeld[i] * volume.perTexel[i]);
        program.setInt(kClassOfLocation + s, medium.plan.classOf[i]);
    }
    if (const gl::Texture* noise = filteredNoise(medium.plan, context))
        noise->bind(kBesideHeldUnit);
    program.setFloat(kDepthsStepLocation, depthStepM(volume.grid));
    program.dispatch({size, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glGetNamedBufferSubData(depths.name(), 0,
                            static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data());
    layers.transmittance.assign(count, 0.0f);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(s * count);
        layers.opticalDepth[s] =
            fromTop(std::vector<float>(first, first + static_cast<std::ptrdiff_t>(count)),
                    static_cast<std::size_t>(size.x));
        for (std::size_t i = 0; i < count; ++i)
            layers.transmittance[i] += layers.opticalDepth[s][i];
    }
    for (float& t : layers.transmittance) t = std::exp(-t);
    return layers;
}

template <>
std::unique_ptr<Integrator> makeIntegrator<Engine::reference>() {
    return std::make_unique<ReferenceEngine>();
}

}  // namespace neph::render
