// scene_trials.cpp: turns the experiments of a scene file into detectors and quantities.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/validate/scene_file.h"
#include "core/base/error.h"
#include "core/base/names.h"

namespace neph::validate {
namespace {

using render::Detector;
using render::DetectorKind;
using render::MeterScene;

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMaxQuantities = 20000;

/// A part of the scene seen from above, and the suffix of the names of its quantities.
struct Footprint {
    glm::dvec2 lowerM{0.0}, upperM{0.0};
    std::string suffix;
};

std::string_view nameOf(Flux flux) {
    return kFluxNames[static_cast<std::size_t>(flux)];
}

BoxM between(const Footprint& part, double bottomM, double topM) {
    return {{part.lowerM, bottomM}, {part.upperM, topM}};
}

glm::dvec3 extentOf(const MeterScene& scene) {
    return glm::dvec3(scene.size) * scene.spacingM;
}

/// The whole scene, then each column, x fastest. Throws Error if there are too many.
std::vector<Footprint> footprints(const Experiment& experiment, const std::string& where) {
    const MeterScene& scene = experiment.scene;
    std::vector<Footprint> all{{{0.0, 0.0}, glm::dvec2(extentOf(scene)), ""}};
    if (!experiment.perColumn) return all;
    const int columns = scene.size.x * scene.size.y;
    const std::size_t each = experiment.fluxes.size() + experiment.views.size();
    if (static_cast<std::size_t>(columns) * each > kMaxQuantities) {
        throw Error({where, "has too many detectors",
                     fmt::format("{} columns, {} quantities of each", columns, each),
                     fmt::format("a product of at most {}", kMaxQuantities),
                     "leave out \"per_column\", or ask for fewer quantities"});
    }
    const glm::dvec2 step(scene.spacingM);
    for (int i = 0; i < columns; ++i) {
        const glm::dvec2 lower = glm::dvec2(i % scene.size.x, i / scene.size.x) * step;
        all.push_back({lower, lower + step, fmt::format("[{}]", i)});
    }
    return all;
}

/// Light incident on a horizontal plane above the scene: μ₀ F₀ + π L.
double incidentOn(const MeterScene& scene) {
    return scene.towardsSun.z * scene.sunIrradiance + kPi * scene.skyRadiance;
}

/// Builds the trial of one experiment, detector by detector.
class TrialMaker {
  public:
    TrialMaker(const SceneFile& file, const Experiment& experiment)
        : incident_(incidentOn(experiment.scene)), heightM_(extentOf(experiment.scene).z) {
        trial_.name = file.name;
        if (!experiment.name.empty()) trial_.name += ": " + experiment.name;
        trial_.source = file.source;
        trial_.quick = file.quick;
        trial_.scene = experiment.scene;
        trial_.scene.fields = file.fields;
    }

    void addFlux(Flux flux, const Footprint& part) {
        const double share = 1.0 / incident_;
        std::vector<Term> terms;
        if (flux == Flux::reflected || flux == Flux::balance) {
            terms.push_back({plane(DetectorKind::flux, part, heightM_, -1.0), share});
        }
        if (flux == Flux::transmitted || flux == Flux::balance) {
            // Light that the surface reflects is not lost to the scene.
            const double returned = trial_.scene.surfaceAlbedo.value_or(0.0);
            const double kept = flux == Flux::transmitted ? 1.0 : 1.0 - returned;
            terms.push_back({plane(DetectorKind::flux, part, 0.0, 1.0), share * kept});
        }
        if (flux == Flux::direct) {
            terms.push_back({plane(DetectorKind::flux, part, 0.0, 1.0), share});
        }
        if (flux == Flux::diffuse) {
            terms.push_back({plane(DetectorKind::diffuseFlux, part, 0.0, 1.0), share});
        }
        if (flux == Flux::absorbed || flux == Flux::balance) {
            trial_.detectors.push_back({DetectorKind::absorption, between(part, 0.0, heightM_)});
            terms.push_back({trial_.detectors.size() - 1, share * heightM_});
        }
        trial_.quantities.push_back(
            {std::string(nameOf(flux)) + part.suffix, std::move(terms), 0.0, {}});
    }

