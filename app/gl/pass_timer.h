// pass_timer.h: how long each pass of a frame took on the GPU.
//
// By timestamps in the command stream. Where the CPU stands in for a GPU, by its clock, with the
// stream emptied at every mark: llvmpipe runs a compute pass at once, but writes a timestamp only
// when it draws what was drawn before it.
#pragma once
#include <epoxy/gl.h>

#include <chrono>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace neph::gl {

/// Marks the command stream between passes. Does nothing while it is off, so that passes call it
/// always. Needs the context that made it.
class PassTimer {
  public:
    PassTimer() = default;
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// Opens a frame; what was measured before is dropped.
    void start(bool on);
    /// Ends the pass before, if any, and opens one; `name` is a literal.
    void pass(std::string_view name);
    /// Ends the last pass and waits for the GPU: name and milliseconds of each pass, those of one
    /// name added together, in the order in which they first ran.
    std::vector<std::pair<std::string_view, double>> finish();

  private:
    void mark();
    std::vector<double> markMs() const;

    bool on_ = false;
    std::optional<bool> software_;  // once asked
    std::vector<std::chrono::steady_clock::time_point> clock_;
    std::vector<GLuint> queries_;  // kept from frame to frame
    std::size_t used_ = 0;
    std::vector<std::string_view> names_;
};

}  // namespace neph::gl
