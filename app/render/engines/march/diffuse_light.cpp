// diffuse_light.cpp: between the GPU's medium and the solver's.
#include "app/render/engines/march/diffuse_light.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/base/parallel.h"
#include "core/look/sun.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph::render {

#include "shaders/shared/light_layout.glsl"
#include "shaders/shared/march_layout.glsl"

namespace {

static_assert(kSunMoments == kAlignedMoments && kSkyMoments == kBroadMoments &&
              kBalancedDegrees == kAlignedDegrees);

constexpr std::size_t kMostPackers = 4;
constexpr std::size_t kMostPhases = 64;  // that are kept, while sliders change them

float luminanceOf(const glm::vec3& colour) {
    return glm::dot(colour, glsl::kLuminance);
}

/// Irradiance of full light, of which the look has the radiance of the ground.
constexpr double kFullLight = 4.0 * std::numbers::pi;

/// Light of the sky's horizon and zenith, if their radiance is 1, on open ground.
double farLight(LightPart part) {
    return SkyLight{part == LightPart::zenith ? 1.0 : 0.0, part == LightPart::horizon ? 1.0 : 0.0}
               .irradiance() /
           kFullLight;
}

/// Light that scatters in the class's forward peak; ClassBlock::forward.
glm::vec4 forwardOf(const LightClass& light) {
    const auto share = [&](double thickness) {
        return static_cast<float>(light.singleScattering * forwardShare(light, true, thickness));
    };
    return {share(0.0), share(1.0), share(2.0), 0.0f};
}

/// Two values in a word.
std::uint32_t pairOf(float low, float high) {
    return static_cast<std::uint32_t>(imath_float_to_half(low)) |
           static_cast<std::uint32_t>(imath_float_to_half(high)) << 16u;
}

void packPairs(const float* values, int count, std::uint32_t* words) {
    for (int i = 0; i < count; i += 2) {
        words[i / 2] = pairOf(values[i], i + 1 < count ? values[i + 1] : 0.0f);
    }
}

/// The words of source_to_eye.comp.
std::vector<std::uint32_t> wordsOf(const LightState& state) {
    constexpr auto kSun = static_cast<std::size_t>(kSunMoments);
    constexpr auto kSky = static_cast<std::size_t>(kSkyMoments);
    constexpr std::size_t kChunk = 4096;
    std::vector<std::uint32_t> words(state.nodes.size() * kWordsOfNode);
    const std::vector<float>& sun = state.source[0];
    const std::vector<float>&horizon = state.source[1], &zenith = state.source[2];
    shareOut((state.nodes.size() + kChunk - 1) / kChunk, workerCount(kMostPackers),
             [&](std::size_t chunk, std::size_t, const Progress&) {
                 const std::size_t end = std::min((chunk + 1) * kChunk, state.nodes.size());
                 for (std::size_t i = chunk * kChunk; i < end; ++i) {
                     std::uint32_t* to = &words[i * kWordsOfNode];
                     packPairs(&sun[i * kSun], kSunMoments, to);
                     std::array<float, 2 * kSky> sky{};
                     std::copy_n(&horizon[i * kSky], kSky, sky.begin());
                     std::copy_n(&zenith[i * kSky], kSky, sky.begin() + kSky);
                     packPairs(sky.data(), 2 * kSkyMoments, to + kWordsOfSun);
                 }
             });
    return words;
}

int mostTexels() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
    return most;
}

gl::Texture makeLinear(GLenum format, glm::ivec3 size) {
    gl::Texture texture = gl::Texture::make3D(format, size);
    texture.setLinear();
    return texture;
}

/// The values of nodes, x fastest, with so many of the opposite side beside them along each axis.
template <typename Value>
std::vector<Value> withRepeated(const std::vector<Value>& values, glm::ivec3 nodes,
                                glm::ivec3 beside) {
    if (beside == glm::ivec3(0)) return values;
    const glm::ivec3 held = nodes + 2 * beside;
    std::vector<Value> all;
    all.reserve(static_cast<std::size_t>(held.x) * static_cast<std::size_t>(held.y) *
                static_cast<std::size_t>(held.z));
    for (int z = 0; z < held.z; ++z)
        for (int y = 0; y < held.y; ++y)
            for (int x = 0; x < held.x; ++x) {
                const glm::ivec3 at = (glm::ivec3(x, y, z) - beside + nodes) % nodes;
                all.push_back(values[static_cast<std::size_t>(at.x) +
                                     static_cast<std::size_t>(nodes.x) *
                                         static_cast<std::size_t>(at.y + nodes.y * at.z)]);
            }
    return all;
}

}  // namespace

