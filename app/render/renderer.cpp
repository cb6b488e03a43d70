// renderer.cpp: what is kept between frames, and what a change makes necessary.
#include "app/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <optional>
#include <utility>

#include "app/gl/kept_images.h"
#include "app/gl/objects.h"
#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "app/render/frame/rows.h"
#include "app/render/integrators.h"
#include "app/render/resolve.h"
#include "core/base/error.h"

namespace neph::render {

#include "shaders/shared/display_layout.glsl"

struct Renderer::Impl {
    explicit Impl(std::filesystem::path shaderDir)
        : programs(std::make_shared<gl::ProgramCache>(std::move(shaderDir))),
          noise(std::make_shared<NoiseTextures>()) {}
    /// Of the same volume.
    explicit Impl(const Impl* of)
        : programs(of->programs), volume(of->volume), noise(of->noise), shares(true) {}

    /// The image that `linear` and `display` show.
    struct Shown {
        FrameInputs inputs;
        int sample = 0;  ///< of the last frame that was added to it
    };
    /// What is on the screen in place of `display`.
    struct Preview {
        FrameInputs of;
        gl::Texture linear, display;
    };

    std::shared_ptr<gl::ProgramCache> programs;
    std::shared_ptr<const VolumeTextures> volume;
    HeldMedium medium;
    SkyTextures sky;
    std::shared_ptr<NoiseTextures> noise;
    bool shares = false;  ///< what is above, with the renderer that it was made from
    gl::Texture rays;     ///< where pixels are the mean of several
    gl::Texture linear, display;
    gl::Texture sunShown = gl::Texture::make2D(GL_R32F, {1, 1});
    Engine engine{};
    std::unique_ptr<Integrator> integrator;  ///< of `engine`; made when it is first wanted
    gl::PassTimer timer;
    std::optional<Shown> shown;  ///< none when it must be redone
    std::optional<Preview> preview;
    std::uint64_t images = 0;  ///< that were begun
    std::vector<std::string> messages;
    std::function<void()> wake;

