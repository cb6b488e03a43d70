// engines.h: what the program needs to know of each engine, without its name.
//
// Nothing outside engine_rows.inc, the engines' folders and tests names an engine: whoever treats
// engines differently asks for the trait that makes the difference.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace neph {

enum class Engine : int {
#define NEPH_ENGINE(name, ...) name,
#include "core/look/engine_rows.inc"
};

/// What further frames of the same image bring.
enum class Refinement {
    once,       ///< nothing: the first is the image
    averages,   ///< less grain; after some there is nothing to be seen
    converges,  ///< a smaller error, until it is small enough; the first alone is noise
};

/// Which parameter says how finely the medium is sampled, and is lowered in motion.
enum class Fineness { none, stepsPerVoxel, planes };

struct EngineTraits {
    Engine engine{};
    std::string_view id;     ///< in JSON, --set and the status line
    std::string_view label;  ///< on screen
    std::string_view help;   ///< one line
    Refinement refinement = Refinement::once;
    int samples = 1;  ///< of an image unless the user says otherwise; not of what converges
    Fineness fineness = Fineness::none;
    std::string_view unit;     ///< what its work is counted in, singular: "step"
    double leastDetail = 0.0;  ///< least share of full fineness in motion
    /// A moved camera needs other light.
    bool lightFollowsCamera = false;
    /// Light is scattered once, and parameters make it look like more: forward shares, skylight,
    /// phase display.
    bool singleScattering = false;
    bool scattersOften = false;  ///< knows Transport::full
    bool printedLight = false;   ///< knows Eq. 14-17 as [Riley03] prints them
    bool periodicSides = false;  ///< knows DomainSides::periodic
    bool groundTruth = false;    ///< what other engines are compared with; true of one
    bool layers = false;         ///< knows an image's variance, transmittance and depths
};

inline constexpr std::array kEngines{
#define NEPH_ENGINE(name, ...) EngineTraits{.engine = Engine::name, .id = #name, __VA_ARGS__},
#include "core/look/engine_rows.inc"
};
inline constexpr std::size_t kEngineCount = kEngines.size();

constexpr const EngineTraits& traitsOf(Engine engine) {
    return kEngines[static_cast<std::size_t>(engine)];
}

/// One trait of every engine, in the order of the enumerators.
template <typename T>
constexpr std::array<T, kEngineCount> eachEngine(T EngineTraits::*trait) {
    std::array<T, kEngineCount> values{};
    for (std::size_t i = 0; i < kEngineCount; ++i) values[i] = kEngines[i].*trait;
    return values;
}

/// Engines as a set of bits.
constexpr unsigned bitOf(Engine engine) {
    return 1u << static_cast<unsigned>(engine);
}
inline constexpr unsigned kAllEngines = (1u << kEngineCount) - 1u;

/// Those of which a trait has this value.
template <typename T>
constexpr unsigned enginesWith(T EngineTraits::*trait, T value) {
    unsigned bits = 0;
    for (const EngineTraits& engine : kEngines) {
        if (engine.*trait == value) bits |= bitOf(engine.engine);
    }
    return bits;
}

/// The engine that others are compared with.
constexpr Engine groundTruth() {
    return std::find_if(kEngines.begin(), kEngines.end(),
                        [](const EngineTraits& engine) { return engine.groundTruth; })
        ->engine;
}

/// "1 step", "512 steps".
std::string countText(int count, std::string_view unit);

}  // namespace neph