LightClass DiffuseLight::lightClassOf(const MediumClass& c) {
    LightClass light;
    light.singleScattering = std::min(1.0, static_cast<double>(c.albedo * luminanceOf(c.colour)));
    const auto met =
        std::ranges::find(phases_, c.phase, &std::pair<PhaseSpec, PhaseMoments>::first);
    if (met != phases_.end()) {
        light.moments = met->second;
        return light;
    }
    const PhaseTable table = makePhaseTable(c.phase);
    light.moments = phaseMomentsOf([&](float cosTheta) { return lookUp(table, cosTheta).g; });
    phases_.emplace_back(c.phase, light.moments);
    return light;
}

void DiffuseLight::takeMedium(const FrameInputs& inputs, const RegularGrid& grid,
                              const PackedMedium& medium, const gl::Program& nodes) {
    const BoxM whole{glm::dvec3(0.0), grid.extentM()};
    seaLevelM_ = grid.originM.z;
    const BoxM occupied = medium.bricks.empty() ? whole : medium.bricks.occupied;
    grid_ = chooseLightGrid(grid, occupied, inputs.sampling.lightVoxels, sidesRepeat(inputs.look));
    // Layers of moments lie upon one another.
    for (int most = inputs.sampling.lightVoxels;
         grid_.periodicSides && grid_.nodes.z * kMomentLayers > mostTexels(); most /= 2) {
        grid_ = chooseLightGrid(grid, occupied, most / 2, true);
    }
    auto made = std::make_shared<LightMedium>();
    made->nodes = grid_.nodes;
    made->spacingM = grid_.spacingM;
    for (const MediumClass& c : medium.plan.classes) made->classes.push_back(lightClassOf(c));
    if (phases_.size() > kMostPhases) phases_.clear();
    const Array3f empty(grid_.nodes, 0.0f);
    std::vector<float> values(std::max<std::size_t>(made->classes.size(), 1) * empty.values.size());
    extinctions_.write(values.data(), values.size() * sizeof(float));
    extinctions_.bind(GL_SHADER_STORAGE_BUFFER, kNodesExtinctionBuffer);
    nodes.setVec3(kNodesFirstVoxelLocation, glm::vec3(grid_.lowerM / grid.spacingM));
    nodes.setVec3(kNodesSpacingLocation, glm::vec3(grid_.spacingM / grid.spacingM));
    nodes.setIvec3(kNodesSamplesLocation, grid_.stride);
    nodes.setIvec3(kNodesCountLocation, grid_.nodes);
    nodes.dispatch(grid_.nodes);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(extinctions_.name(), 0,
                            static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data());
    for (std::size_t c = 0; c < made->classes.size(); ++c) {
        const std::size_t count = empty.values.size();
        made->classes[c].extinctionPerM = empty;
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(c * count), count,
                    made->classes[c].extinctionPerM.values.begin());
    }
    uploadThickness(nodeThickness(*made, grid_.periodicSides, true));
    const bool same = medium_ && asked_.periodicSides == grid_.periodicSides && *medium_ == *made;
    if (!same) medium_ = std::move(made);
    asked_.periodicSides = grid_.periodicSides;
}

void DiffuseLight::uploadThickness(const std::vector<float>& ofNodes) {
    std::vector<std::uint8_t> thickness;
    thickness.reserve(ofNodes.size());
    for (const float thick : ofNodes) {
        thickness.push_back(static_cast<std::uint8_t>(std::lround(127.5f * thick)));
    }
    const glm::ivec3 held = grid_.held();
    if (thickness_.size() != held) thickness_ = makeLinear(GL_R8, held);
    thickness_.upload(GL_RED, GL_UNSIGNED_BYTE,
                      withRepeated(thickness, grid_.nodes, grid_.repeated()).data());
}

void DiffuseLight::fill(FrameBlock& block, const Look& look,
                        const std::vector<MediumClass>& classes, const SkyTextures& sky) {
    const auto setMap = [](const LightGrid& grid, glm::vec4& perM, glm::vec4& offset) {
        const glm::dvec3 held(grid.held()), ofTexture = 1.0 / (held * grid.spacingM);
        perM = glm::vec4(ofTexture, 0.0);
        offset =
            glm::vec4((0.5 + glm::dvec3(grid.repeated())) / held - grid.lowerM * ofTexture, 0.0);
    };
    setMap(grid_, block.lightPerM, block.lightOffset);
    setMap(shownGrid_, block.sourcePerM, block.sourceOffset);
    glm::dvec3 far = farLight(LightPart::horizon) * glm::dvec3(block.skyHorizon) +
                     farLight(LightPart::zenith) * glm::dvec3(block.skyZenith);
    if (sky.hasAir()) far = sky.tables().skyOnGround * static_cast<double>(shownIntensity(look));
    block.farGround = glm::vec4(look.groundVisible ? far : glm::dvec3(0.0), 0.0);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        block.classes[i].forward = forwardOf(lightClassOf(classes[i]));
    }
}

