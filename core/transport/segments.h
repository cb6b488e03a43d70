// segments.h: what happens along the segments that end in the nodes of a row.
#pragma once
#include "core/transport/slice.h"

namespace neph {

inline constexpr float kNoDepth = 1e-6f;

/// The ends and middles of the segments, from the first of the row on.
struct SegmentRow {
    const float *extinction, *emission;        ///< at nodes
    const float *upExtinction, *upEmission;    ///< upwind
    const float *midExtinction, *midEmission;  ///< between
};

/// Two pieces with linear sources. `radiance` is that upwind, and becomes that of the nodes. The
/// source is interpolated as emission, extinction times source function: where there is no
/// extinction a source function is not defined. Depths are Simpson's.
inline void throughSegments(const SegmentRow& row, float lengthM, int n, float* __restrict radiance,
                            float* __restrict depths) {
    constexpr float kNone = 1e-30f, kLeast = 0.02f;
    const float* __restrict extinction = row.extinction;
    const float* __restrict emission = row.emission;
    const float* __restrict upExtinction = row.upExtinction;
    const float* __restrict upEmission = row.upEmission;
    const float* __restrict midExtinction = row.midExtinction;
    const float* __restrict midEmission = row.midEmission;
    for (int i = 0; i < n; ++i) {
        const float up = upExtinction[i], mid = midExtinction[i], at = extinction[i];
        const float depth = lengthM / 6.0f * (up + 4.0f * mid + at);
        const float half = lengthM / 24.0f * (5.0f * up + 8.0f * mid - at);
        const float first = std::min(std::max(half, kLeast * depth), (1.0f - kLeast) * depth);
        const float midSource = midEmission[i] / std::max(mid, kNone);
        const float upRatio = upEmission[i] / std::max(up, kNone);
        const float atRatio = emission[i] / std::max(at, kNone);
        const float upSource = up > kNone ? upRatio : midSource;
        const float atSource = at > kNone ? atRatio : midSource;
        const float between = throughPiece(radiance[i], upSource, midSource, first);
        radiance[i] = throughPiece(between, midSource, atSource, depth - first);
        depths[i] = depth;
    }
}

/// From 0 for thin segments to 1 for thick ones, of scaled optical depth t.
inline float holdOf(float t) {
    constexpr float kFrom = 0.5f, kWhole = 2.0f;
    const float x = std::min(std::max((t - kFrom) / (kWhole - kFrom), 0.0f), 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

/// What balanced segments need beside the above. `hold` is of the depth that a segment has by the
/// mean extinction around a node, `held` that times the part of the source that is the same in the
/// opposite direction.
struct BalanceRow {
    const float *depth, *source, *hold, *held;             ///< the last three at nodes
    const float *upRadiance, *upSource, *upHold, *upHeld;  ///< bilinear between nodes upwind
};

/// What balanced segments leave to the four nodes upwind.
struct SegmentShares {
    std::vector<float> nearUp, slope, along, exchange;
    explicit SegmentShares(std::size_t n = 0) : nearUp(n), slope(n), along(n), exchange(n) {}
};

/// Turns `radiance`, from thin segments, towards that of thick ones, and shares the excess of
/// radiance over source along each segment between its ends: `excess` for the nodes here, `shares`
/// for those upwind. Half the difference of the sources is left out where both ends are thick: it
/// comes back from the opposite direction, but for what interpolation would spread sideways.
/// docs/transport.md
inline void balanceSegments(const BalanceRow& row, int n, float* __restrict radiance,
                            float* __restrict excess, float* __restrict exchange,
                            float* __restrict smooth, SegmentShares& shares) {
    const float *depth = row.depth, *source = row.source, *hold = row.hold, *held = row.held;
    const float *upRadiance = row.upRadiance, *upSource = row.upSource;
    const float *upHold = row.upHold, *upHeld = row.upHeld;
    float* __restrict nearUp = shares.nearUp.data();
    float* __restrict slopes = shares.slope.data();
    float* __restrict along = shares.along.data();
    float* __restrict exchangeUp = shares.exchange.data();
    for (int i = 0; i < n; ++i) {
        constexpr float kSmall = 0.02f;
        const float t = depth[i], safe = std::max(t, kNoDepth), some = t > kNoDepth ? 1.0f : 0.0f;
        const float e = decayOf(t), g = meanDecay(t, e);
        const float up = upSource[i], rise = source[i] - up;
        const float thick = upRadiance[i] * e + up * (g - e) + source[i] * (1.0f - g);
        const float value = radiance[i] + holdOf(t) * (thick - radiance[i]);
        const float series = t * (0.5f - t * (1.0f / 3 - t * (1.0f / 8)));
        const float nearAt = t < kSmall ? series : g - e;
        const float part = t * g - nearAt, slope = rise / safe, both = hold[i] * upHold[i];
        const float leftOut = held[i] * upHold[i] - hold[i] * upHeld[i];
        const float half = 0.5f * (rise - leftOut), opened = 0.5f * (1.0f - both);
        radiance[i] = value;
        smooth[i] = g;
        excess[i] =
            some * (upRadiance[i] - value + rise - part * (upRadiance[i] - up + slope) - half);
        exchange[i] = some * opened;
        nearUp[i] = some * part;
        slopes[i] = slope;
        along[i] = some * half;
        exchangeUp[i] = some * (std::min(0.5f, part / safe) + opened);
    }
}

}  // namespace neph
