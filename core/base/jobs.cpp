// jobs.cpp: the loop of the worker, and the three places where a job can be: waiting, running,
// finished.
#include "core/base/jobs.h"

#include <atomic>
#include <exception>
#include <new>

namespace neph {

/// Shared by the worker and the main thread; `fraction` and `cancelled` are all that both use while
/// the work runs.
struct Jobs::Job {
    std::string label;
    Kind kind;
    Work work;
    Failed failed;
    Finish finish;
    std::atomic<double> fraction{0.0};
    std::atomic<bool> cancelled{false};
};

namespace {

/// Any failure as an Error, so that the main thread has one type to show.
Error toError(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return Error({"", "there is not enough memory for this data", "", "",
                      "open fewer or smaller files"});
    } catch (const std::exception& other) {
        return Error({"", "the work failed", other.what(), "", ""});
    }
}

}  // namespace

Jobs::Jobs(std::function<void()> wake)
    : wake_(std::move(wake)), worker_([this](const std::stop_token& stop) { runWorker(stop); }) {}

Jobs::~Jobs() {
    cancel();
    worker_.request_stop();
    changed_.notify_all();
}

/// Cancelling first keeps the rule that the newest job wins.
void Jobs::start(std::string label, Work work, Failed failed, Kind kind) {
    auto job = std::make_shared<Job>();
    job->label = std::move(label);
    job->kind = kind;
    job->work = std::move(work);
    job->failed = std::move(failed);
    cancel();
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(job);
    changed_.notify_all();
}

void Jobs::cancel() {
    // Dropped jobs are destroyed outside the lock: their closures may own data sets.
    std::shared_ptr<Job> dropped[2];
    const std::lock_guard lock(mutex_);
    dropped[0].swap(waiting_);
    dropped[1].swap(finished_);
    if (running_) running_->cancelled = true;
}

bool Jobs::poll() {
    std::shared_ptr<Job> job;
    {
        const std::lock_guard lock(mutex_);
        job.swap(finished_);
    }
    if (!job || !job->finish) return false;
    job->finish();
    return true;
}

void Jobs::want() {
    const std::lock_guard lock(mutex_);
    for (const auto& job : {waiting_, running_, finished_}) {
        if (job) job->kind = Kind::wanted;
    }
}

bool Jobs::busy() const {
    const std::lock_guard lock(mutex_);
    const auto wanted = [](const std::shared_ptr<Job>& job) {
        return job && !job->cancelled && job->kind == Kind::wanted;
    };
    return wanted(waiting_) || wanted(finished_) || wanted(running_);
}

bool Jobs::idle() const {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !finished_ && !running_;
}

double Jobs::fraction() const {
    const std::lock_guard lock(mutex_);
    return running_ ? running_->fraction.load() : (finished_ ? 1.0 : 0.0);
}

std::string Jobs::label() const {
    const std::lock_guard lock(mutex_);
    const std::shared_ptr<Job>& job = waiting_ ? waiting_ : (running_ ? running_ : finished_);
    return job ? job->label : std::string();
}

/// The job runs without the lock, so that poll() and cancel() never wait for it.
void Jobs::runWorker(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::shared_ptr<Job> job;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [this] { return waiting_ != nullptr; });
            job.swap(waiting_);
            running_ = job;
        }
        if (!job) continue;
        run(*job);
        const bool result = !job->cancelled;
        {
            const std::lock_guard lock(mutex_);
            running_.reset();
            if (!job->cancelled) finished_ = std::move(job);
        }
        if (result && wake_) wake_();
    }
}

/// Runs the work without letting any exception escape the worker. The work is destroyed here,
/// because it may own data that should not wait for poll().
void Jobs::run(Job& job) {
    const Progress progress = [&job](double fraction) {
        job.fraction = fraction;
        return !job.cancelled;
    };
    try {
        job.finish = job.work(progress);
    } catch (const Cancelled&) {
        job.cancelled = true;
    } catch (...) {
        const Error error = toError(std::current_exception());
        job.finish = [failed = job.failed, error] {
            if (failed) failed(error);
        };
    }
    job.work = nullptr;
}

}  // namespace neph