    void addView(const View& view, const Footprint& part) {
        const double zenith = glm::radians(view.zenithDeg), azimuth = glm::radians(view.azimuthDeg);
        const glm::dvec3 leaving{std::sin(zenith) * std::cos(azimuth),
                                 std::sin(zenith) * std::sin(azimuth),
                                 view.top ? std::cos(zenith) : -std::cos(zenith)};
        const double z = view.top ? heightM_ : 0.0;
        const Footprint whole = view.area ? Footprint{(*view.area)[0], (*view.area)[1], ""} : part;
        trial_.detectors.push_back({DetectorKind::radiance, between(whole, z, z), -leaving});
        trial_.quantities.push_back(
            {view.name + part.suffix, {{trial_.detectors.size() - 1, kPi / incident_}}, 0.0, {}});
    }

    Trial take() { return std::move(trial_); }
    Trial& trial() { return trial_; }

  private:
    /// Adds a horizontal plane that faces up or down; returns its index.
    std::size_t plane(DetectorKind kind, const Footprint& part, double z, double up) {
        trial_.detectors.push_back({kind, between(part, z, z), glm::dvec3(0.0, 0.0, up)});
        return trial_.detectors.size() - 1;
    }

    Trial trial_;
    double incident_ = 1.0, heightM_ = 0.0;
};

/// Where nothing scatters, all transmitted light is direct.
void makeAbsorbing(MeterScene& scene) {
    for (render::MeterField& field : scene.fields) field.albedo = 0.0;
    scene.skyRadiance = 0.0;
    scene.surfaceAlbedo.reset();
}

/// Assigns the expected values to the quantities of their names. Throws Error for an unknown name.
void attachExpected(std::vector<Trial>& trials, const Experiment& experiment,
                    const std::string& where) {
    std::vector<std::string_view> names;  // of the whole; columns have too many
    for (const Flux flux : experiment.fluxes) names.push_back(nameOf(flux));
    for (const View& view : experiment.views) names.push_back(view.name);
    for (const auto& [name, expected] : experiment.expected) {
        bool found = false;
        for (Trial& trial : trials) {
            for (Quantity& quantity : trial.quantities) {
                if (quantity.name != name) continue;
                quantity.expected = expected;
                found = true;
            }
        }
        if (found) continue;
        const std::string_view near = nearestName(name, names);
        throw Error({where, fmt::format("expects \"{}\", which no detector measures", name), "",
                     fmt::format("one of {}", fmt::join(names, ", ")),
                     near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)});
    }
}

}  // namespace

std::vector<Trial> trialsOf(const SceneFile& file, const std::string& where) {
    std::vector<Trial> all;
    for (const Experiment& experiment : file.experiments) {
        // Direct transmission is measured in a scene of its own, which absorbs all scattered light.
        const bool direct = std::ranges::count(experiment.fluxes, Flux::direct) > 0;
        std::vector<TrialMaker> makers(direct ? 2 : 1, TrialMaker(file, experiment));
        if (direct) makeAbsorbing(makers.back().trial().scene);
        for (const Footprint& part : footprints(experiment, where)) {
            for (const Flux flux : experiment.fluxes) {
                (flux == Flux::direct ? makers.back() : makers.front()).addFlux(flux, part);
            }
            for (const View& view : experiment.views) {
                if (view.area && !part.suffix.empty()) continue;  // not of a column
                makers.front().addView(view, part);
            }
        }
        std::vector<Trial> trials;
        for (TrialMaker& maker : makers) {
            if (!maker.trial().quantities.empty()) trials.push_back(maker.take());
        }
        attachExpected(trials, experiment, where);
        std::ranges::move(trials, std::back_inserter(all));
    }
    return all;
}

}  // namespace neph::validate
