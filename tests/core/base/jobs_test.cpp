// jobs_test.cpp: what runs on which thread, what is cancelled, and how failures come back.
#include "core/base/jobs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace neph;

namespace {

using namespace std::chrono_literals;

/// Polls until `done`; false after ten seconds.
bool pollUntil(Jobs& jobs, const auto& done) {
    for (int i = 0; i < 10000 && !done(); ++i) {
        jobs.poll();
        std::this_thread::sleep_for(1ms);
    }
    return done();
}

/// Works until it is told to stop.
Jobs::Finish workForever(const Progress& progress) {
    while (goOn(progress, 0.5)) std::this_thread::sleep_for(1ms);
    throw Cancelled{};
}

}  // namespace

TEST_CASE("A job works on another thread and finishes on the one that polls") {
    Jobs jobs;
    const auto here = std::this_thread::get_id();
    std::thread::id worked, finished;
    jobs.start("Working",
               [&](const Progress& progress) {
                   goOn(progress, 0.5);
                   worked = std::this_thread::get_id();
                   return [&] { finished = std::this_thread::get_id(); };
               },
               {});
    CHECK(jobs.busy());
    CHECK(jobs.label() == "Working");
    REQUIRE(pollUntil(jobs, [&] { return finished != std::thread::id{}; }));
    CHECK(finished == here);
    CHECK(worked != here);
    CHECK_FALSE(jobs.busy());
}

TEST_CASE("The newest job wins: what it replaces never finishes") {
    Jobs jobs;
    int last = 0, finished = 0;
    jobs.start("endless", workForever, {});
    for (int i = 1; i <= 20; ++i) {
        jobs.start("short",
                   [&, i](const Progress&) {
                       return [&, i] {
                           last = i;
                           ++finished;
                       };
                   },
                   {});
    }
    REQUIRE(pollUntil(jobs, [&] { return last == 20; }));
    CHECK(finished == 1);
}

TEST_CASE("A failed job tells its reason on the thread that polls") {
    Jobs jobs;
    std::string reason;
    const auto keep = [&](const Error& error) { reason = error.message(); };
    jobs.start(
        "bad",
        [](const Progress&) -> Jobs::Finish {
            throw Error({"file", "is bad", "", "", ""});
        },
        keep);
    REQUIRE(pollUntil(jobs, [&] { return !reason.empty(); }));
    CHECK(reason == "file: is bad");

    reason.clear();
    jobs.start(
        "worse", [](const Progress&) -> Jobs::Finish { throw std::runtime_error("oh"); }, keep);
    REQUIRE(pollUntil(jobs, [&] { return !reason.empty(); }));
    CHECK(reason.find("oh") != std::string::npos);

    reason.clear();
    jobs.start(
        "huge", [](const Progress&) -> Jobs::Finish { throw std::bad_alloc(); }, keep);
    REQUIRE(pollUntil(jobs, [&] { return !reason.empty(); }));
    CHECK(reason.find("memory") != std::string::npos);
}

TEST_CASE("A cancelled job neither finishes nor fails") {
    Jobs jobs;
    std::atomic<bool> begun = false;
    bool told = false;
    jobs.start(
        "endless",
        [&](const Progress& progress) {
            begun = true;
            return workForever(progress);
        },
        [&](const Error&) { told = true; });
    while (!begun) std::this_thread::sleep_for(1ms);
    jobs.cancel();
    CHECK_FALSE(jobs.busy());
    for (int i = 0; i < 20; ++i) {
        std::this_thread::sleep_for(1ms);
        CHECK_FALSE(jobs.poll());
    }
    CHECK_FALSE(told);
}

TEST_CASE("Progress is seen while the job runs") {
    Jobs jobs;
    jobs.start("endless", workForever, {});
    REQUIRE(pollUntil(jobs, [&] { return jobs.fraction() == 0.5; }));
}

TEST_CASE("A result wakes whoever waits for it") {
    std::atomic<int> woken = 0;
    Jobs jobs([&] { ++woken; });
    jobs.start("short", [](const Progress&) { return [] {}; }, {});
    for (int i = 0; i < 10000 && woken == 0; ++i) std::this_thread::sleep_for(1ms);
    CHECK(woken == 1);
    CHECK(jobs.poll());
}

TEST_CASE("Work ahead of time is not busy until it is wanted, and yields to what is") {
    Jobs jobs;
    jobs.start("ahead", workForever, {}, Jobs::Kind::ahead);
    CHECK_FALSE(jobs.busy());
    CHECK_FALSE(jobs.idle());
    jobs.want();
    CHECK(jobs.busy());
    bool done = false;
    jobs.start("asked for", [&](const Progress&) { return [&] { done = true; }; }, {});
    REQUIRE(pollUntil(jobs, [&] { return done; }));
    REQUIRE(pollUntil(jobs, [&] { return jobs.idle(); }));
}

TEST_CASE("Jobs end with a job running, waiting or unread") {
    for (int round = 0; round < 20; ++round) {
        Jobs jobs;
        jobs.start("endless", workForever, {});
        if (round % 2 == 0) std::this_thread::sleep_for(1ms);
        jobs.start("short", [](const Progress&) { return [] {}; }, {});
    }
}
