// trace_meter.cpp: a small scene as the medium of the engine, and an image whose columns are
// detectors.
#include "app/render/engines/reference/trace_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gl/objects.h"
#include "app/gl/program.h"

namespace neph::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPathsAPass = 1 << 15;  // enough to keep all lanes busy
constexpr int kMaxRows = 4096;        // of a texture: OpenGL 4.5 promises 16384, llvmpipe less

glm::vec4 v4(glm::dvec3 v, double w = 0.0) {
    return {glm::vec3(v), static_cast<float>(w)};
}

/// The largest absorption that a point can have, 1/m.
double mostAbsorptionPerM(const MeterScene& scene) {
    double most = 0.0;
    for (const MeterField& field : scene.fields) {
        const auto& values = field.extinctionPerM.values;
        most += (1.0 - field.albedo) *
                static_cast<double>(*std::max_element(values.begin(), values.end()));
    }
    return most;
}

gl::Buffer listOf(const MeterScene& scene, std::span<const Detector> detectors) {
    std::vector<block::DetectorBlock> blocks;
    const double most = std::max(mostAbsorptionPerM(scene), 1e-30);
    for (const Detector& d : detectors) {
        blocks.push_back({v4(d.box.lowerM, static_cast<int>(d.kind)), v4(d.box.upperM),
                          v4(glm::normalize(d.direction), most)});
    }
    gl::Buffer list;
    list.write(blocks.data(), blocks.size() * sizeof(block::DetectorBlock));
    return list;
}

/// What the shader's result, a mean radiance, is multiplied by.
double scaleOf(const MeterScene& scene, DetectorKind kind) {
    switch (kind) {
        case DetectorKind::radiance:
            return 1.0;
        case DetectorKind::flux:
        case DetectorKind::diffuseFlux:
            return kPi;
        case DetectorKind::absorption:
            break;
    }
    return 4.0 * kPi * mostAbsorptionPerM(scene);
}

MediumTextures textureOf(const MeterScene& scene) {
    MediumTextures medium;
    const std::size_t count = scene.fields.size();
    const std::size_t textures = count > kClassesBesideSkylight ? 2 : 1;
    const auto voxels = static_cast<std::size_t>(scene.size.x) *
                        static_cast<std::size_t>(scene.size.y) *
                        static_cast<std::size_t>(scene.size.z);
    std::array<std::vector<glm::vec4>, 2> values;
    for (std::size_t t = 0; t < textures; ++t) values[t].resize(voxels, glm::vec4(0.0f));
    for (std::size_t f = 0; f < count; ++f) {
        const MeterField& field = scene.fields[f];
        medium.plan.classes.push_back(
            {.albedo = static_cast<float>(field.albedo), .phase = field.phase});
        for (std::size_t i = 0; i < voxels; ++i) {
            values[f / 4][i][static_cast<int>(f % 4)] = field.extinctionPerM.values[i];
        }
    }
    for (std::size_t t = 0; t < textures; ++t) {
        gl::Texture& texture = t == 0 ? medium.first : medium.second;
        texture = gl::Texture::make3D(GL_RGBA32F, scene.size);
        if (scene.trilinear) texture.setLinear();
        texture.upload(GL_RGBA, GL_FLOAT, values[t].data());
    }
    return medium;
}

FrameBlock blockOf(const MeterScene& scene, const MediumPlan& plan, glm::ivec2 sizePx) {
    FrameBlock block{};
    block.towardsSun = v4(glm::normalize(scene.towardsSun));
    block.gridExtentM = v4(glm::dvec3(scene.size) * scene.spacingM);
    block.sunRadiance = v4(glm::dvec3(scene.sunIrradiance / (4.0 * kPi)));
    block.skyZenith = block.skyHorizon = v4(glm::dvec3(scene.skyRadiance));
    block.ground = v4(glm::dvec3(scene.surfaceAlbedo.value_or(0.0)), scene.surfaceAlbedo ? 1 : 0);
    block.image = {sizePx, 0, 0};
    block.whole = {sizePx, 0, 0};
    for (std::size_t i = 0; i < plan.classes.size(); ++i) {
        block.classes[i].colourAlbedo =
            v4(glm::dvec3(plan.classes[i].albedo), plan.classes[i].albedo);
    }
    return block;
}

