// export_job.h: an export that runs in the background: the program itself, started as `nephoscope
// render --progress`, and the progress that it prints.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/child_process.h"

namespace neph {

/// One export in progress.
class ExportJob {
  public:
    enum class State { running, done, failed, cancelled };

    /// Starts `program` with `arguments`, at low priority. Throws Error.
    ExportJob(const std::filesystem::path& program, const std::vector<std::string>& arguments);

    /// Reads its progress; call regularly.
    State poll();
    /// Asks it to stop; it leaves no incomplete file.
    void cancel();

    /// Lets it go on when this program ends, and has `session`, which it reads, removed when it is
    /// done. Throws Error.
    void letGo(const std::filesystem::path& session) { child_.letGo(session); }

    State state() const { return state_; }
    /// Completed fraction, 0 to 1.
    double fraction() const;
    /// "12 of 40 images, 1 min 20 s left".
    std::string text() const;
    /// The image or video that was written last; empty before the first.
    const std::filesystem::path& file() const { return file_; }
    int done() const { return done_; }
    /// Why it failed, as the program reported it.
    std::string fault() const;

  private:
    void take(const std::string& line);

    ChildProcess child_;
    State state_ = State::running;
    bool cancelling_ = false;
    int done_ = 0, of_ = 0;  // 0: not yet known
    double part_ = 0.0;      // of the next image
    double seconds_ = 0.0;   // elapsed so far
    std::filesystem::path file_;
    std::string error_;  // why it failed; empty: not reported
};

/// "45 s", "1 min 20 s", "2 h 5 min".
std::string durationText(double seconds);

}  // namespace neph
