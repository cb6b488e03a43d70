// phase_texture.cpp: one table a row.
#include "app/render/medium/phase_texture.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/transport/forward_peak.h"
#include "core/transport/harmonics.h"

namespace neph::render {
namespace {

// Scattered forward once, twice, and more often, which is much like four times.
constexpr std::array kTimes{1.0, 2.0, 4.0};
static_assert(kPeakTimes == kTimes.size());
// Of the peaks in voxels of thickness 0, 1 and 2: forwardShare.
constexpr std::array kPeakDegrees{kAlignedDegrees, kBroadDegrees, 1};
constexpr std::size_t kMostPeaks = 32;  // that are kept, while sliders change them

void append(const PhaseTable& table, std::vector<glm::vec4>& values) {
    for (const glm::vec3& value : table) values.emplace_back(value, 0.0f);
}

}  // namespace

/// The rows after the first.
const std::vector<PhaseTable>& PhaseTexture::peaksOf(const PhaseTable& table) {
    const auto met = std::ranges::find(peaks_, table, [](const auto& each) { return each.first; });
    if (met != peaks_.end()) return met->second;
    if (peaks_.size() >= kMostPeaks) peaks_.clear();
    std::vector<PhaseTable> rows;
    for (const int degree : kPeakDegrees)
        std::ranges::move(neph::peaksOf(table, degree, kTimes), std::back_inserter(rows));
    return peaks_.emplace_back(table, std::move(rows)).second;
}

void PhaseTexture::update(const Look& look, const MediumPlan& plan) {
    const bool full = scattersOften(look);
    const bool same = filled_ && plan_ == plan && look_.phaseDisplay == look.phaseDisplay &&
                      scattersOften(look_) == full &&
                      look_.phaseTruncationDeg == look.phaseTruncationDeg;
    if (same) return;
    std::vector<glm::vec4> values;
    for (const PhaseTable& table : displayPhases(look, plan)) {
        append(table, values);
        if (!full) continue;
        for (const PhaseTable& peak : peaksOf(table)) append(peak, values);
    }
    if (values.empty()) values.resize(kPhaseTableSize);  // a sampler must have something bound
    const glm::ivec2 size{kPhaseTableSize, static_cast<int>(values.size()) / kPhaseTableSize};
    if (tables_.size() != glm::ivec3(size, 1)) tables_ = gl::Texture::make2D(GL_RGBA32F, size);
    tables_.upload(GL_RGBA, GL_FLOAT, values.data());
    look_ = look;
    plan_ = plan;
    filled_ = true;
}

}  // namespace neph::render