    RenderContext context(const Progress& progress, FrameStats& stats) {
        return {*volume, medium,   *noise, sky,      sunShown, *programs,
                timer,   progress, stats,  messages, wake};
    }
    void use(Engine wanted);
    std::optional<Stage> changeTo(const FrameInputs& inputs, int sample) const;
    FrameStats frame(const FrameInputs& inputs, int sample, Stage stage, const Progress& progress);
    void draw(const FrameInputs& inputs, int sample, Stage stage, RenderContext& context);
    void resolveAll(const FrameInputs& inputs, bool sameVolume);
    const gl::Texture& onScreen() const { return preview ? preview->display : display; }
    std::size_t imageBytes() const {
        const std::size_t own = linear.bytes() + rays.bytes() + display.bytes();
        return own + (preview ? preview->linear.bytes() + preview->display.bytes() : 0);
    }
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

/// Whether they differ in fineness and tones alone.
bool sameScene(const FrameInputs& a, const FrameInputs& b) {
    return firstDifference(a, b).value_or(Stage::resolve) == Stage::resolve &&
           sameView(a.camera, b.camera) && a.backdrop == b.backdrop;
}

/// Whether frames of the one can be added to an image of the other.
[[maybe_unused]] bool sameImage(const FrameInputs& a, const FrameInputs& b) {
    return sameScene(a, b) && samePixels(a, b) && a.planes == b.planes;
}

/// Has `texture` hold an image of this size.
void fit(gl::Texture& texture, GLenum format, glm::ivec2 sizePx) {
    if (texture.size() != glm::ivec3(sizePx, 1)) texture = gl::Texture::make2D(format, sizePx);
}

/// An image whose pixels are the rays of `inputs`.
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

void checkSize(glm::ivec2 sizePx) {
    const int most = limitOf(GL_MAX_TEXTURE_SIZE);
    if (sizePx.x >= 1 && sizePx.y >= 1 && sizePx.x <= most && sizePx.y <= most) return;
    throw Error({.what = "an image of this size cannot be rendered",
                 .found = fmt::format("{} x {} px", sizePx.x, sizePx.y),
                 .expected = fmt::format("1 to {} px a side on this GPU", most)});
}

}  // namespace

/// Memory of the engine that is left is given back before the other takes any.
void Renderer::Impl::use(Engine wanted) {
    if (integrator && engine == wanted) return;
    shown.reset();
    integrator.reset();
    integrator = makeIntegrator(wanted);
    engine = wanted;
}

/// The earliest stage that has to be redone for what is different from the image that is shown.
std::optional<Stage> Renderer::Impl::changeTo(const FrameInputs& inputs, int sample) const {
    if (!shown) return {};
    const FrameInputs& last = shown->inputs;
    Stage first = firstDifference(last, inputs).value_or(Stage::resolve);
    const auto redo = [&first](Stage stage) { first = std::min(first, stage); };
    if (!sameView(last.camera, inputs.camera) || last.planes != inputs.planes) {
        redo(traitsOf(engine).lightFollowsCamera ? Stage::light : Stage::eye);
    }
    if (sample > 0 || shown->sample > 0) redo(Stage::eye);
    if ((inputs.profile && !last.profile) || !samePixels(last, inputs)) redo(Stage::eye);
    return first;
}

/// Draws into `linear`.
void Renderer::Impl::draw(const FrameInputs& inputs, int sample, Stage stage,
                          RenderContext& context) {
    context.timer.pass("sky");
    sky.update(inputs.look, inputs.camera.eyeWorld.z);
    sky.bind();
    fit(linear, GL_RGBA32F, inputs.sizePx);
    if (inputs.supersample == 1) {
        rays = {};
        integrator->render({inputs, stage, sample, linear}, context);
        return;
    }
    const FrameInputs finer = raysOf(inputs);
    fit(rays, GL_RGBA32F, finer.sizePx);
    integrator->render({finer, stage, sample, rays}, context);
    const gl::Program& program = programs->get("display/average.comp");
    program.setInt(kAverageSideLocation, inputs.supersample);
    rays.bindImage(kAverageRaysImage, GL_READ_ONLY);
    linear.bindImage(kAverageLinearImage, GL_WRITE_ONLY);
    program.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

/// A preview stays until there is an image of something else.
void Renderer::Impl::resolveAll(const FrameInputs& inputs, bool sameVolume) {
    resolve(linear, sunShown, inputs, *programs, display);
    if (preview && !(sameVolume && sameScene(preview->of, inputs))) preview.reset();
    if (preview && !(preview->of.look == inputs.look)) {
        preview->of.look = inputs.look;
        resolve(preview->linear, sunShown, preview->of, *programs, preview->display);
    }
}

/// Redoes `stage` and those after it.
FrameStats Renderer::Impl::frame(const FrameInputs& inputs, int sample, Stage stage,
                                 const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    FrameStats stats;
    stats.redone = stage;
    const bool sameVolume = !medium.stale();
    RenderContext working = context(progress, stats);
    timer.start(inputs.profile);
    if (stage <= Stage::medium) integrator->prepare(inputs.look, working);
    if (stage <= Stage::eye) {
        draw(inputs, sample, stage, working);
        stats.marchedEye = true;
    }
    timer.pass("resolve");
    resolveAll(inputs, sameVolume);
    shown = {inputs, sample};
    glFinish();
    integrator->describe(inputs, working);
    if (inputs.profile) {
        for (const auto& [name, milliseconds] : timer.finish()) {
            stats.passes.push_back({name, milliseconds});
        }
    }
    stats.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return stats;
}

Renderer::Renderer(const std::filesystem::path& shaderDir)
    : impl_(std::make_unique<Impl>(shaderDir)) {
    SpeciesVolume clearSky;
    clearSky.grid.size = glm::ivec3(1);
    setVolume(clearSky);
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

std::unique_ptr<Renderer> Renderer::beside() const {
    return std::unique_ptr<Renderer>(new Renderer(std::make_unique<Impl>(impl_.get())));
}

Renderer::~Renderer() = default;

void Renderer::setWake(std::function<void()> wake) {
    impl_->wake = std::move(wake);
}

bool Renderer::hasNewerLight() const {
    return impl_->integrator && impl_->integrator->hasNewerLight();
}

void Renderer::setVolume(const SpeciesVolume& volume) {
    const glm::ivec3 size = volume.grid.size;
    const int most = limitOf(GL_MAX_3D_TEXTURE_SIZE);
    if (std::max({size.x, size.y, size.z}) > most) {
        throw Error({.what = "the grid is larger than this GPU takes",
                     .found = fmt::format("{} x {} x {} cells", size.x, size.y, size.z),
                     .expected = fmt::format("at most {} cells a side", most)});
    }
    impl_->volume = std::make_shared<const VolumeTextures>(uploadVolume(volume));
    impl_->medium.invalidate();
}

FrameStats Renderer::render(const FrameInputs& inputs, const Progress& progress) {
    Accumulation alone;
    return render(inputs, alone, progress);
}

FrameStats Renderer::render(const FrameInputs& inputs, Accumulation& image,
                            const Progress& progress) {
    checkSize(inputs.sizePx * inputs.supersample);
    impl_->use(inputs.look.engine);
    const int sample = image.samples_;
    const std::optional<Stage> changed = impl_->changeTo(inputs, sample);
    const Stage stage =
        impl_->medium.stale() ? Stage::medium : impl_->integrator->stageFor(inputs, changed);
    if (sample == 0) {
        // Until this frame is whole; a further sample that yields leaves the ones before.
        impl_->shown.reset();
        image.image_ = ++impl_->images;
    } else {
        assert(image.image_ == impl_->images && "another image has taken its place");
        assert(stage == Stage::eye && sameImage(impl_->shown->inputs, inputs));
    }
    const FrameStats stats = impl_->frame(inputs, sample, stage, progress);
    ++image.samples_;
    return stats;
}

FrameStats Renderer::retone(const Look& look) {
    assert(impl_->shown && "there is an image");
    FrameInputs inputs = impl_->shown->inputs;
    assert(firstDifference(inputs.look, look).value_or(Stage::resolve) == Stage::resolve);
    inputs.look = look;
    inputs.profile = false;
    return impl_->frame(inputs, impl_->shown->sample, Stage::resolve, {});
}

unsigned Renderer::displayTexture() const {
    return impl_->onScreen().name();
}

glm::ivec2 Renderer::displaySizePx() const {
    return glm::ivec2(impl_->onScreen().size());
}

ImageF Renderer::readLinear() const {
    ImageF image;
    image.size = impl_->shown ? impl_->shown->inputs.sizePx : glm::ivec2(0);
    const auto width = static_cast<std::size_t>(image.size.x);
    std::vector<glm::vec4> rows(width * static_cast<std::size_t>(image.size.y));
    if (rows.empty()) return image;
    glGetTextureImage(impl_->linear.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(rows.size() * sizeof(glm::vec4)), rows.data());
    image.pixels = fromTop(rows, width);
    return image;
}

Image8 Renderer::readDisplay() const {
    return impl_->shown || impl_->preview ? readRgba8(impl_->onScreen()) : Image8{};
}

void Renderer::showPreview(const ImageF& image, const FrameInputs& of) {
    impl_->preview.emplace(Impl::Preview{of, {}, {}});
    Impl::Preview& preview = *impl_->preview;
    fit(preview.linear, GL_RGBA32F, image.size);
    const auto width = static_cast<std::size_t>(image.size.x);
    preview.linear.upload(GL_RGBA, GL_FLOAT, fromTop(image.pixels, width).data());
    const gl::KeptImages kept(kResolveImages);  // a frame may be under way, of another renderer too
    resolve(preview.linear, impl_->sunShown, of, *impl_->programs, preview.display);
}

void Renderer::hidePreview() {
    impl_->preview.reset();
}

bool Renderer::showsPreview() const {
    return impl_->preview.has_value();
}

std::optional<FrameLayers> Renderer::readLayers() const {
    if (!impl_->shown) return {};
    FrameStats unused;
    const Progress none;
    RenderContext context = impl_->context(none, unused);
    return impl_->integrator->layers(raysOf(impl_->shown->inputs), context);
}

std::array<ImageF, 2> Renderer::readHalves() const {
    if (!impl_->shown) return {};
    return impl_->integrator->halves(raysOf(impl_->shown->inputs).sizePx);
}

int Renderer::largestSidePx() const {
    return limitOf(GL_MAX_TEXTURE_SIZE);
}

std::string Renderer::deviceName() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

std::optional<double> Renderer::floorMilliseconds() {
    assert(impl_->shown && impl_->shown->inputs.profile && "the last frame was profiled");
    const FrameInputs inputs = raysOf(impl_->shown->inputs);
    const gl::Texture& to = impl_->rays ? impl_->rays : impl_->linear;
    FrameStats unused;
    const Progress none;
    RenderContext context = impl_->context(none, unused);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    if (!impl_->integrator->floor({inputs, Stage::eye, 0, to}, context)) return {};
    impl_->shown.reset();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::vector<MemoryUse> Renderer::memory() const {
    const Integrator* engine = impl_->integrator.get();
    const bool shares = impl_->shares;
    return {{"species", shares ? 0 : impl_->volume->bytes(), true},
            {"medium", impl_->medium.bytes(), true},
            {"light", engine ? engine->lightBytes() : 0, true},
            {"noise", shares ? 0 : impl_->noise->bytes()},
            {"air", impl_->sky.bytes()},
            {"images", impl_->imageBytes() + (engine ? engine->otherBytes() : 0)}};
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
    const int before = impl_->programs->generation();
    for (std::string& problem : impl_->programs->reload()) {
        impl_->messages.push_back(std::move(problem));
    }
    if (impl_->programs->generation() == before) return;
    impl_->medium.invalidate();
    *impl_->noise = {};
}

}  // namespace neph::render
