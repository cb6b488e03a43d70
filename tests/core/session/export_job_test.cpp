// export_job_test.cpp: exports that scripts of the shell pretend to do.
#include <doctest/doctest.h>

#include <thread>

#include "core/session/export_job.h"
#include "tests/text.h"

using namespace neph;

namespace {

ExportJob pretend(const std::string& script) {
    return ExportJob("/bin/sh", {"-c", script});
}

ExportJob::State ended(ExportJob& job) {
    while (job.poll() == ExportJob::State::running) std::this_thread::yield();
    return job.state();
}

}  // namespace

TEST_CASE("An export tells how many images are there and how long the others will take") {
    ExportJob job = pretend(
        "echo 'not ours'; echo '{\"done\": 12, \"of\": 40, \"seconds\": 60, \"file\": \"a.png\"}'; "
        "while :; do sleep 0.01; done");
    CHECK(job.text() == "Preparing");
    while (job.done() == 0) job.poll();
    // 28 images of 5 s each.
    CHECK(job.text() == "12 of 40 images, 2 min 20 s left");
    CHECK(job.fraction() == doctest::Approx(0.3));
    CHECK(job.file() == "a.png");
    job.cancel();
    CHECK(job.text() == "Stopping");
    CHECK(ended(job) == ExportJob::State::cancelled);
}

TEST_CASE("Of a single image the share tells") {
    ExportJob job =
        pretend("echo '{\"done\": 0, \"of\": 1, \"seconds\": 30, \"part\": 0.25}'; sleep 0.3");
    while (job.fraction() == 0.0) job.poll();
    CHECK(job.text() == "25 %, 1 min 30 s left");
    CHECK(ended(job) == ExportJob::State::done);
}

TEST_CASE("An export that fails is told in its own words, without the notes before") {
    ExportJob job = pretend(
        "echo 'note: a b' >&2; echo '{\"error\": \"the disk is full\"}'; echo 'error: the disk is "
        "full' >&2; exit 1");
    CHECK(ended(job) == ExportJob::State::failed);
    CHECK(job.fault() == "the disk is full");
    ExportJob wordy = pretend("echo 'no JSON yet' >&2; exit 1");
    CHECK(ended(wordy) == ExportJob::State::failed);
    CHECK(wordy.fault() == "no JSON yet");
    ExportJob crashed = pretend("kill -SEGV $$");
    CHECK(ended(crashed) == ExportJob::State::failed);
    CHECK(contains(crashed.fault(), "139"));
}

TEST_CASE("What it says may be wrong in any way") {
    ExportJob job = pretend(
        "echo '{'; echo '[1]'; echo '{\"done\": \"x\", \"of\": -3, \"part\": 1e300}'; "
        "echo '{\"done\": 1e99, \"of\": 2, \"seconds\": null, \"file\": 3}'");
    CHECK(ended(job) == ExportJob::State::done);
    CHECK(job.fraction() == 1.0);
    CHECK(job.file().empty());
}

TEST_CASE("Durations are told in the two largest units") {
    CHECK(durationText(0.2) == "0 s");
    CHECK(durationText(59.4) == "59 s");
    CHECK(durationText(80.0) == "1 min 20 s");
    CHECK(durationText(7500.0) == "2 h 5 min");
}
