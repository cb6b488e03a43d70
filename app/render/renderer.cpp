// renderer.cpp: what is kept between frames, and what a change makes necessary.
#include "app/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "app/gl/objects.h"
#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "app/render/engines/march/march.h"
#include "app/render/engines/march/packed_medium.h"
#include "app/render/engines/reference/reference.h"
#include "app/render/engines/slicing/slicing.h"
#include "app/render/frame/frame_block.h"
#include "app/render/frame/rows.h"
#include "app/render/medium/medium_bake.h"
#include "app/render/medium/noise_texture.h"
#include "core/base/error.h"

namespace neph::render {

struct Renderer::Impl {
    explicit Impl(std::filesystem::path shaderDir) : programs(std::move(shaderDir)) {}

    gl::ProgramCache programs;
    std::optional<VolumeTextures> volume;
    MediumTextures medium;     ///< of slicing and reference; made when it is first wanted
    PackedMedium packed;       ///< of the march; likewise
    gl::Texture noise;         ///< of slicing and reference
    gl::Texture stackedNoise;  ///< of the march
    gl::Texture rays;          ///< where pixels are the mean of several
    gl::Texture linear, display;
    SlicingEngine slicing;
    MarchEngine march;
    ReferenceEngine reference;
    bool referenceStale = true;  ///< has not taken in `medium`
    gl::PassTimer timer;
    std::optional<FrameInputs> last;  ///< what `linear` shows; none when it must be redone
    std::optional<Look> lit;          ///< what the light in `packed` was carried for
    bool mediumStale = true;
    bool lightIsDraft = false;
    std::vector<std::string> messages;

