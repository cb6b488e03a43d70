// direction_feed.cpp: a slice of nodes fed from the one before.
#include <algorithm>

#include "core/transport/direction_sweep.h"

namespace neph {

/// The nodes of a row that are fed from nodes of the slice before.
template <bool kThick>
RowSpan DirectionSweep<kThick>::fedSpan(int slice, int c) const {
    const auto outside = [](float at, int nodes) {
        return at < 0.0f || at > static_cast<float>(nodes - 1);
    };
    if (travel_.z > 0.0f && onGround(slice, c)) return {};
    if (!shape_.periodicC && outside(static_cast<float>(c) + offsetC_, shape_.nc)) return {};
    RowSpan span{0, shape_.nb};
    if (shape_.periodicB) return span;
    if (outside(offsetB_, shape_.nb)) span.from = 1;
    if (outside(static_cast<float>(shape_.nb - 1) + offsetB_, shape_.nb)) --span.to;
    return span;
}

/// Where segments that end in row `c` may meet what `spans` are spans of.
template <bool kThick>
RowSpan DirectionSweep<kThick>::spanAround(std::vector<RowSpan> LightSlice::*spans, int c) const {
    RowSpan span;
    for (int other = c - 1; other <= c + 1; ++other) {
        int row = std::clamp(other, 0, shape_.nc - 1);
        if (shape_.periodicC) row = (other + shape_.nc) % shape_.nc;
        for (const LightSlice* slice : {&before_, &now_}) {
            span.include((slice->*spans)[static_cast<std::size_t>(row + kSliceBorder)]);
        }
    }
    if (span.empty()) return span;
    const RowSpan whole{0, shape_.nb};
    return shape_.periodicB ? whole : RowSpan{span.from - 1, span.to + 1}.within(whole);
}

/// The radiance upwind of the nodes of a row.
template <bool kThick>
void DirectionSweep<kThick>::carry(int c, const RowSpan& fed) {
    const int stride = shape_.stride();
    const float* up = &before_.radiance[static_cast<std::size_t>(shape_.at(taps_.b, c + taps_.c))];
    float* radiance = &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))];
    RowSpan cubic;
    const bool inside = shape_.periodicC || (c + taps_.c >= 1 && c + taps_.c + 2 < shape_.nc);
    if (input_.cubic && inside) {
        cubic = shape_.periodicB ? fed : RowSpan{1 - taps_.b, shape_.nb - 2 - taps_.b}.within(fed);
    }
    if (cubic.empty()) cubic = {fed.from, fed.from};
    taps_.linearRow(up + fed.from, stride, cubic.from - fed.from, radiance + fed.from);
    taps_.cubicRow(up + cubic.from, stride, cubic.to - cubic.from, radiance + cubic.from);
    taps_.linearRow(up + cubic.to, stride, fed.to - cubic.to, radiance + cubic.to);
}

/// What else the nodes of row `c` see upwind of them.
template <bool kThick>
void DirectionSweep<kThick>::interpolate(int c, const RowSpan& span) {
    const int n = span.to - span.from, stride = shape_.stride();
    const auto at = static_cast<std::size_t>(shape_.at(taps_.b + span.from, c + taps_.c));
    const auto mid = static_cast<std::size_t>(shape_.at(midTaps_.b + span.from, c + midTaps_.c));
    taps_.linearRow(&before_.emission[at], stride, n, rows_.emission.data());
    taps_.linearRow(&before_.extinction[at], stride, n, rows_.extinction.data());
    const auto middle = [&](const std::vector<float>& before, const std::vector<float>& now,
                            std::vector<float>& out) {
        midTaps_.linearRow(&before[mid], stride, n, out.data());
        midTaps_.linearRow(&now[mid], stride, n, rows_.scratch.data());
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            out[i] = 0.5f * (out[i] + rows_.scratch[i]);
        }
    };
    middle(before_.emission, now_.emission, rows_.midEmission);
    middle(before_.extinction, now_.extinction, rows_.midExtinction);
}

