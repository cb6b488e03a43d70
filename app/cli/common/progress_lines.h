// progress_lines.h: how far an export is, told to another program: one JSON object per line on
// stdout.
//
// {"done": 3, "of": 40, "seconds": 12.5, "file": "storm_0002.png"} after each image, and within
// long ones, at most twice a second, the same without the file and with "part", the share of the
// next image that is there. {"error": "..."} if it fails.
#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace neph {

class ProgressLines {
  public:
    /// Silent unless `wanted`.
    ProgressLines(bool wanted, std::size_t of) : wanted_(wanted), of_(of) {}

    void part(double share);
    void done(const std::filesystem::path& file);
    static void failed(const std::string& message);

  private:
    using Clock = std::chrono::steady_clock;

    bool wanted_ = false;
    std::size_t of_ = 1, done_ = 0;
    Clock::time_point start_ = Clock::now(), told_ = start_;
};

}  // namespace neph
