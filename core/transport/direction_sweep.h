// direction_sweep.h: carries light along one direction, slice by slice.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/transport/segments.h"
#include "core/transport/slice.h"
#include "core/transport/sweep.h"

namespace neph {

/// One value of each active node.
struct DirectionValues {
    float* along = nullptr;       ///< the source function; the sweep leaves the radiance
    const float* even = nullptr;  ///< of thick levels: the even degrees of the source function
};

struct LightSlice {
    std::vector<float> radiance, emission, extinction;
    std::vector<RowSpan> filled;  ///< of each row, borders included: nodes with extinction
    // Of thick levels.
    std::vector<float> source, hold, held, smooth, excess, exchange;
    std::vector<RowSpan> balanced;
};

/// Rows of what a slice is fed with.
struct UpwindRows {
    std::vector<float> radiance, source, hold, held, emission, extinction, midEmission,
        midExtinction, scratch, depth;
    SegmentShares shares;
};

/// The sweep along one direction. `kThick` is as the level is. direction_sweep.cpp has the order of
/// the slices, direction_feed.cpp the way from one to the next.
template <bool kThick>
class DirectionSweep {
  public:
    DirectionSweep(const SweepInput& input, const LightDirection& direction,
                   const DirectionValues& values, SweptEnds& ends);
    void run();

  private:
    int sliceAt(int step) const {
        return travel_[axis_] > 0.0f ? step : grid_.nodes[axis_] - 1 - step;
    }
    std::size_t nodeAt(int slice, int c) const {
        return static_cast<std::size_t>(slice) * step_[static_cast<std::size_t>(axis_)] +
               static_cast<std::size_t>(c) * step_[static_cast<std::size_t>(axisC_)];
    }
    /// The horizontal plane of the ground is row 0 of a slice, or a slice of its own.
    bool onGround(int slice, int c) const { return axis_ == 2 ? slice == 0 : c == 0; }
    void prepare();
    void load(int slice, LightSlice& into) const;
    void enter(int slice);
    RowSpan fedSpan(int slice, int c) const;
    RowSpan spanAround(std::vector<RowSpan> LightSlice::*spans, int c) const;
    void feed(int slice, bool keep);
    void carry(int c, const RowSpan& fed);
    void interpolate(int c, const RowSpan& span);
    void balance(int c, const RowSpan& span, bool keep);
    void setBoundaries(int slice, int c, const RowSpan& fed);
    void advance(int step, bool keep);
    void collect(int slice);
    void collectBalance(int slice, LightSlice& from);
    void settle();

    const SweepInput& input_;
    const TransportLevel& level_;
    const TransportGrid& grid_;
    DirectionValues values_;
    SweptEnds& ends_;
    glm::vec3 travel_;
    float weight_;
    int axis_ = 0, axisB_ = 1, axisC_ = 2;
    std::array<std::size_t, 3> step_{};
    float lengthM_ = 0.0f, offsetB_ = 0.0f, offsetC_ = 0.0f, inflow_ = 0.0f;
    SliceShape shape_;
    SliceTaps taps_, midTaps_;
    LightSlice before_, now_;
    UpwindRows rows_;
};

}  // namespace neph
