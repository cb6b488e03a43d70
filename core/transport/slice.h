// slice.h: one slice of nodes across the axis of a sweep, with a border that interpolation may
// read, and interpolation in it.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/transport/row_span.h"

namespace neph {

inline constexpr int kSliceBorder = 2;

/// Values at b + (c * stride), with kSliceBorder more on each side.
struct SliceShape {
    int nb = 0, nc = 0;
    bool periodicB = false, periodicC = false;

    int stride() const { return nb + 2 * kSliceBorder; }
    std::size_t size() const {
        return static_cast<std::size_t>(stride() * (nc + 2 * kSliceBorder));
    }
    int at(int b, int c) const { return (c + kSliceBorder) * stride() + b + kSliceBorder; }

    /// Adds what was added to the border between periodic sides to the nodes that it repeats.
    void foldBorder(std::vector<float>& values) const {
        for (int c = -kSliceBorder; c < nc + kSliceBorder; ++c) {
            for (int b = -kSliceBorder; b < nb + kSliceBorder; ++b) {
                const bool besideB = b < 0 || b >= nb, besideC = c < 0 || c >= nc;
                if (!besideB && !besideC) continue;
                float& value = values[static_cast<std::size_t>(at(b, c))];
                if ((!besideB || periodicB) && (!besideC || periodicC)) {
                    const int inB = (b + kSliceBorder * nb) % nb,
                              inC = (c + kSliceBorder * nc) % nc;
                    values[static_cast<std::size_t>(at(inB, inC))] += value;
                }
                value = 0.0f;
            }
        }
    }

    /// Repeats the values at the edges, or those opposite where a side is periodic.
    void fillBorder(std::vector<float>& values) const {
        const auto inside = [](int i, int n, bool periodic) {
            return periodic ? (i + kSliceBorder * n) % n : std::clamp(i, 0, n - 1);
        };
        float* v = values.data();
        for (int c = 0; c < nc; ++c) {
            for (int i = 1; i <= kSliceBorder; ++i) {
                v[at(-i, c)] = v[at(inside(-i, nb, periodicB), c)];
                v[at(nb - 1 + i, c)] = v[at(inside(nb - 1 + i, nb, periodicB), c)];
            }
        }
        for (int i = 1; i <= kSliceBorder; ++i) {
            for (const int c : {-i, nc - 1 + i}) {
                const float* from = &v[at(-kSliceBorder, inside(c, nc, periodicC))];
                std::copy_n(from, stride(), &v[at(-kSliceBorder, c)]);
            }
        }
    }
};

/// Interpolation at a fixed offset, of at most one node each way, from every node of a slice.
struct SliceTaps {
    int b = 0, c = 0;  ///< the lower of the two nodes on each axis, relative
    std::array<float, 4> linear{}, cubicB{}, cubicC{};

    SliceTaps() = default;
    SliceTaps(float offsetB, float offsetC) {
        b = std::min(static_cast<int>(std::floor(offsetB)), 0);
        c = std::min(static_cast<int>(std::floor(offsetC)), 0);
        const float u = offsetB - static_cast<float>(b), v = offsetC - static_cast<float>(c);
        linear = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
        cubicB = cubicAt(u);
        cubicC = cubicAt(v);
    }
    /// Lagrange's, through the nodes -1, 0, 1 and 2.
    static std::array<float, 4> cubicAt(float t) {
        return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2,
                -(t + 1) * t * (t - 2) / 2, (t + 1) * t * (t - 1) / 6};
    }
    /// `row` is the lower left tap of the first of `n` nodes.
    void linearRow(const float* __restrict row, int stride, int n, float* __restrict out) const {
        const float* next = row + stride;
        const auto [w0, w1, w2, w3] = linear;
        for (int i = 0; i < n; ++i) {
            out[i] = w0 * row[i] + w1 * row[i + 1] + w2 * next[i] + w3 * next[i + 1];
        }
    }
    /// The same by cubics, kept within the four nearest values.
    void cubicRow(const float* __restrict row, int stride, int n, float* __restrict out) const {
        for (int i = 0; i < n; ++i) {
            const float* p = row + i;
            float sum = 0.0f;
            for (int y = -1; y <= 2; ++y) {
                const float* q = p + y * stride;
                sum += cubicC[static_cast<std::size_t>(y + 1)] *
                       (cubicB[0] * q[-1] + cubicB[1] * q[0] + cubicB[2] * q[1] + cubicB[3] * q[2]);
            }
            const float low = std::min(std::min(p[0], p[1]), std::min(p[stride], p[stride + 1]));
            const float high = std::max(std::max(p[0], p[1]), std::max(p[stride], p[stride + 1]));
            out[i] = std::min(std::max(sum, low), high);
        }
    }
};

/// exp(-t) for t >= 0, to 3e-6 of its value, in a form that compilers turn into vector code.
inline float decayOf(float t) {
    const float y = std::min(t * 1.44269504f, 120.0f);
    const int whole = static_cast<int>(y);
    const float x = (static_cast<float>(whole) - y) * 0.693147181f;
    float series = 1.0f + x / 7.0f;
    for (const float inverse : {1.0f / 6, 1.0f / 5, 1.0f / 4, 1.0f / 3, 1.0f / 2, 1.0f}) {
        series = 1.0f + x * inverse * series;
    }
    return series * std::bit_cast<float>((127 - whole) << 23);
}

/// (1 - exp(-t)) / t, where `decay` is exp(-t).
inline float meanDecay(float t, float decay) {
    constexpr float kSmall = 0.02f;
    const float series = 1.0f - t * (0.5f - t * (1.0f / 6 - t * (1.0f / 24)));
    return t < kSmall ? series : (1.0f - decay) / std::max(t, kSmall);
}

/// Radiance behind a piece of optical depth t whose source runs linearly from s0 to s1.
inline float throughPiece(float radiance, float s0, float s1, float t) {
    const float e = decayOf(t), g = meanDecay(t, e);
    return radiance * e + s0 * (g - e) + s1 * (1.0f - g);
}

}  // namespace neph
