// jobs.h: one background worker for what takes longer than a frame: opening and resampling.
//
// The newest job wins: starting one cancels the one that runs or waits. A job runs on the worker
// and returns a closure, which `poll` runs on the calling thread; nothing else crosses between
// threads. Work that nobody waits for yet, such as reading ahead, does not count as busy.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace neph {

/// The worker and its one job.
class Jobs {
  public:
    using Finish = std::function<void()>;
    using Work = std::function<Finish(const Progress&)>;
    using Failed = std::function<void(const Error&)>;

    /// Whether somebody waits for the result, or it is read ahead.
    enum class Kind { wanted, ahead };

    /// `wake`, if given, is called on the worker when a result is ready to be polled.
    explicit Jobs(std::function<void()> wake = {});
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// `work` runs on the worker; the closure it returns, or `failed` with what it threw, runs in a
    /// later poll(). A cancelled job runs neither.
    void start(std::string label, Work work, Failed failed, Kind kind = Kind::wanted);
    /// Drops a waiting or finished job, and asks a running one to stop.
    void cancel();
    /// Marks the current job as wanted, for example when the user asks for what was read ahead.
    void want();

    /// Runs the closure of a finished job; true if there was one.
    bool poll();

    bool busy() const;        ///< a wanted job runs, waits, or has a result to poll
    bool idle() const;        ///< no job is waiting, running or finished, wanted or not
    double fraction() const;  ///< of the running job, in [0, 1]
    /// Label of the current job, for the status line; empty if there is none.
    std::string label() const;

  private:
    struct Job;
    void runWorker(const std::stop_token& stop);
    void run(Job& job);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::shared_ptr<Job> waiting_, running_, finished_;
    std::jthread worker_;  // last, so that it ends before the members it uses
};

}  // namespace neph
