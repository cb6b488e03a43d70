// direction_sweep.cpp: slices in their order, filled with sources and collected into moments.
#include "core/transport/direction_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace neph {

template <int kMoments, bool kThick>
DirectionSweep<kMoments, kThick>::DirectionSweep(const SweepInput& input,
                                                 const LightDirection& direction, Swept& sum)
    : input_(input),
      level_(*input.level),
      grid_(level_.grid),
      sum_(sum),
      travel_(direction.travel),
      weight_(static_cast<float>(direction.weightSr)) {
    const glm::vec3 perNode = glm::abs(travel_) / glm::vec3(grid_.spacingM);
    for (int axis = 1; axis < 3; ++axis) {
        if (perNode[axis] > perNode[axis_]) axis_ = axis;
    }
    axisB_ = axis_ == 0 ? 1 : 0;
    axisC_ = axis_ == 2 ? 1 : 2;
    step_ = {1, static_cast<std::size_t>(grid_.nodes.x), grid_.columnCount()};
    lengthM_ = 1.0f / perNode[axis_];
    const glm::vec3 offset = -travel_ / glm::vec3(grid_.spacingM) * lengthM_;
    offsetB_ = offset[axisB_];
    offsetC_ = offset[axisC_];
    taps_ = SliceTaps(offsetB_, offsetC_);
    midTaps_ = SliceTaps(offsetB_ / 2.0f, offsetC_ / 2.0f);
    shape_ = {grid_.nodes[axisB_], grid_.nodes[axisC_], grid_.periodic(axisB_),
              grid_.periodic(axisC_)};
    inflow_ = travel_.z < 0.0f ? static_cast<float>(input.sky.radianceAt(-direction.travel.z))
                               : input.farGroundRadiance;
    value_ = harmonicsAt(direction.travel, input.sunTravel);
    for (std::size_t q = 0; q < value_.size(); ++q) weighted_[q] = weight_ * value_[q];
    const auto legendre = legendreAt<kAlignedDegrees>(glm::dot(direction.travel, input.sunTravel));
    for (std::size_t l = 0; l < ofBeam_.size(); ++l) {
        ofBeam_[l] = static_cast<float>((2.0 * static_cast<double>(l) + 1.0) * legendre[l] /
                                        (4.0 * std::numbers::pi));
    }
    prepare();
}

template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::prepare() {
    for (LightSlice* slice : {&before_, &now_}) {
        slice->filled.resize(static_cast<std::size_t>(shape_.nc + 2 * kSliceBorder));
        for (auto* values : {&slice->radiance, &slice->emission, &slice->extinction}) {
            values->assign(shape_.size(), 0.0f);
        }
        if (!kThick) continue;
        slice->balanced.resize(slice->filled.size());
        for (auto* values : {&slice->source, &slice->hold, &slice->held, &slice->hold, &slice->held,
                             &slice->smooth, &slice->excess, &slice->exchange}) {
            values->assign(shape_.size(), 0.0f);
        }
    }
    const auto n = static_cast<std::size_t>(shape_.nb);
    for (auto* row : {&rows_.radiance, &rows_.source, &rows_.hold, &rows_.held, &rows_.emission,
                      &rows_.extinction, &rows_.midEmission, &rows_.midExtinction, &rows_.scratch,
                      &rows_.depth}) {
        row->assign(n, 0.0f);
    }
    if (kThick) rows_.shares = SegmentShares(n);
}

/// Of degrees that are the same in the opposite direction, and of those that change their sign.
template <int kMoments, bool kThick>
std::array<float, 2> DirectionSweep<kMoments, kThick>::sourceOf(std::size_t node,
                                                                std::size_t place) const {
    const float* m = &input_.field->moments[place * kMoments];
    const float* albedo = &level_.albedo[place * kDegrees];
    const float beam = input_.beam != nullptr ? input_.beam[node] : 0.0f;
    const Harmonics& y = value_;
    std::array<float, 2> sum{
        albedo[0] * (m[0] * y[0] + beam * ofBeam_[0]) +
            albedo[2] * (m[4] * y[4] + m[5] * y[5] + m[6] * y[6] + m[7] * y[7] + m[8] * y[8] +
                         beam * ofBeam_[2]),
        albedo[1] * (m[1] * y[1] + m[2] * y[2] + m[3] * y[3] + beam * ofBeam_[1])};
    for (std::size_t l = kBroadDegrees; l < kDegrees; ++l) {
        sum[l % 2] += albedo[l] * (m[l + 6] * y[l + 6] + beam * ofBeam_[l]);
    }
    return sum;
}

