// moment_lanes.h: moments of many nodes, laid out so that one instruction serves several nodes.
#pragma once
#include <cstddef>
#include <cstring>
#include <vector>

namespace neph {

/// `count` moments of each of `nodes` nodes, in groups of kLanes nodes: those of one moment side by
/// side.
class MomentLanes {
  public:
    static constexpr std::size_t kLanes = 8;

    MomentLanes(std::size_t nodes, std::size_t count)
        : count_(count), values_(groupsOf(nodes) * count * kLanes, 0.0f) {}

    static std::size_t groupsOf(std::size_t nodes) { return (nodes + kLanes - 1) / kLanes; }
    float* group(std::size_t group) { return &values_[group * count_ * kLanes]; }
    const float* group(std::size_t group) const { return &values_[group * count_ * kLanes]; }
    float* at(std::size_t node) { return group(node / kLanes) + node % kLanes; }
    const float* at(std::size_t node) const { return group(node / kLanes) + node % kLanes; }

  private:
    std::size_t count_;
    std::vector<float> values_;
};

/// Of one moment, of a group of nodes.
using Lanes [[gnu::vector_size(MomentLanes::kLanes * sizeof(float))]] = float;

/// along[node] = the sum over q of moment q times weights[q], of the nodes of `groups` groups from
/// the one at `moments` on.
template <std::size_t kCount>
void sumMoments(const float* __restrict moments, std::size_t groups,
                const float* __restrict weights, float* __restrict along) {
    for (std::size_t group = 0; group < groups; ++group, along += MomentLanes::kLanes) {
        Lanes sum{};
        for (std::size_t q = 0; q < kCount; ++q, moments += MomentLanes::kLanes) {
            Lanes moment;
            std::memcpy(&moment, moments, sizeof moment);
            sum += weights[q] * moment;
        }
        std::memcpy(along, &sum, sizeof sum);
    }
}

/// The other way: adds along[node] times weights[q] to moment q.
template <std::size_t kCount>
void addMoments(const float* __restrict along, std::size_t groups, const float* __restrict weights,
                float* __restrict moments) {
    for (std::size_t group = 0; group < groups; ++group, along += MomentLanes::kLanes) {
        Lanes value;
        std::memcpy(&value, along, sizeof value);
        for (std::size_t q = 0; q < kCount; ++q, moments += MomentLanes::kLanes) {
            Lanes moment;
            std::memcpy(&moment, moments, sizeof moment);
            moment += weights[q] * value;
            std::memcpy(moments, &moment, sizeof moment);
        }
    }
}

}  // namespace neph