void DiffuseLight::update(const Look& look, const SkyTextures& sky, bool settled,
                          const Progress& progress) {
    LightRequest& request = asked_;
    request.medium = medium_;
    request.warm = !settled;
    request.towardsSun = sunDirWorld(look);
    request.groundAlbedo = static_cast<double>(luminanceOf(groundAlbedo(look)));
    request.groundHidden = !look.groundVisible;
    request.dome = sky.hasAir() ? sky.tables().dome : nullptr;
    request.lowestM = seaLevelM_ + grid_.lowerM.z;
    work_.ask(request);
    // The light of a moment ago is better than none, if it is of the same voxels.
    const bool some = shown_ && wholeGrid_ == grid_;
    std::shared_ptr<const LightState> state =
        settled || !some ? work_.wait(settled, progress) : work_.latest();
    if (state && state != shown_ && state->request.medium == medium_) {
        wholeGrid_ = shownGrid_ = grid_;
        shownGrid_.nodes = state->size;
        shownGrid_.spacingM = state->spacingM;
        upload(*state);
        shown_ = std::move(state);
    }
}

bool DiffuseLight::hasNewer() const {
    const auto newest = work_.latest();
    return newest && newest != shown_ && newest->request.medium == medium_;
}

LightProgress DiffuseLight::progress() const {
    LightProgress progress{.voxels = grid_.nodes, .voxelM = grid_.spacingM};
    if (!shown_) return progress;
    progress.cycles = shown_->cycles;
    progress.settled = shown_->settled && shown_->request == asked_;
    progress.remaining = shown_->remaining;
    progress.chance = shown_->chance;
    progress.underResolved = shown_->underResolved;
    return progress;
}

