// direction_sweep.cpp: slices in their order, filled with sources and collected into moments.
#include "core/transport/direction_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace neph {

template <bool kThick>
DirectionSweep<kThick>::DirectionSweep(const SweepInput& input, const LightDirection& direction,
                                       const DirectionValues& values, SweptEnds& ends)
    : input_(input),
      level_(*input.level),
      grid_(level_.grid),
      values_(values),
      ends_(ends),
      travel_(direction.travel),
      weight_(static_cast<float>(direction.weightSr)) {
    const glm::vec3 perNode = glm::abs(travel_) / glm::vec3(grid_.spacingM);
    for (int axis = 1; axis < 3; ++axis) {
        if (perNode[axis] > perNode[axis_]) axis_ = axis;
    }
    axisB_ = sliceAxes(axis_)[0];
    axisC_ = sliceAxes(axis_)[1];
    step_ = grid_.steps();
    lengthM_ = 1.0f / perNode[axis_];
    const glm::vec3 offset = -travel_ / glm::vec3(grid_.spacingM) * lengthM_;
    offsetB_ = offset[axisB_];
    offsetC_ = offset[axisC_];
    taps_ = SliceTaps(offsetB_, offsetC_);
    midTaps_ = SliceTaps(offsetB_ / 2.0f, offsetC_ / 2.0f);
    shape_ = {grid_.nodes[axisB_], grid_.nodes[axisC_], grid_.periodic(axisB_),
              grid_.periodic(axisC_)};
    inflow_ = travel_.z < 0.0f ? static_cast<float>(input.sky.radianceAt(-direction.travel))
                               : input.farGroundRadiance;
    prepare();
}

template <bool kThick>
void DirectionSweep<kThick>::prepare() {
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

/// Fills a slice but for its radiance.
template <bool kThick>
void DirectionSweep<kThick>::load(int slice, LightSlice& into) const {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    std::vector<std::vector<float>*> cleared{&into.emission, &into.extinction};
    if (kThick) cleared.insert(cleared.end(), {&into.source, &into.hold, &into.held});
    for (int c = 0; c < shape_.nc; ++c) {
        const auto first = static_cast<std::size_t>(shape_.at(0, c));
        const auto row = static_cast<std::size_t>(c + kSliceBorder);
        const RowSpan active = level_.activeRow(axis_, slice, c);
        into.filled[row] = {};
        if (kThick) into.balanced[row] = {};
        for (auto* values : cleared) std::fill_n(&(*values)[first], shape_.nb, 0.0f);
        std::size_t node = nodeAt(slice, c) + static_cast<std::size_t>(active.from) * stepB;
        for (int b = active.from; b < active.to; ++b, node += stepB) {
            const float extinction = level_.extinctionPerM[node];
            const auto at = first + static_cast<std::size_t>(b);
            if (extinction > 0.0f) into.filled[row].include(b);
            const std::int32_t place = level_.place[node];
            const float source = place < 0 ? 0.0f : values_.along[place];
            into.extinction[at] = extinction;
            into.emission[at] = extinction * source;
            if (!kThick) continue;
            into.source[at] = source;
            into.hold[at] = holdOf(level_.weightAt(node) * lengthM_);
            into.held[at] = place < 0 ? 0.0f : into.hold[at] * values_.even[place];
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
template <bool kThick>
void DirectionSweep<kThick>::enter(int slice) {
    for (int c = 0; c < shape_.nc; ++c) setBoundaries(slice, c, {});
}

template <bool kThick>
void DirectionSweep<kThick>::advance(int step, bool keep) {
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

template <bool kThick>
void DirectionSweep<kThick>::collect(int slice) {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    for (int c = 0; c < shape_.nc; ++c) {
        const float* radiance = &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))];
        const std::size_t first = nodeAt(slice, c);
        if (travel_.z < 0.0f && onGround(slice, c)) {
            // The plane of the ground comes first among nodes: a node is its column there.
            for (int b = 0; b < shape_.nb; ++b) {
                ends_.groundFlux[first + static_cast<std::size_t>(b) * stepB] +=
                    weight_ * -travel_.z * radiance[b];
            }
        }
        const RowSpan active = level_.activeRow(axis_, slice, c);
        std::size_t node = first + static_cast<std::size_t>(active.from) * stepB;
        for (int b = active.from; b < active.to; ++b, node += stepB) {
            const std::int32_t place = level_.place[node];
            if (place >= 0) values_.along[place] = radiance[b];
        }
    }
}

/// Of a slice that the one behind it has been fed from.
template <bool kThick>
void DirectionSweep<kThick>::collectBalance(int slice, LightSlice& from) {
    shape_.foldBorder(from.excess);
    shape_.foldBorder(from.exchange);
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    const float perM = weight_ / lengthM_;
    for (int c = 0; c < shape_.nc; ++c) {
        const RowSpan active = level_.activeRow(axis_, slice, c);
        auto at = static_cast<std::size_t>(shape_.at(active.from, c));
        std::size_t node = nodeAt(slice, c) + static_cast<std::size_t>(active.from) * stepB;
        for (int b = active.from; b < active.to; ++b, node += stepB, ++at) {
            if (level_.balanced[node] <= 0.0f) continue;
            const auto place = static_cast<std::size_t>(level_.place[node]);
            ends_.excess[place] += perM * from.excess[at];
            ends_.exchange[place] += perM * from.exchange[at];
        }
    }
}

/// Goes round between periodic sides until what enters is what leaves.
template <bool kThick>
void DirectionSweep<kThick>::settle() {
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

template <bool kThick>
void DirectionSweep<kThick>::run() {
    const int slices = grid_.nodes[axis_];
    if (grid_.periodic(axis_)) {
        settle();
        for (auto* values : {&before_.excess, &before_.exchange}) std::ranges::fill(*values, 0.0f);
    }
    for (int step = 0; step < slices; ++step) advance(step, true);
    if (kThick) collectBalance(sliceAt(slices - 1), before_);
}

template class DirectionSweep<false>;
template class DirectionSweep<true>;

}  // namespace neph
