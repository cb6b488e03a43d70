// jobs.h: one background worker for what takes longer than a frame: opening and resampling.
//
// The newest job wins: starting one cancels what runs or waits. A job runs on the worker and hands
// back a closure, which `poll` runs on the calling thread; nothing else crosses between threads.
// Work that nobody waits for yet, such as reading ahead, is not counted as busy.
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

class Jobs {
  public:
    using Finish = std::function<void()>;
    using Work = std::function<Finish(const Progress&)>;
    using Failed = std::function<void(const Error&)>;

    enum class Kind { wanted, ahead };

    /// `wake`, where given, is called on the worker when a result waits to be polled.
    explicit Jobs(std::function<void()> wake = {});
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// `work` runs on the worker; the closure it returns, or `failed` with what it threw, runs in a
    /// later poll(). A cancelled job runs neither.
    void start(std::string label, Work work, Failed failed, Kind kind = Kind::wanted);
    void cancel();
    /// What is under way is wanted from now on.
    void want();

    /// Runs what has come in; true when anything did.
    bool poll();

    bool busy() const;        ///< a wanted job runs, waits or has a result to be polled
    bool idle() const;        ///< nothing is under way, wanted or not
    double fraction() const;  ///< of the running job, in [0, 1]
    std::string label() const;

  private:
    struct Job;
    void runWorker(const std::stop_token& stop);
    void run(Job& job);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::shared_ptr<Job> waiting_, running_, finished_;
    std::jthread worker_;  // last, so that it ends before what it uses
};

}  // namespace neph
