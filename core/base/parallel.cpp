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

constexpr auto kLook = std::chrono::milliseconds(50);  // between looks at whether to stop

class Crew {
  public:
    Crew(std::size_t pieces, const Piece& work) : pieces_(pieces), work_(work) {}

    /// Takes pieces until none is left.
    void labour(std::size_t worker, const Progress& progress) {
        for (std::size_t piece = next_++; piece < pieces_ && !stopped_; piece = next_++) {
            try {
                work_(piece, worker, progress);
            } catch (const Cancelled&) {
                if (!stopped_) fail(piece);  // else it heeds the failure of another
            } catch (...) {
                fail(piece);
            }
            ++done_;
        }
    }
    void labourElsewhere(std::size_t worker) {
        labour(worker, [this](double) { return !stopped_; });
        const std::lock_guard lock(mutex_);
        ++finished_;
        ended_.notify_one();
    }
    /// Reports until `threads` have finished.
    void await(std::size_t threads, const Progress& progress) {
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, kLook, [&] { return finished_ == threads; })) {
            lock.unlock();
            report(progress);
            lock.lock();
        }
    }
    /// What `progress` throws counts as a failure that comes before all others.
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
    crew.rethrow();
    if (!goOn(progress, 1.0)) throw Cancelled{};
}

}  // namespace neph
