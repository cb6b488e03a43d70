// export_job.h: an export that runs beside the window: the program itself, started as `nephoscope
// render --progress`, and what its lines tell.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/child_process.h"

namespace neph {

class ExportJob {
  public:
    enum class State { running, done, failed, cancelled };

    /// Starts `program` with `arguments`, at low priority. Throws Error.
    ExportJob(const std::filesystem::path& program, const std::vector<std::string>& arguments);

    /// Takes in what it said; to be called now and then.
    State poll();
    /// Asks it to stop; it leaves no half file.
    void cancel();

    State state() const { return state_; }
    /// Share that is there, 0 to 1.
    double fraction() const;
    /// "12 of 40 pictures, 1 min 20 s left".
    std::string text() const;
    /// The picture or film that was written last; empty before.
    const std::filesystem::path& file() const { return file_; }
    int done() const { return done_; }
    /// Why it failed, in the program's own words.
    std::string fault() const;

  private:
    void take(const std::string& line);

    ChildProcess child_;
    State state_ = State::running;
    bool cancelling_ = false;
    int done_ = 0, of_ = 0;  // 0: not yet told
    double part_ = 0.0;      // of the next picture
    double seconds_ = 0.0;   // that it took so far
    std::filesystem::path file_;
};

/// "45 s", "1 min 20 s", "2 h 5 min".
std::string durationText(double seconds);

}  // namespace neph