    Stage stageFor(const FrameInputs& inputs) const;
    void bake(const FrameInputs& inputs, FrameStats& stats);
    const gl::Texture* stacked() const { return stackedNoise ? &stackedNoise : nullptr; }
    void repack(const FrameInputs& inputs, PackedDetail wanted, FrameStats& stats);
    void draw(const FrameInputs& inputs, Stage stage, const gl::Texture& to,
              const Progress& progress, FrameStats& stats);
    void drawRays(const FrameInputs& inputs, Stage stage, const Progress& progress,
                  FrameStats& stats);
    void resolve(const FrameInputs& inputs);
    void describe(const FrameInputs& inputs, Stage stage, FrameStats& stats);
};

namespace {

bool sameView(const Camera& a, const Camera& b) {
    return a.eyeWorld == b.eyeWorld && a.forward == b.forward && a.up == b.up &&
           a.tanHalfFovY == b.tanHalfFovY && a.aspect == b.aspect;
}

bool samePixels(const FrameInputs& a, const FrameInputs& b) {
    return a.sizePx == b.sizePx && a.part == b.part && a.supersample == b.supersample &&
           a.backdrop == b.backdrop;
}

/// Has `texture` hold a picture of this size.
void fit(gl::Texture& texture, GLenum format, glm::ivec2 sizePx) {
    if (texture.size() != glm::ivec3(sizePx, 1)) texture = gl::Texture::make2D(format, sizePx);
}

/// A picture whose pixels are the rays of `inputs`.
FrameInputs raysOf(FrameInputs inputs) {
    const int n = std::exchange(inputs.supersample, 1);
    inputs.sizePx *= n;
    if (inputs.part) {
        inputs.part->wholePx *= n;
        inputs.part->lowerPx *= n;
    }
    return inputs;
}

int limitOf(GLenum name) {
    GLint limit = 0;
    glGetIntegerv(name, &limit);
    return limit;
}

int largestSide() {
    return limitOf(GL_MAX_TEXTURE_SIZE);
}

void checkSize(glm::ivec2 sizePx) {
    const int most = largestSide();
    if (sizePx.x >= 1 && sizePx.y >= 1 && sizePx.x <= most && sizePx.y <= most) return;
    throw Error({.what = "a picture of this size cannot be rendered",
                 .found = fmt::format("{} x {} px", sizePx.x, sizePx.y),
                 .expected = fmt::format("1 to {} px a side on this GPU", most)});
}

}  // namespace

/// The earliest stage to redo. Slices lie halfway between eye and light, so there a moved camera
/// needs new light too.
Stage Renderer::Impl::stageFor(const FrameInputs& inputs) const {
    if (mediumStale) return Stage::medium;
    const bool slices = inputs.look.engine == Engine::slicing;
    const bool marches = inputs.look.engine == Engine::march;
    const bool finer = marches && lightIsDraft && !inputs.draftLight;
    // A picture that gave way leaves the march's light as it was.
    if (!last && lit && marches) {
        return std::min(finer ? Stage::light : Stage::eye,
                        firstDifference(*lit, inputs.look).value_or(Stage::eye));
    }
    if (!last) return Stage::medium;
    const Stage changed = firstDifference(*last, inputs).value_or(Stage::resolve);
    if (finer) return std::min(Stage::light, changed);
    const bool moved = !sameView(last->camera, inputs.camera) || last->planes != inputs.planes;
    if (moved) return std::min(slices ? Stage::light : Stage::eye, changed);
    const bool other = last->sample != inputs.sample || (inputs.profile && !last->profile) ||
                       !samePixels(*last, inputs);
    return other ? std::min(Stage::eye, changed) : changed;
}

void Renderer::Impl::bake(const FrameInputs& inputs, FrameStats& stats) {
    const MediumPlan plan = planMedium(inputs.look, volume->holdings);
    const bool marches = inputs.look.engine == Engine::march;
    gl::Texture& detail = marches ? stackedNoise : noise;
    if (isNoisy(plan) && !detail) {
        timer.pass("noise");
        detail = marches ? bakeStackedNoise(programs) : bakeNoise(programs);
    }
    const bool made =
        marches ? static_cast<bool>(packed.extinction) : static_cast<bool>(medium.first);
    if (!mediumStale && made && plan == (marches ? packed.look : medium.plan)) return;
    timer.pass("bake medium");
    lit.reset();
    // The other medium would be stale, and two would be held for nothing.
    reference = {};
    referenceStale = true;
    if (!marches) {
        packed = {};
        bakeMedium(*volume, plan, programs, medium);
    } else {
        medium = {};
        packMedium(*volume, inputs.look, stacked(), programs, packed);
    }
    mediumStale = false;
    stats.bakedMedium = true;
}

/// Has the march's medium hold the detail that is wanted.
void Renderer::Impl::repack(const FrameInputs& inputs, PackedDetail wanted, FrameStats& stats) {
    if (packed.detail == wanted) return;
    timer.pass("bake detail");
    repackMedium(*volume, inputs.look, wanted, stacked(), programs, packed);
    stats.bakedMedium = true;
}

void Renderer::Impl::draw(const FrameInputs& inputs, Stage stage, const gl::Texture& to,
                          const Progress& progress, FrameStats& stats) {
    if (inputs.look.engine == Engine::slicing) {
        slicing.render(inputs, *volume, medium, noise ? &noise : nullptr, programs, to,
                       stage == Stage::eye, progress, timer);
        return;
    }
    if (inputs.look.engine == Engine::reference) {
        timer.pass("paths");
        if (std::exchange(referenceStale, false)) {
            reference.prepare(medium, volume->grid, noise ? &noise : nullptr, programs);
        }
        reference.render(inputs, volume->grid, medium, noise ? &noise : nullptr, programs, to,
                         progress);
        return;
    }
    if (stage <= Stage::light) {
        lit.reset();
        repack(inputs, PackedDetail::voxels, stats);
        march.light(inputs, *volume, packed, programs, progress, timer);
        lit = inputs.look;
        lightIsDraft = inputs.draftLight;
    }
    repack(inputs, MarchEngine::detailFor(inputs, volume->grid, packed), stats);
    timer.pass("eye");
    march.eye(inputs, volume->grid, packed, stacked(), programs, to, progress);
}

/// Draws into `linear`.
void Renderer::Impl::drawRays(const FrameInputs& inputs, Stage stage, const Progress& progress,
                              FrameStats& stats) {
    fit(linear, GL_RGBA32F, inputs.sizePx);
    if (inputs.supersample == 1) {
        rays = {};
        draw(inputs, stage, linear, progress, stats);
        return;
    }
    const FrameInputs finer = raysOf(inputs);
    fit(rays, GL_RGBA32F, finer.sizePx);
    draw(finer, stage, rays, progress, stats);
    const gl::Program& program = programs.get("display/average.comp");
    program.setInt(0, inputs.supersample);
    rays.bindImage(0, GL_READ_ONLY);
    linear.bindImage(1, GL_WRITE_ONLY);
    program.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void Renderer::Impl::resolve(const FrameInputs& inputs) {
    const gl::Program& program = programs.get("display/resolve.comp");
    const glm::ivec2 lowerPx = inputs.part ? inputs.part->lowerPx : glm::ivec2(0);
    program.setInt(2, lowerPx.x);
    program.setInt(3, lowerPx.y);
    program.setInt(4, inputs.backdrop ? 0 : 1);
    program.setFloat(0, std::exp2(inputs.look.exposureEv));
    program.setInt(1, static_cast<int>(inputs.look.toneMap));
    linear.bindImage(0, GL_READ_ONLY);
    display.bindImage(1, GL_WRITE_ONLY);
    program.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void Renderer::Impl::describe(const FrameInputs& inputs, Stage stage, FrameStats& stats) {
    const bool slices = inputs.look.engine == Engine::slicing;
    const bool traces = inputs.look.engine == Engine::reference;
    stats.redone = stage;
    if (traces) {
        stats.reference = reference.progress(programs);
        if (stats.reference.samples == 1 && stats.reference.faults > 0) {
            messages.push_back(
                fmt::format("{} paths of the reference brought no number and count as dark",
                            stats.reference.faults));
        }
        stats.marchedLight = false;
    } else {
        const SlicePlan& plan = slices ? slicing.plan() : march.plan();
        stats.planes = slices ? plan.count : march.steps();
        stats.lightSize = {plan.lightSizePx, plan.count};
    }
    if (!inputs.profile) return;
    for (const auto& [name, milliseconds] : timer.finish()) {
        stats.passes.push_back({name, milliseconds});
    }
    if (!slices && !traces && stats.marchedEye) stats.samples = march.counts();
}

Renderer::Renderer(const std::filesystem::path& shaderDir)
    : impl_(std::make_unique<Impl>(shaderDir)) {
    SpeciesVolume clearSky;
    clearSky.grid.size = glm::ivec3(1);
    setVolume(clearSky);
}

Renderer::~Renderer() = default;

void Renderer::setVolume(const SpeciesVolume& volume) {
    const glm::ivec3 size = volume.grid.size;
    const int most = limitOf(GL_MAX_3D_TEXTURE_SIZE);
    if (std::max({size.x, size.y, size.z}) > most) {
        throw Error({.what = "the grid is larger than this GPU takes",
                     .found = fmt::format("{} x {} x {} cells", size.x, size.y, size.z),
                     .expected = fmt::format("at most {} cells a side", most)});
    }
    impl_->volume = uploadVolume(volume);
    impl_->mediumStale = true;
}

FrameStats Renderer::render(const FrameInputs& inputs, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    checkSize(inputs.sizePx * inputs.supersample);
    FrameStats stats;
    const Stage stage = impl_->stageFor(inputs);
    assert(inputs.sample == 0 || stage > Stage::light);
    // Until this frame is whole; a further sample that gives way leaves the ones before.
    if (inputs.sample == 0) impl_->last.reset();
    impl_->timer.start(inputs.profile);
    if (stage <= Stage::medium) impl_->bake(inputs, stats);
    if (stage <= Stage::eye) {
        impl_->drawRays(inputs, stage, progress, stats);
        stats.marchedLight = stage <= Stage::light;
        stats.marchedEye = true;
    }
    if (impl_->display.size() != glm::ivec3(inputs.sizePx, 1)) {
        impl_->display = gl::Texture::make2D(GL_RGBA8, inputs.sizePx);
        impl_->display.setLinear();
    }
    impl_->timer.pass("resolve");
    impl_->resolve(inputs);
    impl_->last = inputs;
    glFinish();
    impl_->describe(inputs, stage, stats);
    stats.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return stats;
}

unsigned Renderer::displayTexture() const {
    return impl_->display.name();
}

ImageF Renderer::readLinear() const {
    ImageF image;
    image.size = impl_->last ? impl_->last->sizePx : glm::ivec2(0);
    const auto width = static_cast<std::size_t>(image.size.x);
    std::vector<glm::vec4> rows(width * static_cast<std::size_t>(image.size.y));
    if (rows.empty()) return image;
    glGetTextureImage(impl_->linear.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(rows.size() * sizeof(glm::vec4)), rows.data());
    image.pixels = fromTop(rows, width);
    return image;
}

Image8 Renderer::readDisplay() const {
    Image8 image;
    image.size = impl_->last ? impl_->last->sizePx : glm::ivec2(0);
    const std::size_t stride = 4 * static_cast<std::size_t>(image.size.x);
    std::vector<std::uint8_t> rows(stride * static_cast<std::size_t>(image.size.y));
    if (rows.empty()) return image;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(impl_->display.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rows.size()), rows.data());
    image.rgba = fromTop(rows, stride);
    return image;
}

ReferenceLayers Renderer::readReference() const {
    if (!impl_->last || impl_->last->look.engine != Engine::reference) return {};
    return impl_->reference.layers(raysOf(*impl_->last), *impl_->volume, impl_->medium,
                                   impl_->noise ? &impl_->noise : nullptr, impl_->programs);
}

std::array<ImageF, 2> Renderer::readHalves() const {
    if (!impl_->last || impl_->last->look.engine != Engine::reference) return {};
    return impl_->reference.halves(raysOf(*impl_->last).sizePx);
}

int Renderer::largestSidePx() const {
    return largestSide();
}

std::string Renderer::deviceName() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

double Renderer::floorMilliseconds(const FrameInputs& inputs) {
    FrameInputs profiled = inputs;
    profiled.profile = true;
    profiled.look.engine = Engine::march;
    render(profiled);
    impl_->last.reset();
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    impl_->march.floor(profiled, impl_->volume->grid, impl_->packed, impl_->programs,
                       impl_->linear);
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::vector<MemoryUse> Renderer::memory() const {
    const std::size_t light = impl_->march.lightBytes();
    return {{"species", impl_->volume->bytes()},
            {"medium", impl_->packed.bytes() + impl_->medium.bytes()},
            {"light", light},
            {"noise", impl_->noise.bytes() + impl_->stackedNoise.bytes()},
            {"pictures", impl_->linear.bytes() + impl_->rays.bytes() + impl_->display.bytes() +
                             impl_->slicing.bytes() + impl_->march.bytes() - light +
                             impl_->reference.bytes()}};
}

std::size_t Renderer::gpuBytes() const {
    std::size_t sum = 0;
    for (const MemoryUse& part : memory()) sum += part.bytes;
    return sum;
}

std::vector<std::string> Renderer::takeMessages() {
    return std::exchange(impl_->messages, {});
}

void Renderer::reloadChangedShaders() {
    const int before = impl_->programs.generation();
    for (std::string& problem : impl_->programs.reload()) {
        impl_->messages.push_back(std::move(problem));
    }
    if (impl_->programs.generation() == before) return;
    impl_->mediumStale = true;
    impl_->noise = {};
    impl_->stackedNoise = {};
}

}  // namespace neph::render