void DiffuseLight::upload(const LightState& state) {
    const std::vector<std::uint32_t> words = wordsOf(state);
    constexpr std::uint32_t kNone = 0;  // a buffer that is bound must have a size
    const bool any = !words.empty();
    nodes_.write(any ? state.nodes.data() : &kNone,
                 any ? state.nodes.size() * sizeof(std::uint32_t) : sizeof(kNone));
    moments_.write(any ? words.data() : &kNone,
                   any ? words.size() * sizeof(std::uint32_t) : sizeof(kNone));
    std::vector<std::uint32_t> balanced(
        state.balanced.empty() ? 0 : state.nodes.size() * kWordsOfBalanced);
    for (std::size_t i = 0; i * kWordsOfBalanced < balanced.size(); ++i) {
        packPairs(&state.balanced[i * kBalancedDegrees], kBalancedDegrees,
                  &balanced[i * kWordsOfBalanced]);
    }
    if (!balanced.empty()) {
        balanced_.write(balanced.data(), balanced.size() * sizeof(std::uint32_t));
    }
    if (shownAround_ != state.around) uploadAround(*state.around);
    shownAround_ = state.around;
    glm::ivec3 held = shownGrid_.held();
    if (shownGrid_.periodicSides)
        held.z *= balanced.empty() ? kMomentLayersUnbalanced : kMomentLayers;
    if (source_.size() != held) source_ = makeLinear(GL_RGBA16F, held);
    hasMoments_ = false;
    // Other voxels may have been occupied before.
    glClearTexImage(source_.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

void DiffuseLight::uploadAround(const std::array<LightAround, kLightParts>& around) {
    std::vector<float> moments;
    const std::size_t nodes = around[0].grid.nodeCount();
    moments.reserve(nodes * kLightParts * kBroadMoments);
    for (std::size_t node = 0; node < nodes; ++node) {
        for (const LightAround& part : around) {
            const float* from = &part.change[node * kBroadMoments];
            moments.insert(moments.end(), from, from + kBroadMoments);
        }
    }
    aroundMoments_.write(moments.data(), moments.size() * sizeof(float));
    glm::ivec3 size = around[0].grid.nodes;
    if (shownGrid_.periodicSides) size.z *= kAroundLayers;
    if (aroundMolecules_.size() != size) {
        aroundMolecules_ = makeLinear(GL_RGBA16F, size);
        aroundHaze_ = makeLinear(GL_RGBA16F, shownGrid_.periodicSides ? glm::ivec3(1) : size);
    }
    aroundMolecules_.setRepeatAcross(shownGrid_.periodicSides);
}

void DiffuseLight::placeAround(const gl::Program& program) const {
    program.setVec3(kAroundLowerLocation, glm::vec3(grid_.lowerM));
    program.setVec3(kAroundSpacingLocation, glm::vec3(shownAround_->front().grid.spacingM));
}

void DiffuseLight::lookAround(const gl::Program& program) {
    placeAround(program);
    aroundMoments_.bind(GL_SHADER_STORAGE_BUFFER, kAroundMomentsBuffer);
    aroundMolecules_.bindImage(kAroundMoleculesImage, GL_WRITE_ONLY);
    aroundHaze_.bindImage(kAroundHazeImage, GL_WRITE_ONLY);
    const auto nodes = static_cast<int>(shownAround_->front().grid.nodeCount());
    program.dispatchGroups((nodes + kSourceGroup - 1) / kSourceGroup);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void DiffuseLight::lookFrom(const FrameBlock& block, const SkyTextures& sky,
                            const gl::Program& sourceToEye) {
    lightGround(block, sky);
    const auto count = static_cast<int>(shown_->nodes.size());
    if (count == 0 || hasMoments_) return;
    hasMoments_ = shownGrid_.periodicSides;
    nodes_.bind(GL_SHADER_STORAGE_BUFFER, kSourceNodesBuffer);
    moments_.bind(GL_SHADER_STORAGE_BUFFER, kSourceMomentsBuffer);
    if (isBalanced()) balanced_.bind(GL_SHADER_STORAGE_BUFFER, kSourceBalancedBuffer);
    source_.bindImage(kSourceImage, GL_WRITE_ONLY);
    sourceToEye.setInt(kSourceCountLocation, count);
    sourceToEye.dispatchGroups((count + kSourceGroup - 1) / kSourceGroup);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Diffuse light that comes down to the ground, in the colours of the look.
void DiffuseLight::lightGround(const FrameBlock& block, const SkyTextures& sky) {
    const glm::ivec2 size(shownGrid_.held());
    const std::vector<float>& sun = shown_->groundFlux[0];
    const std::vector<float>&horizon = shown_->groundFlux[1], &zenith = shown_->groundFlux[2];
    std::vector<glm::vec4> light(sun.size());
    const auto perIrradiance = static_cast<float>(1.0 / kFullLight);
    glm::vec3 ofSun(block.sunRadiance);  // whose irradiance is full light
    glm::vec3 ofHorizon = perIrradiance * glm::vec3(block.skyHorizon);
    glm::vec3 ofZenith = perIrradiance * glm::vec3(block.skyZenith);
    if (sky.hasAir()) {
        // The field has the luminance already.
        const glm::vec3 sunColour = sky.sunOnGround();
        ofSun *= sunColour / std::max(luminanceOf(sunColour), 1e-12f);
        ofHorizon *= sky.patternOnGround(0);
        ofZenith *= sky.patternOnGround(1);
    }
    for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] = glm::vec4(sun[i] * ofSun + horizon[i] * ofHorizon + zenith[i] * ofZenith, 0.0f);
    }
    if (glm::ivec2(groundLight_.size()) != size) {
        groundLight_ = gl::Texture::make2D(GL_RGBA16F, size);
        groundLight_.setLinear();
    }
    const glm::ivec3 nodes{glm::ivec2(shownGrid_.nodes), 1};
    groundLight_.upload(GL_RGBA, GL_FLOAT,
                        withRepeated(light, nodes, shownGrid_.repeated()).data());
}

void DiffuseLight::bind() const {
    thickness_.bind(kMarchThicknessUnit);
    aroundMolecules_.bind(kAroundMoleculesUnit);
    aroundHaze_.bind(kAroundHazeUnit);
    source_.bind(kMarchSourceUnit);
    groundLight_.bind(kGroundLightUnit);
}

std::size_t DiffuseLight::bytes() const {
    return thickness_.bytes() + aroundMolecules_.bytes() + aroundHaze_.bytes() +
           aroundMoments_.bytes() + source_.bytes() + groundLight_.bytes() + extinctions_.bytes() +
           nodes_.bytes() + moments_.bytes() + balanced_.bytes();
}

}  // namespace neph::render
