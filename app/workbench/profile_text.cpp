// profile_text.cpp: rows and lines of a profile.
#include "app/workbench/profile_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/look/known_error.h"

namespace neph {
namespace {

using ui::ProfileRow;

constexpr std::array<std::string_view, 5> kStages{"data", "medium", "light", "eye", "resolve"};

/// The stage and all that follow from it.
std::string redoneText(const render::FrameStats& stats) {
    const auto first = static_cast<std::size_t>(stats.redone);
    return fmt::format("{}", fmt::join(kStages.begin() + first, kStages.end(), " > "));
}

/// Three digits and more: 812, 23.40 k, 4.10 M.
std::string countText(std::uint64_t count) {
    if (count < 1000) return fmt::format("{}", count);
    const auto number = static_cast<double>(count);
    if (number < 1e6) return fmt::format("{:.2f} k", number * 1e-3);
    if (number < 1e9) return fmt::format("{:.2f} M", number * 1e-6);
    return fmt::format("{:.2f} G", number * 1e-9);
}

std::string mebibytes(std::size_t bytes) {
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1U << 20U));
}

/// Shares are of the frame: what is missing from the whole is the processor's.
std::vector<ProfileRow> passRows(const render::FrameStats& stats) {
    std::vector<ProfileRow> rows;
    for (const auto& [name, milliseconds] : stats.passes) {
        const double share = std::min(1.0, milliseconds / std::max(stats.milliseconds, 1e-3));
        rows.push_back({std::string(name), fmt::format("{:.2f} ms", milliseconds),
                        fmt::format("{:.0f} %", 100.0 * share), share});
    }
    return rows;
}

std::vector<ProfileRow> sampleRows(const render::SampleCounts& counts) {
    const double rays = static_cast<double>(std::max<std::uint64_t>(1, counts.rays));
    const auto aRay = [&](std::uint64_t count) { return static_cast<double>(count) / rays; };
    return {
        {"rays", countText(counts.rays), ""},
        {"samples", countText(counts.taken), fmt::format("{:.1f} per ray", aRay(counts.taken))},
        {"skipped", countText(counts.skipped), fmt::format("{:.1f} per ray", aRay(counts.skipped))},
        {"terminated", countText(counts.terminated),
         fmt::format("{:.0f} % of rays", 100.0 * aRay(counts.terminated))}};
}

std::vector<ProfileRow> pathRows(const ReferenceProgress& traced, glm::ivec2 sizePx) {
    const double paths = 1.0 * traced.samples * sizePx.x * sizePx.y;
    const auto aPath = [&](std::uint64_t count) {
        return fmt::format("{:.1f} a path", static_cast<double>(count) / std::max(1.0, paths));
    };
    const double aSecond = paths / std::max(traced.seconds, 1e-6);
    return {{"paths", countText(static_cast<std::uint64_t>(paths)),
             countText(static_cast<std::uint64_t>(aSecond)) + "/s"},
            {"scatterings", countText(traced.scatterings), aPath(traced.scatterings)},
            {"collisions", countText(traced.collisions), aPath(traced.collisions)}};
}

/// The voxels in which light is solved, and how far it has come.
std::vector<ProfileRow> lightRows(const LightProgress& light) {
    const auto& m = light.voxelM;
    return {{"under-resolved", fmt::format("{:.0f} %", 100.0 * light.underResolved),
             "of caught sunlight"},
            {"light voxels",
             fmt::format("{} x {} x {}", light.voxels.x, light.voxels.y, light.voxels.z),
             fmt::format("{:.0f} x {:.0f} x {:.0f} m", m.x, m.y, m.z)},
            {"light", fmt::format("{} cycles", light.cycles),
             light.chance < 0.0 ? std::string()
                                : fmt::format("+- {:.1f} % by chance", 100.0 * light.chance)}};
}

std::vector<ProfileRow> memoryRows(const render::Renderer& renderer) {
    std::vector<ProfileRow> rows{{"GPU memory", mebibytes(renderer.gpuBytes()), ""}};
    for (const render::MemoryUse& part : renderer.memory()) {
        rows.push_back({fmt::format("  {}", part.name), mebibytes(part.bytes), ""});
    }
    return rows;
}

}  // namespace

ui::Profile profileOf(const render::FrameStats& stats, const render::FrameInputs& inputs,
                      const render::Renderer& renderer) {
    const EngineTraits& traits = traitsOf(inputs.look.engine);
    const bool converges = traits.refinement == Refinement::converges;
    ui::Profile profile;
    profile.engine = traits.label;
    profile.device = renderer.deviceName();
    profile.image = {{"image", fmt::format("{} x {} px", inputs.sizePx.x, inputs.sizePx.y),
                      converges ? fmt::format("{} per pixel", stats.reference.samples)
                                : countText(stats.planes, traits.unit)},
                     {"frame", fmt::format("{:.2f} ms", stats.milliseconds),
                      fmt::format("{:.1f} fps", 1000.0 / std::max(stats.milliseconds, 1e-3))}};
    if (stats.light) {
        for (ProfileRow& row : lightRows(*stats.light)) profile.image.push_back(std::move(row));
    }
    profile.error = knownErrorText(inputs.look);
    profile.passes = passRows(stats);
    if (stats.samples) profile.samples = sampleRows(*stats.samples);
    if (converges) profile.samples = pathRows(stats.reference, inputs.sizePx * inputs.supersample);
    profile.memory = memoryRows(renderer);
    profile.redone = redoneText(stats);
    return profile;
}

std::string profileText(const ui::Profile& profile) {
    std::string text = fmt::format("  {:<16}{}\n", "engine", profile.engine);
    text += fmt::format("  {:<16}{}\n", "device", profile.device);
    if (!profile.error.empty()) text += fmt::format("  {:<16}{}\n", "error", profile.error);
    for (const auto* rows : {&profile.image, &profile.passes, &profile.samples, &profile.memory}) {
        for (const ProfileRow& row : *rows) {
            const std::string line =
                fmt::format("  {:<16}{:>14}  {:>16}", row.label, row.value, row.note);
            text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
        }
    }
    return text + fmt::format("  {:<16}{}\n", "redone", profile.redone);
}

void addSample(render::FrameStats& all, const render::FrameStats& sample) {
    all.milliseconds += sample.milliseconds;
    if (sample.samples) {
        if (!all.samples) all.samples.emplace();
        all.samples->rays += sample.samples->rays;
        all.samples->taken += sample.samples->taken;
        all.samples->skipped += sample.samples->skipped;
        all.samples->terminated += sample.samples->terminated;
    }
    for (const render::PassTime& pass : sample.passes) {
        const auto same = std::find_if(all.passes.begin(), all.passes.end(),
                                       [&](const auto& known) { return known.name == pass.name; });
        if (same == all.passes.end()) {
            all.passes.push_back(pass);
        } else {
            same->milliseconds += pass.milliseconds;
        }
    }
}

}  // namespace neph