/// Mean and error of a detector: a column of the image.
Measured measured(const TraceSums& sums, glm::ivec2 sizePx, int column, int passes, double scale) {
    double sum = 0.0, squares = 0.0;
    for (int row = 0; row < sizePx.y; ++row) {
        const auto i = static_cast<std::size_t>(row * sizePx.x + column);
        sum += static_cast<double>(sums.halves[0][i].g) + static_cast<double>(sums.halves[1][i].g);
        squares += static_cast<double>(sums.squares[i].g);
    }
    const double n = static_cast<double>(sizePx.y) * passes;
    const double mean = sum / n;
    const double variance = std::max(0.0, squares / n - mean * mean) / std::max(n - 1.0, 1.0);
    return {scale * mean, scale * std::sqrt(variance), static_cast<std::uint64_t>(n)};
}

}  // namespace

struct TraceMeter::Impl {
    explicit Impl(const std::filesystem::path& shaderDir) : programs(shaderDir) {}

    gl::ProgramCache programs;
    PathTracer tracer;
};

TraceMeter::TraceMeter(const std::filesystem::path& shaderDir)
    : impl_(std::make_unique<Impl>(shaderDir)) {}

TraceMeter::~TraceMeter() = default;

std::vector<Measured> TraceMeter::measure(const MeterScene& scene,
                                          std::span<const Detector> detectors,
                                          const MeterSettings& settings, const Progress& progress) {
    const auto count = static_cast<int>(detectors.size());
    const auto wanted = static_cast<std::int64_t>(std::max<std::uint64_t>(settings.samples, 2));
    // Half of them in each of two passes, at least.
    const int rows = static_cast<int>(std::clamp<std::int64_t>(
        kPathsAPass / std::max(count, kPathsAPass / kMaxRows), 1, (wanted + 1) / 2));
    const int passes = static_cast<int>((wanted + rows - 1) / rows);
    const glm::ivec2 sizePx{count, rows};
    const MediumTextures medium = textureOf(scene);
    const PathMedium paths =
        makePathMedium(medium, {scene.size, {}, scene.spacingM}, settings.brickVoxels,
                       settings.majorantScale, nullptr, impl_->programs);
    const gl::Buffer list = listOf(scene, detectors);
    const gl::Texture mean = gl::Texture::make2D(GL_RGBA32F, sizePx);
    PathTracer& tracer = impl_->tracer;
    tracer.restart({.block = blockOf(scene, medium.plan, sizePx),
                    .periodic = scene.periodic,
                    .air = scene.air,
                    .detectors = &list,
                    .seed = static_cast<int>(settings.seed),
                    .maxScatterings = settings.maxScatterings,
                    .sunRadiusRad = scene.sunRadiusRad});
    for (int i = 0; i < passes; ++i) {
        tracer.pass(medium, paths, nullptr, impl_->programs, mean,
                    [&](double share) { return goOn(progress, (i + share) / passes); });
    }
    const TraceSums sums = tracer.readSums();
    std::vector<Measured> results;
    for (int i = 0; i < count; ++i) {
        results.push_back(measured(sums, sizePx, i, tracer.passes(),
                                   scaleOf(scene, detectors[static_cast<std::size_t>(i)].kind)));
        // A path that brought no number would hide as a dark one.
        if (tracer.faults() > 0) {
            results.back().mean = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return results;
}

std::vector<float> TraceMeter::sampledCosines(const PhaseSpec& phase, int count,
                                              std::uint32_t seed) {
    const ScatteringTables tables = makeScatteringTables(std::span(&phase, 1));
    MediumTextures one;
    one.plan.classes.resize(1);
    const gl::Program& program = impl_->programs.get("reference/cosines.comp", [&] {
        std::vector<std::string> defines = mediumDefines(one);
        defines.emplace_back("PERIODIC 0");
        return defines;
    }());
    std::vector<float> cosines(static_cast<std::size_t>(count));
    gl::Buffer buffer;
    buffer.write(cosines.data(), cosines.size() * sizeof(float));
    buffer.bind(GL_SHADER_STORAGE_BUFFER, kCosinesBuffer);
    tables.phases.bind(kPhasesUnit);
    tables.scattering.bind(kScatteringUnit);
    program.setInt(kCosinesCountLocation, count);
    program.setInt(kCosinesSeedLocation, static_cast<int>(seed));
    program.dispatch({count, 1, 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(
        buffer.name(), 0, static_cast<GLsizeiptr>(cosines.size() * sizeof(float)), cosines.data());
    return cosines;
}

std::string TraceMeter::deviceName() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace neph::render
