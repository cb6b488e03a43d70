// light_work.h: solves the light of a medium in the background, and shows how far it has come.
//
// The newest request wins; between two cycles the worker takes over what was asked meanwhile.
#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/base/progress.h"
#include "core/transport/light_around.h"
#include "core/transport/light_solver.h"

namespace neph {

struct LightRequest {
    std::shared_ptr<const LightMedium> medium;  ///< another object is another medium
    glm::dvec3 towardsSun{0.0, 0.0, 1.0};
    double groundAlbedo = 0.0;
    bool groundHidden = false;                 ///< the sky's horizon shines from below instead
    std::shared_ptr<const SkyDome> dome = {};  ///< of an atmosphere; none: a gradient
    double lowestM = 0.0;                      ///< altitude of the lowest nodes
    bool periodicSides = false;
    /// May start from the light that is there, which is quicker; else the outcome depends on
    /// nothing that was asked before.
    bool warm = false;
    bool operator==(const LightRequest&) const = default;
};

/// Sources of light whose fields add up: the sun with irradiance 1, or as bright as the dome has
/// it, and two parts of the sky, with radiance 1 at the horizon falling to 0 in the zenith, and the
/// other way round, or the patterns of the dome.
enum class LightPart : int { sun, horizon, zenith };
inline constexpr std::size_t kLightParts = 3;

/// The light at one moment of the work.
struct LightState {
    LightRequest request;  ///< that it answers
    glm::ivec3 size{0};    ///< nodes along each axis: fewer than the medium's at first
    glm::dvec3 spacingM{0.0};
    int cycles = 0;                                              ///< done, of the sun's field
    bool settled = false;                                        ///< it gets no better
    double remaining = 1.0, chance = -1.0, underResolved = 0.0;  ///< of the sun, as LightSolver
    std::vector<std::uint32_t> nodes;  ///< that are active, by their index, x fastest
    /// Source function at these nodes, of each part: kAlignedMoments side by side of the sun, else
    /// kBroadMoments. core/transport/source_moments.h
    std::array<std::vector<float>, kLightParts> source;
    /// Albedo of each degree times the balanced share of these nodes, kAlignedDegrees side by side;
    /// empty where none is balanced. core/transport/source_moments.h
    std::vector<float> balanced;
    /// Downward irradiance at the ground of each part, without the beam, x fastest.
    std::array<std::vector<float>, kLightParts> groundFlux;
    /// Of each part: of the settled field, or of one before.
    std::shared_ptr<const std::array<LightAround, kLightParts>> around;
    std::size_t bytes = 0;  ///< that the solvers hold
};

class LightWork {
  public:
    /// `wake`, if given, is called on the worker when there is a new state.
    explicit LightWork(std::function<void()> wake = {});
    ~LightWork();
    LightWork(const LightWork&) = delete;
    LightWork& operator=(const LightWork&) = delete;

    void ask(const LightRequest& request);
    /// The newest; null before the first. Throws Error where the work needs more memory than there
    /// is, as does wait().
    std::shared_ptr<const LightState> latest() const;
    /// Waits for a state of the newest request, or for the settled one. Throws Cancelled.
    std::shared_ptr<const LightState> wait(bool settled, const Progress& progress) const;

  private:
    struct Solution;
    void run(const std::stop_token& stop);
    void step(std::unique_ptr<Solution>& solution, const std::optional<LightRequest>& asked);
    std::unique_ptr<Solution> coarseStart(const LightRequest& request);
    std::unique_ptr<Solution> solutionFor(const LightRequest& request,
                                          std::unique_ptr<Solution> before);
    bool isNewest(const LightRequest& request) const;
    std::optional<LightRequest> take(bool idle, const std::stop_token& stop);
    void publish(std::shared_ptr<const LightState> state);
    void checkMemory() const;

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<LightRequest> asked_;
    bool taken_ = true;         ///< by the worker
    bool outOfMemory_ = false;  ///< at what was asked
    std::shared_ptr<const LightState> latest_;
    std::jthread worker_;  // last, so that it ends before the members it uses
};

}  // namespace neph
