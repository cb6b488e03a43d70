// pass_timer.h: GPU time of each pass of a frame.
//
// Measured by timestamps in the command stream. With a software renderer the CPU's clock is used
// and the stream is finished at every mark: llvmpipe runs a compute pass at once, but writes a
// timestamp only when it executes the draw calls before it.
#pragma once
#include <epoxy/gl.h>

#include <chrono>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace neph::gl {

/// Marks the command stream between passes. While it is off it does nothing, so passes can always
/// call it. Needs the context in which it was created.
class PassTimer {
  public:
    PassTimer() = default;
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// Begins a frame; previous measurements are discarded.
    void start(bool on);
    /// Ends the current pass, if any, and begins another. `name` must outlive the timer, like a
    /// literal.
    void pass(std::string_view name);
    /// Ends the last pass and waits for the GPU. Returns name and milliseconds of each pass, in the
    /// order in which they first ran; passes of the same name are added up.
    std::vector<std::pair<std::string_view, double>> finish();

  private:
    void mark();
    std::vector<double> markMs() const;

    bool on_ = false;
    std::optional<bool> software_;                              // known after the first start(true)
    std::vector<std::chrono::steady_clock::time_point> clock_;  // marks of a software renderer
    std::vector<GLuint> queries_;  // marks of a GPU; reused in every frame
    std::size_t used_ = 0;
    std::vector<std::string_view> names_;
};

}  // namespace neph::gl