/// The balance of the segments that end in `span` of row `c`.
template <bool kThick>
void DirectionSweep<kThick>::balance(int c, const RowSpan& span, bool keep) {
    const int n = span.to - span.from, stride = shape_.stride();
    const auto up = static_cast<std::size_t>(shape_.at(taps_.b + span.from, c + taps_.c));
    const auto at = static_cast<std::size_t>(shape_.at(span.from, c));
    taps_.linearRow(&before_.radiance[up], stride, n, rows_.radiance.data());
    taps_.linearRow(&before_.source[up], stride, n, rows_.source.data());
    taps_.linearRow(&before_.hold[up], stride, n, rows_.hold.data());
    taps_.linearRow(&before_.held[up], stride, n, rows_.held.data());
    const BalanceRow row{rows_.depth.data(), &now_.source[at],      &now_.hold[at],
                         &now_.held[at],     rows_.radiance.data(), rows_.source.data(),
                         rows_.hold.data(),  rows_.held.data()};
    balanceSegments(row, n, &now_.radiance[at], &now_.excess[at], &now_.exchange[at],
                    &now_.smooth[at], rows_.shares);
    if (!keep) return;
    const SegmentShares& shares = rows_.shares;
    for (std::size_t tap = 0; tap < 4; ++tap) {
        const std::size_t from = up + tap % 2 + tap / 2 * static_cast<std::size_t>(stride);
        const float part = taps_.linear[tap];
        float* __restrict excess = &before_.excess[from];
        float* __restrict exchange = &before_.exchange[from];
        const float *radiance = &before_.radiance[from], *source = &before_.source[from];
        const float* smooth = &before_.smooth[from];
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            excess[i] += part * (shares.nearUp[i] * (radiance[i] - source[i] + shares.slope[i]) -
                                 shares.along[i]);
            exchange[i] += part * (shares.nearUp[i] * smooth[i] + shares.exchange[i]);
        }
    }
}

/// Light that enters upwards at the ground, and through open sides beside a slice: where nodes are
/// not fed.
template <bool kThick>
void DirectionSweep<kThick>::setBoundaries(int slice, int c, const RowSpan& fed) {
    float* radiance = &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))];
    const bool ground = travel_.z > 0.0f && onGround(slice, c);
    const int row = axis_ == 2 ? c : axis_ == 1 ? slice : 0;
    const auto set = [&](int from, int to) {
        for (int b = from; b < to; ++b) {
            const int x = axis_ == 0 ? slice : b, y = axis_ == 0 ? b : row;
            radiance[b] = ground ? input_.groundRadiance[grid_.index(x, y, 0)] : inflow_;
        }
    };
    set(0, fed.empty() ? shape_.nb : fed.from);
    if (!fed.empty()) set(fed.to, shape_.nb);
}

template <bool kThick>
void DirectionSweep<kThick>::feed(int slice, bool keep) {
    for (int c = 0; c < shape_.nc; ++c) {
        const RowSpan fed = fedSpan(slice, c);
        setBoundaries(slice, c, fed);
        if (fed.empty()) continue;
        carry(c, fed);
        RowSpan span = spanAround(&LightSlice::filled, c).within(fed);
        if (span.empty()) continue;
        const RowSpan thick = kThick ? spanAround(&LightSlice::balanced, c).within(fed) : RowSpan{};
        span.include(thick);
        interpolate(c, span);
        const auto at = static_cast<std::size_t>(shape_.at(span.from, c));
        const SegmentRow row{&now_.extinction[at],       &now_.emission[at],
                             rows_.extinction.data(),    rows_.emission.data(),
                             rows_.midExtinction.data(), rows_.midEmission.data()};
        throughSegments(row, lengthM_, span.to - span.from, &now_.radiance[at], rows_.depth.data());
        if (!thick.empty()) balance(c, span, keep);
    }
}

template class DirectionSweep<false>;
template class DirectionSweep<true>;

}  // namespace neph