/// Fills a slice but for its radiance.
template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::load(int slice, LightSlice& into) const {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    for (int c = 0; c < shape_.nc; ++c) {
        const auto first = static_cast<std::size_t>(shape_.at(0, c));
        const auto row = static_cast<std::size_t>(c + kSliceBorder);
        std::size_t node = nodeAt(slice, c);
        into.filled[row] = {};
        if (kThick) into.balanced[row] = {};
        for (int b = 0; b < shape_.nb; ++b, node += stepB) {
            const float extinction = level_.extinctionPerM[node];
            const auto at = first + static_cast<std::size_t>(b);
            if (extinction > 0.0f) into.filled[row].include(b);
            float source = 0.0f, even = 0.0f;
            if (kThick ? level_.place[node] >= 0 : extinction > 0.0f) {
                const auto parts = sourceOf(node, static_cast<std::size_t>(level_.place[node]));
                source = parts[0] + parts[1];
                even = parts[0];
            }
            into.extinction[at] = extinction;
            into.emission[at] = extinction * source;
            if (!kThick) continue;
            into.source[at] = source;
            into.hold[at] = holdOf(level_.weightAt(node) * lengthM_);
            into.held[at] = into.hold[at] * even;
            if (level_.balanced[node] > 0.0f) into.balanced[row].include(b);
        }
    }
    shape_.fillBorder(into.emission);
    shape_.fillBorder(into.extinction);
    if (!kThick) return;
    shape_.fillBorder(into.source);
    shape_.fillBorder(into.hold);
    shape_.fillBorder(into.held);
    for (auto* values : {&into.excess, &into.exchange}) std::ranges::fill(*values, 0.0f);
    std::ranges::fill(into.smooth, 1.0f);
}

/// The first slice of a sweep, through which light enters.
template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::enter(int slice) {
    for (int c = 0; c < shape_.nc; ++c) setBoundaries(slice, c, {});
}

template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::advance(int step, bool keep) {
    const int slice = sliceAt(step);
    load(slice, now_);
    if (step == 0 && !grid_.periodic(axis_)) {
        enter(slice);
    } else {
        feed(slice, keep);
        const int last = grid_.nodes[axis_] - 1;
        if (kThick && keep) collectBalance(sliceAt(step == 0 ? last : step - 1), before_);
    }
    shape_.fillBorder(now_.radiance);
    if (kThick) shape_.fillBorder(now_.smooth);
    if (keep) collect(slice);
    std::swap(before_, now_);
}

template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::collect(int slice) {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    LightField& field = sum_.field;
    for (int c = 0; c < shape_.nc; ++c) {
        const float* radiance = &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))];
        const bool arrives = travel_.z < 0.0f && onGround(slice, c);
        std::size_t node = nodeAt(slice, c);
        for (int b = 0; b < shape_.nb; ++b, node += stepB) {
            // The plane of the ground comes first among nodes: node is the column there.
            if (arrives) field.groundFlux[node] += weight_ * -travel_.z * radiance[b];
            const std::int32_t place = level_.place[node];
            if (place < 0) continue;
            float* moments = &field.moments[static_cast<std::size_t>(place) * kMoments];
            for (std::size_t q = 0; q < kMoments; ++q) moments[q] += radiance[b] * weighted_[q];
        }
    }
}

/// Of a slice that the one behind it has been fed from.
template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::collectBalance(int slice, LightSlice& from) {
    shape_.foldBorder(from.excess);
    shape_.foldBorder(from.exchange);
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    const float perM = weight_ / lengthM_;
    for (int c = 0; c < shape_.nc; ++c) {
        auto at = static_cast<std::size_t>(shape_.at(0, c));
        std::size_t node = nodeAt(slice, c);
        for (int b = 0; b < shape_.nb; ++b, node += stepB, ++at) {
            if (level_.balanced[node] <= 0.0f) continue;
            const auto place = static_cast<std::size_t>(level_.place[node]);
            sum_.excess[place] += perM * from.excess[at];
            sum_.exchange[place] += perM * from.exchange[at];
        }
    }
}

/// Goes round between periodic sides until what enters is what leaves.
template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::settle() {
    constexpr int kMostLaps = 500;
    constexpr float kClose = 1e-4f;
    const int slices = grid_.nodes[axis_];
    load(sliceAt(slices - 1), before_);
    std::ranges::fill(before_.radiance, inflow_);
    for (int lap = 0; lap < kMostLaps; ++lap) {
        const std::vector<float> entered = before_.radiance;
        for (int step = 0; step < slices; ++step) advance(step, false);
        float change = 0.0f, most = 0.0f;
        for (std::size_t i = 0; i < entered.size(); ++i) {
            change = std::max(change, std::abs(before_.radiance[i] - entered[i]));
            most = std::max(most, std::abs(before_.radiance[i]));
        }
        if (change <= kClose * most) break;
    }
}

template <int kMoments, bool kThick>
void DirectionSweep<kMoments, kThick>::run() {
    const int slices = grid_.nodes[axis_];
    if (grid_.periodic(axis_)) {
        settle();
        for (auto* values : {&before_.excess, &before_.exchange}) std::ranges::fill(*values, 0.0f);
    }
    for (int step = 0; step < slices; ++step) advance(step, true);
    if (kThick) collectBalance(sliceAt(slices - 1), before_);
}

template class DirectionSweep<kBroadMoments, false>;
template class DirectionSweep<kBroadMoments, true>;
template class DirectionSweep<kAlignedMoments, false>;
template class DirectionSweep<kAlignedMoments, true>;

}  // namespace neph
