// parallel.cpp: threads that take the next piece until none is left.
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace neph {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);  // between checks for cancellation

/// The threads that share one set of pieces. Of several failures the one of the lowest piece is
/// kept, so that the error does not depend on timing.
class Crew {
  public:
    Crew(std::size_t pieces, const Piece& work) : pieces_(pieces), work_(work) {}

    /// Takes pieces until none is left or one has failed.
    void labour(std::size_t worker, const Progress& progress) {
        for (std::size_t piece = next_++; piece < pieces_ && !stopped_; piece = next_++) {
            try {
                work_(piece, worker, progress);
            } catch (const Cancelled&) {
                if (!stopped_) fail(piece);  // otherwise it stops because another piece failed
            } catch (...) {
                fail(piece);
            }
            ++done_;
        }
    }
    /// On another thread: the progress callback belongs to the first, so this one only checks for a
    /// stop.
    void labourElsewhere(std::size_t worker) {
        labour(worker, [this](double) { return !stopped_; });
        const std::lock_guard lock(mutex_);
        ++finished_;
        ended_.notify_one();
    }
    /// Reports progress until `threads` threads have finished.
    void await(std::size_t threads, const Progress& progress) {
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, kLook, [&] { return finished_ == threads; })) {
            lock.unlock();
            report(progress);
            lock.lock();
        }
    }
    /// An exception from `progress` counts as a failure that precedes all others.
    bool report(const Progress& progress) {
        try {
            if (!stopped_ &&
                goOn(progress, static_cast<double>(done_) /
                                   static_cast<double>(std::max<std::size_t>(pieces_, 1)))) {
                return true;
            }
            if (!stopped_) throw Cancelled{};
        } catch (...) {
            fail(0);
        }
        return false;
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    /// Keeps the exception in flight, unless an earlier piece has failed.
    void fail(std::size_t piece) {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        if (failure_ && failedPiece_ <= piece) return;
        failure_ = std::current_exception();
        failedPiece_ = piece;
    }

    const std::size_t pieces_;
    const Piece& work_;
    std::atomic<std::size_t> next_{0}, done_{0};
    std::atomic<bool> stopped_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    std::size_t finished_ = 0;
    std::exception_ptr failure_;
    std::size_t failedPiece_ = 0;
};

}  // namespace

std::size_t workerCount(std::size_t most) {
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most);
}

void shareOut(std::size_t pieces, std::size_t workers, const Piece& work,
              const Progress& progress) {
    Crew crew(pieces, work);
    if (crew.report(progress)) {
        std::vector<std::jthread> threads;
        for (std::size_t worker = 1; worker < std::min(workers, pieces); ++worker) {
            threads.emplace_back([&crew, worker] { crew.labourElsewhere(worker); });
        }
        crew.labour(0, [&](double) { return crew.report(progress); });
        crew.await(threads.size(), progress);
    }
    // The jthreads have joined by now, so nothing refers to `crew` any more.
    crew.rethrow();
    if (!goOn(progress, 1.0)) throw Cancelled{};
}

}  // namespace neph
